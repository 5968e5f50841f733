#pragma once

#include <vector>

#include "core/document/selection.h"
#include "wasm/app/picking.h"
#include "wasm/app/theme.h"
#include "wasm/render/scene.h"
#include "wasm/views/viewport/figure_shape.h"

namespace marey::app {

/// Theme colour as the renderer takes it.
[[nodiscard]] glm::vec4 scene_color(ImU32 color, float alpha = 1.0f);

/// What solids of a side of the body are painted in.
[[nodiscard]] glm::vec4 side_color(const Theme& theme, BodySide side);

/// Adds the figure in `pose` to the solids of the scene: sides of the body by colour, `hovered` brighter, selected
/// joints in the selection colour with their bones outlined.
void add_figure(const FigureShape& shape, const WorldPose& pose, const Selection& selection, JointIndex hovered,
                const Theme& theme, Scene& scene);

/// Adds the ways from a root that only marks the origin as faint lines.
void add_tethers(const FigureShape& shape, const WorldPose& pose, const Theme& theme, Scene& scene);

/// Adds a strobe pose of strength `alpha` in 0..1 to the faded solids.
void add_faded_figure(const FigureShape& shape, const WorldPose& pose, const Theme& theme, float alpha, Scene& scene);

/// What of the figure can be clicked, into `solids`.
void collect_solids(const FigureShape& shape, const WorldPose& pose, std::vector<PickSolid>& solids);

}  // namespace marey::app
