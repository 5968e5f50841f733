#pragma once

#include "core/document/session.h"
#include "wasm/app/view_context.h"
#include "wasm/render/scene.h"
#include "wasm/views/viewport/body_arrows.h"
#include "wasm/views/viewport/joint_labels.h"
#include "wasm/views/viewport/segment_solids.h"
#include "wasm/views/viewport/strobe.h"
#include "wasm/views/viewport/trails.h"
#include "wasm/views/viewport/viewport_state.h"

namespace marey::app {

/// The 3D view: builds the scene that the renderer draws beneath the window, takes the pointer, draws labels, gizmo,
/// buttons and scale over it. Drawn into the rest of the current window, which has no ground of its own.
class ViewportView {
 public:
  void draw(ViewContext& context, Scene& scene);

  /// Call when another document has been opened: the camera finds a good place for it.
  void document_opened() { state_.wants_opening_view = true; }

  /// Registers the commands that move the camera. All arguments outlive the registry.
  void add_commands(CommandRegistry& registry, const Session& session);

  /// For tests.
  [[nodiscard]] const ViewportState& state() const { return state_; }

 private:
  void build_scene(const ViewContext& context, Scene& scene);

  ViewportState state_;
  BodyArrows arrows_;
  SegmentSolids solids_;
  Strobe strobe_;
  Trails trails_;
  JointLabels labels_;
};

}  // namespace marey::app
