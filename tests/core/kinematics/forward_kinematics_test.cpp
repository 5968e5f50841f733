#include "core/kinematics/forward_kinematics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>
#include <limits>

#include "core/kinematics/pose.h"
#include "tests/core/kinematics/figures.h"

namespace marey {
namespace {

using figures::positions_of;

// Largest distance of two sets of points, in parts of the size of the first.
double relative_distance(const std::vector<glm::dvec3>& a, const std::vector<glm::dvec3>& b) {
  double largest = 0.0;
  double size = 1.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, glm::distance(a[i], b[i]));
    size = std::max(size, glm::length(a[i]));
  }
  return largest / size;
}

// The same by the plain definition: 4x4 matrices, one joint after the other.
std::vector<glm::dvec3> positions_by_matrices(const Skeleton& skeleton, const Motion& motion, FrameIndex frame,
                                              PositionRule rule) {
  std::vector<glm::dmat4> world(idx(skeleton.node_count()));
  std::vector<glm::dvec3> found;
  for (NodeIndex i = 0; i < skeleton.node_count(); ++i) {
    const Node& node = skeleton.node(i);
    glm::dvec3 translation = node.offset;
    glm::dmat4 rotation(1.0);
    for (int c = 0; c < (node.is_end_site ? 0 : skeleton.channel_count(node.joint)); ++c) {
      const ChannelIndex channel = skeleton.first_channel(node.joint) + c;
      const ChannelKind kind = skeleton.channel(channel).kind;
      const int axis = static_cast<int>(axis_of(kind));
      const double sample = motion.sample(channel, frame);
      if (is_position(kind)) translation[axis] = rule == PositionRule::Add ? translation[axis] + sample : sample;
      glm::dvec3 about(0.0);
      about[axis] = 1.0;
      if (is_rotation(kind)) rotation = rotation * glm::rotate(glm::dmat4(1.0), glm::radians(sample), about);
    }
    const glm::dmat4 local = glm::translate(glm::dmat4(1.0), translation) * rotation;
    world[idx(i)] = node.parent == kNoParent ? local : world[idx(node.parent)] * local;
    found.emplace_back(world[idx(i)][3]);
  }
  return found;
}

class RandomFigures : public testing::TestWithParam<unsigned> {
 protected:
  Skeleton skeleton = figures::make_random_skeleton(40, GetParam());
  Motion motion = figures::make_random_motion(skeleton, 150, 400.0, GetParam() + 100);
};

INSTANTIATE_TEST_SUITE_P(Seeds, RandomFigures, testing::Range(1U, 13U));

TEST_P(RandomFigures, AgreeWithComposedMatrices) {
  for (PositionRule rule : {PositionRule::Replace, PositionRule::Add}) {
    const auto found = positions_of(skeleton, motion, rule);
    for (FrameIndex frame = 0; frame < motion.frame_count(); ++frame) {
      const auto expected = positions_by_matrices(skeleton, motion, frame, rule);
      ASSERT_LT(relative_distance(expected, found[idx(frame)]), 1e-13) << "frame " << frame;
    }
  }
}

TEST_P(RandomFigures, AgreeBetweenWholeClipAndSinglePoses) {
  const auto found = positions_of(skeleton, motion, PositionRule::Replace);
  LocalPose local;
  WorldPose world;
  local.resize(skeleton);
  world.resize(skeleton);
  for (FrameIndex frame = 0; frame < motion.frame_count(); ++frame) {
    compute_local_pose(skeleton, motion, frame, PositionRule::Replace, local);
    compute_world_pose(skeleton, local, world);
    ASSERT_LT(relative_distance(world.world_positions, found[idx(frame)]), 1e-13) << "frame " << frame;
  }
}

TEST_P(RandomFigures, AgreeInAnyRangeOfFrames) {
  const auto whole = positions_of(skeleton, motion, PositionRule::Add);
  for (FrameRange range : {FrameRange{0, 1}, FrameRange{149, 1}, FrameRange{3, 64}, FrameRange{5, 65}, FrameRange{1, 127},
                           FrameRange{22, 128}, FrameRange{40, 0}}) {
    const auto part = positions_of(skeleton, motion, range, PositionRule::Add);
    ASSERT_EQ(size_of(part), range.count);
    for (int i = 0; i < range.count; ++i) ASSERT_EQ(part[idx(i)], whole[idx(range.first + i)]) << range.first << "+" << i;
  }
}

TEST_P(RandomFigures, RoundOnceToSinglePrecision) {
  std::vector<double> doubles(idx(skeleton.node_count() * motion.frame_count()) * 3);
  std::vector<float> floats(doubles.size());
  compute_world_positions(skeleton, motion, {0, motion.frame_count()}, PositionRule::Replace, std::span<double>(doubles));
  compute_world_positions(skeleton, motion, {0, motion.frame_count()}, PositionRule::Replace, std::span<float>(floats));
  for (std::size_t i = 0; i < doubles.size(); ++i) ASSERT_EQ(floats[i], static_cast<float>(doubles[i]));
}

TEST_P(RandomFigures, GiveThePathOfEachNode) {
  const auto all = positions_of(skeleton, motion, {7, 100}, PositionRule::Replace);
  std::vector<float> path(300);
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    compute_node_path(skeleton, motion, {7, 100}, PositionRule::Replace, node, path);
    for (std::size_t i = 0; i < 300; ++i) {
      ASSERT_EQ(path[i], static_cast<float>(all[i / 3][idx(node)][static_cast<int>(i % 3)]));
    }
  }
}

TEST_P(RandomFigures, MoveOnlyTheSubtreeOfATurnedJoint) {
  const FrameRange range{29, 3};
  const auto before = positions_of(skeleton, motion, range, PositionRule::Replace);
  for (ChannelIndex channel = 0; channel < skeleton.channel_count(); ++channel) {
    if (!is_rotation(skeleton.channel(channel).kind)) continue;
    Motion edited = motion;
    edited.channel_samples(channel)[30] += 25.0;
    const JointIndex joint = skeleton.channel(channel).joint;
    const auto after = positions_of(skeleton, edited, range, PositionRule::Replace);
    for (NodeIndex i = 0; i < skeleton.node_count(); ++i) {
      const Node& node = skeleton.node(i);
      const bool below = node.joint >= joint && node.joint < skeleton.subtree_end(joint) && i != skeleton.node_of(joint);
      if (below) continue;
      ASSERT_EQ(after[1][idx(i)], before[1][idx(i)]) << i;
    }
    ASSERT_EQ(after[0], before[0]);
    ASSERT_EQ(after[2], before[2]);
  }
}

TEST_P(RandomFigures, KeepDistancesToJointsWithoutPositionChannels) {
  const auto found = positions_of(skeleton, motion, PositionRule::Replace);
  for (NodeIndex i = 0; i < skeleton.node_count(); ++i) {
    const Node& node = skeleton.node(i);
    const auto drives = skeleton.channels(node.joint);
    const bool slides = std::any_of(drives.begin(), drives.end(), [](const Channel& c) { return is_position(c.kind); });
    if (node.parent == kNoParent || (slides && !node.is_end_site)) continue;
    for (const auto& frame : found) {
      ASSERT_NEAR(glm::distance(frame[idx(i)], frame[idx(node.parent)]), glm::length(node.offset), 1e-9);
    }
  }
}

TEST_P(RandomFigures, LoseOnlyTheSubtreeOfAJointThatIsNotANumber) {
  const auto before = positions_of(skeleton, motion, PositionRule::Replace);
  for (JointIndex joint = 0; joint < skeleton.joint_count(); joint += 3) {
    Motion broken = motion;
    for (int c = 0; c < skeleton.channel_count(joint); ++c) {
      const ChannelIndex channel = skeleton.first_channel(joint) + c;
      broken.channel_samples(channel)[33] = std::numeric_limits<double>::quiet_NaN();
    }
    const auto after = positions_of(skeleton, broken, PositionRule::Replace);
    for (NodeIndex i = 0; i < skeleton.node_count(); ++i) {
      const JointIndex owner = skeleton.node(i).joint;
      if (owner >= joint && owner < skeleton.subtree_end(joint)) continue;
      ASSERT_EQ(after[33][idx(i)], before[33][idx(i)]);
    }
    ASSERT_EQ(after[32], before[32]);
    ASSERT_EQ(after[34], before[34]);
  }
}

TEST(ForwardKinematics, OfZerosIsTheRestPose) {
  const Skeleton skeleton = figures::make_random_skeleton(60, 77);
  const Motion zeros(skeleton.channel_count(), 3, 0.1);
  LocalPose local;
  WorldPose rest;
  local.resize(skeleton);
  rest.resize(skeleton);
  compute_rest_pose(skeleton, local);
  compute_world_pose(skeleton, local, rest);
  for (const auto& frame : positions_of(skeleton, zeros, PositionRule::Add)) EXPECT_EQ(frame, rest.world_positions);
  for (NodeIndex i = 0; i < skeleton.node_count(); ++i) {
    const Node& node = skeleton.node(i);
    const glm::dvec3 parent = node.parent == kNoParent ? glm::dvec3(0.0) : rest.world_positions[idx(node.parent)];
    EXPECT_EQ(rest.world_positions[idx(i)], parent + node.offset);
  }
}

}  // namespace
}  // namespace marey
