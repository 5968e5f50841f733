#pragma once

#include <cstdint>

#include "core/document/session.h"
#include "wasm/views/viewport/figure_shape.h"
#include "wasm/views/viewport/stage.h"

namespace marey::app {

/// The figure of the open clip, its stage, and its pose where playback stands; each computed again only when what it
/// depends on has changed. Playing allocates nothing.
class FigureCache {
 public:
  /// `clip_serial`: changes with each opened file.
  void update(const Session& session, std::uint64_t clip_serial);

  [[nodiscard]] const FigureShape& shape() const { return shape_; }
  [[nodiscard]] const Stage& stage() const { return stage_; }
  [[nodiscard]] const WorldPose& pose() const { return pose_; }
  /// Box around the pose; what is not finite is left out.
  [[nodiscard]] const Box& pose_box() const { return pose_box_; }
  /// Grows when the figure or the stage is another one: a new file, other offsets, another up axis or position rule.
  [[nodiscard]] std::uint64_t figure_serial() const { return figure_serial_; }
  [[nodiscard]] bool empty() const { return pose_.world_positions.empty(); }

  /// Measures the extent of the motion anew: edits do not move the stage by themselves.
  void measure_bounds(const Clip& clip);
  /// Lights the stage for a camera with this yaw; the light stays there while the camera moves on.
  void light_from(double yaw_rad) { stage_.light_yaw_rad = yaw_rad; }

 private:
  void rebuild(const Clip& clip);
  void compute_pose(const Clip& clip, double position);

  FigureShape shape_;
  Stage stage_;
  Skeleton skeleton_;
  ClipSettings settings_;
  LocalPose local_;
  WorldPose pose_;
  Box pose_box_;
  std::uint64_t clip_serial_ = 0;
  std::uint64_t revision_ = 0;
  std::uint64_t figure_serial_ = 0;
  double position_ = -1.0;
};

/// World pose of a clip at a position in frames; the rest pose of a clip without frames. The buffers are resized where
/// needed.
void compute_clip_pose(const Clip& clip, double position, LocalPose& local, WorldPose& world);

}  // namespace marey::app
