#pragma once

#include "core/kinematics/pose.h"
#include "core/motion/clip.h"
#include "core/skeleton/body_side.h"
#include "wasm/app/theme.h"

namespace marey::app {

/// Draws small stick figures of a clip as it would look in another reading. Keeps its buffers between calls.
class PosePicture {
 public:
  /// The pose of a frame under `settings` within the box, seen from obliquely in front with the up axis of the settings
  /// upwards, as large as fits. Nothing for a pose without extent.
  void draw(ImDrawList& draw_list, const Theme& theme, const Clip& clip, const ClipSettings& settings, double frame,
            ImVec2 min, ImVec2 max);

  /// Extent of that pose along the up axis, file units; 0 for a pose without one.
  [[nodiscard]] double measure_height(const Clip& clip, const ClipSettings& settings, double frame);

 private:
  void compute(const Clip& clip, const ClipSettings& settings, double frame);

  LocalPose local_;
  WorldPose world_;
  std::vector<BodySide> sides_;
};

}  // namespace marey::app
