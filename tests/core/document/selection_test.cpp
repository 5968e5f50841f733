#include "core/document/selection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/core/editing/generated_clips.h"

namespace marey::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class SelectionTest : public testing::Test {
 protected:
  Clip clip = make_clip(6, 10);
  Selection selection{clip.skeleton};
};

TEST_F(SelectionTest, StartsEmptyWithEveryChannelVisible) {
  EXPECT_THAT(selection.joints(), IsEmpty());
  EXPECT_EQ(selection.active_joint(), kNoParent);
  EXPECT_TRUE(selection.samples().empty());
  for (ChannelIndex channel = 0; channel < clip.skeleton.channel_count(); ++channel) {
    EXPECT_TRUE(selection.is_channel_visible(channel));
  }
}

TEST_F(SelectionTest, IsASetOfJoints) {
  Random random(9);
  std::set<JointIndex> model;
  for (int step = 0; step < 2000; ++step) {
    const JointIndex joint = random.below(6);
    if (random.one_in(10)) {
      selection.select_only(joint);
      model = {joint};
    } else {
      selection.toggle(joint);
      if (!model.insert(joint).second) model.erase(joint);
    }
    ASSERT_EQ(selection.joints(), std::vector<JointIndex>(model.begin(), model.end()));
    for (JointIndex other = -1; other < 7; ++other) ASSERT_EQ(selection.contains(other), model.contains(other));
    ASSERT_EQ(selection.active_joint() == kNoParent, model.empty());
    ASSERT_TRUE(model.empty() || model.contains(selection.active_joint()));
  }
}

TEST_F(SelectionTest, TheJointSelectedLastIsActive) {
  selection.select_only(4);
  selection.toggle(1);
  EXPECT_EQ(selection.active_joint(), 1);
  selection.toggle(1);
  EXPECT_EQ(selection.active_joint(), 4);
  selection.clear_joints();
  EXPECT_EQ(selection.active_joint(), kNoParent);
}

TEST_F(SelectionTest, SelectsTheRunFromTheAnchor) {
  selection.select_only(3);
  selection.select_through(5);
  EXPECT_THAT(selection.joints(), ElementsAre(3, 4, 5));
  EXPECT_EQ(selection.active_joint(), 5);
  selection.select_through(1);
  EXPECT_THAT(selection.joints(), ElementsAre(1, 2, 3));
  selection.select_through(3);
  EXPECT_THAT(selection.joints(), ElementsAre(3));
}

TEST_F(SelectionTest, WithoutAnAnchorARunIsOneJoint) {
  selection.select_through(4);
  EXPECT_THAT(selection.joints(), ElementsAre(4));
  selection.clear_joints();
  selection.select_through(2);
  EXPECT_THAT(selection.joints(), ElementsAre(2));
}

TEST_F(SelectionTest, TakesAnyListOfJoints) {
  const JointIndex joints[] = {4, 1, 99, 1, -1, 3};
  selection.select_joints(joints);
  EXPECT_THAT(selection.joints(), ElementsAre(1, 3, 4));
  EXPECT_EQ(selection.active_joint(), 3);
}

TEST_F(SelectionTest, JointsThatDoNotExistAreIgnored) {
  selection.select_only(2);
  for (const JointIndex joint : {-1, 6, 1000}) {
    selection.select_only(joint);
    selection.toggle(joint);
    selection.select_through(joint);
  }
  EXPECT_THAT(selection.joints(), ElementsAre(2));
  Selection nothing;
  nothing.select_only(0);
  EXPECT_THAT(nothing.joints(), IsEmpty());
}

TEST_F(SelectionTest, ShowsTheVisibleChannelsOfTheSelectedJoints) {
  selection.toggle(1);
  selection.toggle(0);
  selection.set_channel_visible(1, false);
  selection.set_channel_visible(7, false);
  EXPECT_THAT(selection.shown_channels(clip.skeleton), ElementsAre(0, 2, 3, 4, 5, 6, 8));
}

TEST_F(SelectionTest, SamplesThatAreNoLongerShownAreNoLongerSelected) {
  selection.select_only(0);
  selection.toggle(1);
  for (const ChannelIndex channel : {0, 5, 6, 7}) selection.change_samples().add(channel, {2, 3});
  selection.set_channel_visible(5, false);
  EXPECT_THAT(selection.samples().channels(), ElementsAre(0, 6, 7));
  selection.toggle(2);
  EXPECT_THAT(selection.samples().channels(), ElementsAre(0, 6, 7));
  selection.toggle(0);
  EXPECT_THAT(selection.samples().channels(), ElementsAre(6, 7));
  selection.select_through(1);
  EXPECT_THAT(selection.samples().channels(), ElementsAre(6, 7));
  selection.clear_joints();
  EXPECT_TRUE(selection.samples().empty());
}

}  // namespace
}  // namespace marey::test
