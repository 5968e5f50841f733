#pragma once

#include <vector>

#include "core/kinematics/pose.h"
#include "wasm/app/view_context.h"

namespace marey::app {

/// The selected joint in numbers: offset, channels at the frame, position in the world. Offset and channels can be
/// edited.
class JointPage {
 public:
  void draw(ViewContext& context);

 private:
  void draw_offset(ViewContext& context, NodeIndex node);
  void draw_channels(ViewContext& context, JointIndex joint);
  void draw_rotation(ViewContext& context, JointIndex joint);
  void draw_world_position(ViewContext& context, JointIndex joint);
  void draw_end_sites(ViewContext& context, JointIndex joint);

  LocalPose local_;
  WorldPose world_;
};

}  // namespace marey::app
