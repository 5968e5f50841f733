#include "wasm/views/viewport/segment_solids.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/biomechanics/segment_solid.h"
#include "wasm/views/viewport/figure_drawing.h"

namespace marey::app {
namespace {

constexpr double kThinnest = 0.012;  // half axis of a rod, of the figure's size
constexpr float kAlpha = 0.5f;
constexpr float kHoverLight = 0.4f;

}  // namespace

void SegmentSolids::follow(const Analysis& analysis, double metres_per_unit, double size) {
  if (body_serial_ == analysis.body_serial()) return;
  body_serial_ = analysis.body_serial();
  solids_.clear();
  if (analysis.body() == nullptr) return;
  const BodyModel& model = analysis.body()->body.model;
  const double units = 1.0 / model.metres_per_unit.value_or(metres_per_unit);
  for (const Segment& segment : model.segments) {
    if (!(segment.mass_kg > 0.0)) continue;
    const SegmentSolid shape = find_segment_solid(segment);
    Solid solid{segment.joint, units * segment.com_m, shape.axes};
    for (int i = 0; i < 3; ++i) solid.half_axes[i] *= std::max(units * shape.half_axes_m[i], kThinnest * size);
    solids_.push_back(solid);
  }
}

void SegmentSolids::add(ViewContext& context, const FigureCache& figure, Scene& scene) {
  if (!context.options.show_solids || context.session.is_partial) return;
  const Clip& clip = context.session.document.clip();
  context.analysis.follow_body(context.session, context.clip_serial);
  follow(context.analysis, clip.settings.metres_per_unit, figure.stage().size);
  for (const Solid& solid : solids_) {
    const glm::dquat& rotation = figure.pose().world_rotations[idx(solid.joint)];
    const glm::dvec3 center = figure.pose().world_positions[idx(clip.skeleton.node_of(solid.joint))] + rotation * solid.center;
    if (!std::isfinite(center.x + center.y + center.z)) continue;
    SceneEllipsoid ellipsoid{.center = glm::vec3(center)};
    const glm::dmat3 axes = glm::mat3_cast(rotation) * solid.half_axes;
    for (int i = 0; i < 3; ++i) ellipsoid.axes[i] = glm::vec3(axes[i]);
    const bool is_selected = context.session.selection.contains(solid.joint);
    ellipsoid.color = is_selected ? scene_color(context.theme.selection) : side_color(context.theme, figure.shape().sides[idx(solid.joint)]);
    if (context.hover.joint == solid.joint) ellipsoid.color = glm::mix(ellipsoid.color, glm::vec4(1.0f), kHoverLight);
    ellipsoid.color.a = kAlpha;
    scene.ellipsoids.push_back(ellipsoid);
  }
}

}  // namespace marey::app
