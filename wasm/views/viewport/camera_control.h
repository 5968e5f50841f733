#pragma once

#include "wasm/app/view_context.h"
#include "wasm/views/viewport/viewport_state.h"

namespace marey::app {

/// The direction in which a clip is first seen: across the plane of a motion that stays in one (a gymnast on a bar),
/// else the figure's front, from a little aside and above.
[[nodiscard]] CameraPose opening_direction(const Clip& clip, const FigureShape& shape, const Stage& stage,
                                           const WorldPose& first_pose);

/// The pose that shows a clip well when it is opened: the whole motion, or the figure where it stands when it travels
/// too far for that.
[[nodiscard]] CameraPose opening_pose(const Session& session, const FigureCache& figure, double aspect,
                                      double perspective);

/// A point that goes along with the figure over the ground, evenly: the first root, averaged over a step's time, at the
/// height of the ground.
[[nodiscard]] glm::dvec3 followed_point(const Session& session, const Stage& stage);

/// Brings the camera to this frame: opening view, what commands asked for, perspective, following, transitions; then
/// computes state.view for a view of `size`. The figure is up to date.
void update_camera(ViewContext& context, ViewportState& state, const glm::dvec2& size);

}  // namespace marey::app
