#pragma once

#include <random>
#include <string>
#include <vector>

#include "core/motion/motion.h"
#include "core/skeleton/position_rule.h"
#include "core/skeleton/skeleton.h"

namespace marey::figures {

/// A joint of a figure to be built; `parent` is the index of an earlier joint, kNoParent for a root. Children stand in
/// depth-first order.
struct JointPlan {
  std::string name;
  JointIndex parent = kNoParent;
  glm::dvec3 offset{0.0};
  std::vector<ChannelKind> channels;
  std::vector<glm::dvec3> end_sites;
};

[[nodiscard]] Skeleton make_skeleton(const std::vector<JointPlan>& joints);

/// Channels from letters: "x y z" are positions, "X Y Z" rotations, "s" a scale, "?" an unknown one.
[[nodiscard]] std::vector<ChannelKind> channels(const std::string& letters);

/// Rows of samples as a BVH file has them, one vector per frame.
[[nodiscard]] Motion make_motion(const std::vector<std::vector<double>>& rows, double frame_time_s);

/// A tree of `joint_count` joints of random shape, one or more roots, end sites, any mix of channels in any order.
[[nodiscard]] Skeleton make_random_skeleton(int joint_count, unsigned seed);

/// Random angles and positions up to `limit`.
[[nodiscard]] Motion make_random_motion(const Skeleton& skeleton, int frame_count, double limit, unsigned seed);

/// The giant swing of the founding paper: arms, body and legs, turning about z in 23 frames.
[[nodiscard]] Skeleton make_gymnast();
[[nodiscard]] Motion make_giant_swing();

/// World positions of a range of frames in double precision, as points[frame][node].
using Points = std::vector<std::vector<glm::dvec3>>;
[[nodiscard]] Points positions_of(const Skeleton& skeleton, const Motion& motion, FrameRange frames, PositionRule rule);
[[nodiscard]] Points positions_of(const Skeleton& skeleton, const Motion& motion, PositionRule rule);

}  // namespace marey::figures
