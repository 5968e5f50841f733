#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "wasm/app/small_text.h"
#include "wasm/app/view_context.h"
#include "wasm/render/scene.h"
#include "wasm/views/viewport/viewport_state.h"

namespace marey::app {

/// The mechanics of the shown frame as arrows and marks in the scene: centre of mass with path and place on the ground,
/// velocities, accelerations, forces and torques of the selected joints or of all, angular momentum, support reaction. The
/// longest arrow of a kind over the whole clip has the same length for all kinds.
class BodyArrows {
 public:
  /// Adds to the scene what is switched on. Of a clip whose numbers are not known nothing is added.
  void add(ViewContext& context, const ViewportState& viewport, Scene& scene);

  /// "500 N" and the like: what the bar beside each name means.
  struct Legend {
    BodyArrow kind = BodyArrow::Velocity;
    SmallText text;
    float width = 0.0f;  ///< ImGui units
  };
  [[nodiscard]] std::span<const Legend> legends() const { return legends_; }

 private:
  void follow(ViewContext& context, const ViewportState& viewport);
  void find_scales(ViewContext& context, double longest);
  void add_com(ViewContext& context, const ViewportState& viewport, Scene& scene) const;
  void add_joint_arrows(ViewContext& context, const ViewportState& viewport, BodyArrow kind, Scene& scene) const;
  void add_body_arrows(ViewContext& context, const ViewportState& viewport, Scene& scene) const;
  void add_arrow(const ViewportState& viewport, const glm::dvec3& from, const glm::dvec3& arrow, const glm::vec4& color, Scene& scene) const;

  std::uint64_t serial_ = 0;
  bool known_ = false;
  double units_per_value_[kBodyArrowCount] = {};  // file units of arrow
  std::vector<Legend> legends_;
};

/// The colour of a kind of arrows.
[[nodiscard]] ImU32 arrow_color(const Theme& theme, BodyArrow kind);

/// The names and lengths of the arrows that are shown, as rows from `corner` down.
void draw_arrow_legend(ViewContext& context, const BodyArrows& arrows, ImVec2 corner);

}  // namespace marey::app
