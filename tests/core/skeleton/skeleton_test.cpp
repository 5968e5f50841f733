#include "core/skeleton/skeleton.h"

#include <gtest/gtest.h>

#include "tests/core/kinematics/figures.h"

namespace marey {
namespace {

using figures::channels;

// A hip with two legs, of which the right one is cut short, and a back with two end sites.
Skeleton make_hip() {
  return figures::make_skeleton({{"hip", kNoParent, {5.0, 100.0, 0.0}, channels("xyzZXY"), {}},
                                 {"left knee", 0, {10.0, -40.0, 0.0}, channels("X"), {}},
                                 {"left foot", 1, {0.0, -40.0, 5.0}, channels("XYZ"), {{0.0, 0.0, 10.0}}},
                                 {"right knee", 0, {-10.0, -40.0, 0.0}, {}, {}},
                                 {"back", 0, {0.0, 60.0, 0.0}, channels("s?Z"), {{20.0, 0.0, 0.0}, {-20.0, 0.0, 0.0}}}});
}

TEST(Skeleton, StandsDepthFirstWithContiguousSubtrees) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Skeleton skeleton = figures::make_random_skeleton(50, seed);
    for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
      ASSERT_LT(skeleton.parent(joint), joint);
      const JointIndex parent = skeleton.parent(joint);
      ASSERT_EQ(skeleton.depth(joint), parent == kNoParent ? 0 : skeleton.depth(parent) + 1);
      for (JointIndex other = 0; other < skeleton.joint_count(); ++other) {
        bool below = other == joint;
        for (JointIndex i = other; i != kNoParent; i = skeleton.parent(i)) below = below || i == joint;
        ASSERT_EQ(below, other >= joint && other < skeleton.subtree_end(joint));
      }
    }
  }
}

TEST(Skeleton, NodesAreJointsAndTheirEndSites) {
  const Skeleton skeleton = make_hip();
  ASSERT_EQ(skeleton.joint_count(), 5);
  ASSERT_EQ(skeleton.node_count(), 8);
  const bool end_sites[] = {false, false, false, true, false, false, true, true};
  const JointIndex joints[] = {0, 1, 2, 2, 3, 4, 4, 4};
  const NodeIndex parents[] = {kNoParent, 0, 1, 2, 0, 0, 5, 5};
  for (NodeIndex i = 0; i < 8; ++i) {
    EXPECT_EQ(skeleton.node(i).is_end_site, end_sites[i]) << i;
    EXPECT_EQ(skeleton.node(i).joint, joints[i]) << i;
    EXPECT_EQ(skeleton.node(i).parent, parents[i]) << i;
  }
  for (JointIndex joint = 0; joint < 5; ++joint) {
    EXPECT_FALSE(skeleton.node(skeleton.node_of(joint)).is_end_site);
    EXPECT_EQ(skeleton.node(skeleton.node_of(joint)).joint, joint);
  }
}

TEST(Skeleton, GivesEachJointItsColumns) {
  const Skeleton skeleton = make_hip();
  const int firsts[] = {0, 6, 7, 10, 10};
  const int counts[] = {6, 1, 3, 0, 3};
  for (JointIndex joint = 0; joint < 5; ++joint) {
    EXPECT_EQ(skeleton.first_channel(joint), firsts[joint]);
    EXPECT_EQ(skeleton.channel_count(joint), counts[joint]);
    for (const Channel& channel : skeleton.channels(joint)) EXPECT_EQ(channel.joint, joint);
  }
  EXPECT_EQ(skeleton.channel_count(), 13);
}

TEST(Skeleton, LabelsNodesAndChannels) {
  const Skeleton skeleton = make_hip();
  EXPECT_EQ(node_label(skeleton, 1), "left knee");
  EXPECT_EQ(node_label(skeleton, 3), "left foot_end");
  EXPECT_EQ(node_label(skeleton, 6), "back_end");
  EXPECT_EQ(node_label(skeleton, 7), "back_end2");
  EXPECT_EQ(channel_label(skeleton, 0), "hip Xposition");
  EXPECT_EQ(channel_label(skeleton, 11), "back Wobble");
  EXPECT_EQ(euler_order_label(skeleton, 0), "ZXY");
  EXPECT_EQ(euler_order_label(skeleton, 3), "");
  EXPECT_EQ(euler_order_label(skeleton, 4), "Z");
}

TEST(Skeleton, StatureIsTheLargestExtentWhereverTheRootStands) {
  EXPECT_EQ(compute_stature(make_hip()), 140.0);
  EXPECT_EQ(compute_stature(figures::make_skeleton({{"point", kNoParent, {7.0, 8.0, 9.0}, {}, {}}})), 0.0);
}

TEST(ChannelKind, KnowsItsKeywordInAnyCase) {
  for (int i = 0; i < 9; ++i) {
    const ChannelKind kind = static_cast<ChannelKind>(i);
    EXPECT_EQ(find_channel_kind(channel_keyword(kind)), kind);
    EXPECT_EQ(static_cast<int>(axis_of(kind)), i % 3);
    EXPECT_EQ(is_position(kind), i < 3);
    EXPECT_EQ(is_rotation(kind), i >= 3 && i < 6);
  }
  EXPECT_EQ(find_channel_kind("xPOSITION"), ChannelKind::Xposition);
  EXPECT_EQ(find_channel_kind("zrotation"), ChannelKind::Zrotation);
  for (const char* unknown : {"", "Xrot", "Xrotationn", "Wrotation", "rotation"}) {
    EXPECT_FALSE(find_channel_kind(unknown)) << unknown;
  }
  EXPECT_FALSE(is_position(ChannelKind::Other));
  EXPECT_FALSE(is_rotation(ChannelKind::Other));
}

}  // namespace
}  // namespace marey
