#pragma once

#include "core/kinematics/clip_bounds.h"
#include "core/motion/clip.h"
#include "wasm/app/camera.h"
#include "wasm/app/theme.h"
#include "wasm/app/view_options.h"
#include "wasm/render/scene.h"
#include "wasm/views/viewport/figure_shape.h"

namespace marey::app {

/// The place of a performance, measured once per revision of the clip.
struct Stage {
  Box bounds;                  ///< of all nodes over the clip
  Axis up = Axis::Y;
  double ground_height = 0.0;  ///< along `up`
  double cell = 10.0;          ///< side of a grid cell: 1, 2 or 5 times a power of ten, about an eighth of the figure
  double size = 1.0;           ///< of the figure
  /// The figure wanders further than a view can show it well; the camera had better follow.
  bool travels = false;
  double light_yaw_rad = 0.0;  ///< the key light comes from the left of a camera with this yaw
};

[[nodiscard]] Stage measure_stage(const Clip& clip, const FigureShape& shape);

/// The largest of 1, 2, 5 times a power of ten that is not above `value` > 0.
[[nodiscard]] double rounded_down_125(double value);

/// Box of all that a frame draws, for the camera's near and far plane.
[[nodiscard]] Box drawn_reach(const Stage& stage, const CameraPose& camera);

/// Background, light, ground and shadow of the scene. `figure`: box around the present pose.
void add_stage(const Stage& stage, const CameraPose& camera, const Box& figure, const Theme& theme,
               const ViewOptions& options, Scene& scene);

/// The ground as a line, for views that see the grid from its edge; nothing in others.
void add_ground_line(const Stage& stage, const CameraView& view, Scene& scene);

}  // namespace marey::app
