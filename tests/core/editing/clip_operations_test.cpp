#include "core/editing/clip_operations.h"

#include <gtest/gtest.h>

#include "tests/core/editing/generated_clips.h"

namespace marey::test {
namespace {

TEST(ClipOperations, MoveAJointOrAnEndSiteInTheRestPose) {
  const Clip clip = make_clip(2, 3);
  const Edit joint = make_offset_edit(clip, 1, {1, 2, 3});
  EXPECT_EQ(joint.name, "Set offset of Joint1");
  EXPECT_EQ(edited(clip, joint).skeleton.offset(1), glm::dvec3(1, 2, 3));
  const Edit end_site = make_offset_edit(clip, 2, {4, 5, 6});
  EXPECT_EQ(end_site.name, "Set offset of Joint1_end");
  EXPECT_EQ(edited(clip, end_site).skeleton.node(2).offset, glm::dvec3(4, 5, 6));
}

TEST(ClipOperations, ChangeTheReadingOfTheFile) {
  const Clip clip = make_clip(1, 3);
  ClipSettings settings = clip.settings;
  settings.up_axis = Axis::Z;
  EXPECT_EQ(make_settings_edit(clip, settings).name, "Change up axis");
  EXPECT_EQ(edited(clip, make_settings_edit(clip, settings)).settings, settings);
  settings = clip.settings;
  settings.metres_per_unit = 1.0;
  EXPECT_EQ(make_settings_edit(clip, settings).name, "Change unit of length");
  settings = clip.settings;
  settings.position_rule = PositionRule::Add;
  EXPECT_EQ(make_settings_edit(clip, settings).name, "Change meaning of positions");
  settings.up_axis = Axis::Z;
  EXPECT_EQ(make_settings_edit(clip, settings).name, "Change clip settings");
  settings = clip.settings;
  settings.names_in = CharacterSet::Gbk;
  EXPECT_EQ(make_settings_edit(clip, settings).name, "Read names as GBK");
}

TEST(ClipOperations, ChangeTheFrameTimeAndKeepTheSamples) {
  const Clip clip = make_clip_with_curve({1, 2, 3});
  const Edit edit = make_frame_time_edit(0.0083333);
  EXPECT_EQ(edit.name, "Set frame time to 0.0083333 s");
  const Clip after = edited(clip, edit);
  EXPECT_EQ(after.motion.frame_time_s(), 0.0083333);
  EXPECT_EQ(samples_of(after, kCurve), samples_of(clip, kCurve));
}

}  // namespace
}  // namespace marey::test
