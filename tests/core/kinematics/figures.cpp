#include "tests/core/kinematics/figures.h"

#include <algorithm>
#include <numeric>

#include "core/kinematics/forward_kinematics.h"
#include "core/skeleton/skeleton_builder.h"

namespace marey::figures {
namespace {

using enum ChannelKind;

// Depth of the parent plus one, so that the builder can close what lies between.
int depth_of(const std::vector<JointPlan>& joints, int joint) {
  int depth = 0;
  for (int i = joints[idx(joint)].parent; i != kNoParent; i = joints[idx(i)].parent) ++depth;
  return depth;
}

std::vector<ChannelKind> random_channels(std::mt19937& random) {
  static const std::vector<std::string> kHabits = {"ZXY", "XYZ", "xyzZYX", "ZYX", "X", "", "ZxXyY", "YXY", "zyxZXYs", "XXZ", "y", "xYx?Z"};
  return channels(kHabits[random() % kHabits.size()]);
}

glm::dvec3 random_vector(std::mt19937& random) {
  std::uniform_real_distribution<double> coordinate(-10.0, 10.0);
  return {coordinate(random), coordinate(random), coordinate(random)};
}

}  // namespace

Skeleton make_skeleton(const std::vector<JointPlan>& joints) {
  SkeletonBuilder builder;
  for (int i = 0; i < size_of(joints); ++i) {
    const JointPlan& plan = joints[idx(i)];
    while (builder.open_depth() > depth_of(joints, i)) builder.close_joint();
    builder.open_joint(plan.name, plan.offset);
    for (ChannelKind kind : plan.channels) builder.add_channel(kind, kind == Other ? "Wobble" : "");
    for (const glm::dvec3& end_site : plan.end_sites) builder.add_end_site(end_site);
  }
  while (builder.open_depth() > 0) builder.close_joint();
  return builder.build().value();
}

std::vector<ChannelKind> channels(const std::string& letters) {
  static const std::string kLetters = "xyzXYZs";
  std::vector<ChannelKind> kinds;
  for (char letter : letters) {
    kinds.push_back(letter == '?' ? Other : static_cast<ChannelKind>(kLetters.find(letter)));
  }
  return kinds;
}

Motion make_motion(const std::vector<std::vector<double>>& rows, double frame_time_s) {
  Motion motion(size_of(rows.front()), size_of(rows), frame_time_s);
  for (ChannelIndex channel = 0; channel < motion.channel_count(); ++channel) {
    for (FrameIndex frame = 0; frame < motion.frame_count(); ++frame) {
      motion.channel_samples(channel)[idx(frame)] = rows[idx(frame)][idx(channel)];
    }
  }
  return motion;
}

Skeleton make_random_skeleton(int joint_count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<JointPlan> joints;
  std::vector<JointIndex> open;
  for (int i = 0; i < joint_count; ++i) {
    // Mostly deeper, sometimes back by a few levels, now and then to a new root.
    const std::size_t back = random() % 3 == 0 ? random() % (open.size() + 1) : 0;
    open.resize(open.size() - back);
    JointPlan plan{"joint" + std::to_string(i), open.empty() ? kNoParent : open.back(), random_vector(random),
                   random_channels(random), {}};
    plan.end_sites.resize(random() % 3);
    for (glm::dvec3& end_site : plan.end_sites) end_site = random_vector(random);
    joints.push_back(plan);
    open.push_back(i);
  }
  return make_skeleton(joints);
}

Motion make_random_motion(const Skeleton& skeleton, int frame_count, double limit, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> sample(-limit, limit);
  std::vector<double> samples(idx(skeleton.channel_count()) * idx(frame_count));
  std::generate(samples.begin(), samples.end(), [&] { return sample(random); });
  return Motion(skeleton.channel_count(), frame_count, 1.0 / 60.0, std::move(samples));
}

Skeleton make_gymnast() {
  return make_skeleton({{"Arms", kNoParent, {0.0, 0.0, 0.0}, channels("xyzZXY"), {}},
                        {"Body", 0, {0.0, 10.0, 0.0}, channels("ZXY"), {}},
                        {"Legs", 1, {0.0, 12.0, 0.0}, channels("ZXY"), {{0.0, 16.0, 0.0}}}});
}

Motion make_giant_swing() {
  static const std::vector<glm::dvec3> kAngles = {
      {16.6, 7.0, -2.7},    {27.8, 6.2, 0.2},     {39.6, 5.5, 2.0},     {52.7, 4.7, 0.8},     {67.5, 3.9, -5.0},
      {84.1, 3.2, -15.8},   {102.3, 2.8, -28.2},  {121.9, 2.7, -36.5},  {142.9, 2.9, -37.2},  {164.8, 3.9, -31.4},
      {186.3, 6.4, -22.3},  {205.5, 11.8, -11.1}, {222.1, 20.6, -0.8},  {237.3, 31.0, 3.9},   {253.8, 38.2, 2.2},
      {272.9, 38.1, -2.3},  {293.4, 31.3, -5.4},  {312.2, 21.5, -5.5},  {327.2, 12.7, -3.1},  {338.7, 6.6, -0.3},
      {347.8, 3.5, 1.6},    {355.8, 3.0, 2.3},    {363.3, 4.1, 1.9}};
  std::vector<std::vector<double>> rows;
  for (const glm::dvec3& a : kAngles) rows.push_back({0.0, 0.0, 0.0, a.x, 0.0, 0.0, a.y, 0.0, 0.0, a.z, 0.0, 0.0});
  return make_motion(rows, 0.033333);
}

Points positions_of(const Skeleton& skeleton, const Motion& motion, FrameRange frames, PositionRule rule) {
  const std::size_t nodes = idx(skeleton.node_count());
  std::vector<double> flat(idx(frames.count) * nodes * 3);
  compute_world_positions(skeleton, motion, frames, rule, std::span<double>(flat));
  Points found(idx(frames.count), std::vector<glm::dvec3>(nodes));
  const double* next = flat.data();
  for (auto& frame : found) {
    for (glm::dvec3& p : frame) {
      p = {next[0], next[1], next[2]};
      next += 3;
    }
  }
  return found;
}

Points positions_of(const Skeleton& skeleton, const Motion& motion, PositionRule rule) {
  return positions_of(skeleton, motion, {0, motion.frame_count()}, rule);
}

}  // namespace marey::figures
