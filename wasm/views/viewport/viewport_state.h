#pragma once

#include <glm/vec2.hpp>
#include <imgui.h>

#include <optional>
#include <vector>

#include "wasm/app/camera.h"
#include "wasm/app/picking.h"
#include "wasm/views/viewport/figure_cache.h"

namespace marey::app {

/// What a command asks of the camera; done in the next frame, when the size of the view is known.
struct CameraRequest {
  enum class Framing { None, Selection, All };
  Framing framing = Framing::None;
  /// Direction to look from; unset angles stay.
  std::optional<double> yaw_rad;
  std::optional<double> pitch_rad;
  double zoom = 1.0;  ///< factor of what is seen; < 1 comes closer
};

enum class ViewDrag { None, Waiting, Orbit, Pan };

/// What the parts of the viewport share from frame to frame.
struct ViewportState {
  Camera camera;
  FigureCache figure;
  CameraRequest request;
  bool wants_opening_view = true;  ///< a clip was opened and has not been looked at yet

  /// Of this frame.
  CameraView view;
  ImVec2 corner;  ///< top left of the view on the screen
  std::vector<PickSolid> solids;

  ViewDrag drag = ViewDrag::None;
  ImGuiMouseButton drag_button = ImGuiMouseButton_Left;

  std::uint64_t seen_figure_serial = 0;
  std::optional<glm::dvec3> followed;  ///< where the followed point was; unset while not following

  [[nodiscard]] ImVec2 to_screen(const glm::dvec2& in_view) const {
    return {corner.x + static_cast<float>(in_view.x), corner.y + static_cast<float>(in_view.y)};
  }
};

}  // namespace marey::app
