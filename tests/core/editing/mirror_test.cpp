#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>

#include "core/bvh/reader.h"
#include "core/editing/mirror_pairing.h"
#include "core/skeleton/body_side.h"
#include "core/skeleton/skeleton_builder.h"
#include "tests/core/editing/operation_clips.h"
#include "tests/support/files.h"

namespace marey::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// Positions with x the other way round and the nodes of left and right exchanged.
std::vector<double> mirrored_positions(const Clip& clip, const MirrorPairing& pairing) {
  const std::vector<double> positions = positions_of(clip);
  std::vector<double> mirrored(positions.size());
  const Skeleton& skeleton = clip.skeleton;
  const auto nodes = idx(skeleton.node_count());
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    const Node& n = skeleton.node(node);
    // An end site stands right behind its joint in this figure.
    const NodeIndex partner = skeleton.node_of(pairing.partner[idx(n.joint)]) + (n.is_end_site ? 1 : 0);
    for (int frame = 0; frame < clip.motion.frame_count(); ++frame) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double value = positions[(idx(frame) * nodes + idx(partner)) * 3 + axis];
        mirrored[(idx(frame) * nodes + idx(node)) * 3 + axis] = axis == 0 ? -value : value;
      }
    }
  }
  return mirrored;
}

std::vector<std::string> partner_names(const Skeleton& skeleton) {
  std::vector<std::string> names;
  for (const JointIndex partner : find_mirror_pairs(skeleton).partner) names.push_back(skeleton.name(partner));
  return names;
}

TEST(MirrorPairing, FindsCounterpartsByName) {
  const Skeleton skeleton = make_figure(1).skeleton;
  EXPECT_THAT(partner_names(skeleton), ElementsAre("Hips", "Spine", "Head", "RightArm", "RightHand", "LeftArm", "LeftHand",
                                                   "RightLeg", "RightKnee", "LeftLeg", "LeftKnee"));
  const MirrorPairing pairing = find_mirror_pairs(skeleton);
  EXPECT_THAT(pairing.unpaired, IsEmpty());
  EXPECT_EQ(find_lateral_axis(skeleton, pairing, Axis::Y), Axis::X);
  EXPECT_THAT(find_unsymmetric_joints(skeleton, pairing, Axis::X), IsEmpty());
}

TEST(MirrorPairing, SaysWhoHasNone) {
  SkeletonBuilder builder;
  builder.open_joint("Hips");
  for (const char* name : {"LeftLeg", "RightLeg", "LeftTail"}) {
    builder.open_joint(name, {name[0] == 'L' ? 1.0 : -1.0, 0, 0});
    builder.close_joint();
  }
  builder.close_joint();
  const Skeleton skeleton = builder.build().value();
  EXPECT_THAT(find_mirror_pairs(skeleton).unpaired, ElementsAre(3));
  EXPECT_THAT(partner_names(skeleton), ElementsAre("Hips", "RightLeg", "LeftLeg", "LeftTail"));
}

TEST(Mirror, ShowsTheImageOfAMirror) {
  for (const PositionRule rule : {PositionRule::Replace, PositionRule::Add}) {
    Clip clip = make_figure(30);
    clip.settings.position_rule = rule;
    const OperationOutcome outcome = outcome_of(clip, "mirror", whole_clip(clip));
    EXPECT_THAT(outcome.notes, IsEmpty());
    const Clip mirrored = edited(clip, outcome.edit);
    EXPECT_LT(largest_difference(positions_of(mirrored), mirrored_positions(clip, find_mirror_pairs(clip.skeleton))), 1e-9);
  }
}

TEST(Mirror, TwiceIsTheStart) {
  Random random(31);
  for (int round = 0; round < 10; ++round) {
    const Clip clip = make_wild_figure(random, 30);
    EXPECT_EQ(bits_of(after(after(clip, "mirror"), "mirror")), bits_of(clip));
  }
}

TEST(Mirror, DescribesOtherOrdersByTheirRotation) {
  SkeletonBuilder builder;
  builder.open_joint("Hips");
  for (const bool left : {true, false}) {
    builder.open_joint(left ? "LeftArm" : "RightArm", {left ? 10.0 : -10.0, 0, 0});
    for (const auto kind : {ChannelKind::Zrotation, ChannelKind::Yrotation, ChannelKind::Xrotation}) {
      builder.add_channel(left ? kind : static_cast<ChannelKind>(8 - static_cast<int>(kind)));
    }
    builder.add_end_site({left ? 10.0 : -10.0, 3, 1});
    builder.close_joint();
  }
  builder.close_joint();
  Clip clip;
  clip.skeleton = builder.build().value();
  ASSERT_EQ(euler_order_label(clip.skeleton, 1), "ZYX");
  ASSERT_EQ(euler_order_label(clip.skeleton, 2), "XYZ");
  clip.motion = Motion(6, 1, 0.1, {10, 20, 30, -40, 50, 60});
  const Clip mirrored = after(clip, "mirror");
  EXPECT_LT(largest_difference(positions_of(mirrored), mirrored_positions(clip, find_mirror_pairs(clip.skeleton))), 1e-9);
  EXPECT_LT(largest_difference(positions_of(after(mirrored, "mirror")), positions_of(clip)), 1e-9);
}

// Bones along x in every limb, as in figures whose joints have their own axes: no mirror image in the rest pose, yet one in motion.
TEST(Mirror, CorrectsRestPosesThatAreNoMirrorImage) {
  SkeletonBuilder builder;
  builder.open_joint("Hips");
  for (int kind = 0; kind < 6; ++kind) builder.add_channel(static_cast<ChannelKind>(kind));
  for (const char* side : {"Left", "Right"}) {
    builder.open_joint(std::string(side) + "Leg", {side[0] == 'L' ? 10.0 : -10.0, 0, 3});
    for (int kind = 3; kind < 6; ++kind) builder.add_channel(static_cast<ChannelKind>(kind));
    builder.open_joint(std::string(side) + "Foot", {40, 0, 0});
    for (int kind = 3; kind < 6; ++kind) builder.add_channel(static_cast<ChannelKind>(kind));
    builder.add_end_site({10, 2, 0});
    builder.close_joint();
    builder.close_joint();
  }
  builder.close_joint();
  Clip clip;
  clip.skeleton = builder.build().value();
  clip.motion = Motion(18, 12, 0.1);
  Random random(71);
  for (ChannelIndex channel = 0; channel < 18; ++channel) {
    for (double& sample : clip.motion.channel_samples(channel)) sample = random.between(-60, 60);
  }
  const OperationOutcome outcome = outcome_of(clip, "mirror", whole_clip(clip));
  EXPECT_THAT(outcome.notes, IsEmpty());
  const Clip changed = edited(clip, outcome.edit);
  EXPECT_LT(largest_difference(positions_of(changed), mirrored_positions(clip, find_mirror_pairs(clip.skeleton))), 1e-9);
  EXPECT_LT(largest_difference(positions_of(after(changed, "mirror")), positions_of(clip)), 1e-9);
}

TEST(Mirror, SaysWhereTheRestPoseIsNoMirrorImage) {
  Clip clip = make_figure(5);
  clip.skeleton.set_offset(clip.skeleton.node_of(3), {40, 20, 0});
  const OperationOutcome outcome = outcome_of(clip, "mirror", whole_clip(clip));
  ASSERT_EQ(outcome.notes.size(), 1u);
  EXPECT_EQ(outcome.notes[0],
            "2 joints have offsets that are no mirror image of their counterparts', so the pose is none there: LeftArm, RightArm.");
}

// Most figures in the wild have a counterpart for each joint of a side.
TEST(MirrorPairing, PairsRecordedFigures) {
  int files = 0;
  int joints = 0;
  int unpaired = 0;
  for (const std::string& path : recorded_bvh_files()) {
    const auto text = read_shared_file(path);
    const auto clip = text ? read_bvh(*text, {}) : Result<BvhClip>(Error{});
    if (!clip) continue;
    ++files;
    const MirrorPairing pairing = find_mirror_pairs(clip->skeleton);
    for (JointIndex joint = 0; joint < clip->skeleton.joint_count(); ++joint) {
      EXPECT_EQ(pairing.partner[idx(pairing.partner[idx(joint)])], joint) << path;
      joints += compute_body_sides(clip->skeleton)[idx(joint)] != BodySide::Middle ? 1 : 0;
    }
    unpaired += size_of(pairing.unpaired);
  }
  if (files == 0) GTEST_SKIP() << "no recorded files";
  std::printf("%d files, %d joints of a side, %d without a counterpart\n", files, joints, unpaired);
  EXPECT_LT(unpaired * 20, joints);
}

}  // namespace
}  // namespace marey::test
