#include "tests/mujoco/random_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>

#include "core/math/euler.h"
#include "tests/core/kinematics/figures.h"

namespace marey::test {
namespace {

glm::dvec3 random_vector(Random& random, double most) {
  const double x = random.between(-most, most);
  const double y = random.between(-most, most);
  return {x, y, random.between(-most, most)};
}

glm::dquat random_rotation(Random& random) {
  return rotation_from_euler({Axis::Z, Axis::X, Axis::Y}, random_vector(random, 180.0));
}

/// `count` position channels in any order.
std::string random_positions(Random& random, int count) {
  std::string letters = "xyz";
  for (int i = 0; i < 3; ++i) std::swap(letters[idx(i)], letters[idx(i + random.below(3 - i))]);
  return letters.substr(0, idx(count));
}

/// `count` rotation channels, no two neighbours alike.
std::string random_rotations(Random& random, int count) {
  std::string letters;
  while (size_of(letters) < count) {
    const char letter = "XYZ"[random.below(3)];
    if (letters.empty() || letters.back() != letter) letters += letter;
  }
  return letters;
}

std::string random_channels(Random& random, bool is_root) {
  constexpr std::array kRotations = {3, 3, 3, 3, 3, 1, 1, 1, 2, 0};
  const int rotations = kRotations[idx(random.below(is_root ? 9 : 10))];
  int positions = 0;
  if (is_root) {
    positions = random.one_in(3) ? random.below(3) : 3;
    if (random.one_in(4)) positions = 0;
  } else if (random.one_in(8)) {
    positions = 1 + random.below(3);
  }
  const std::string sliding = random_positions(random, positions);
  const std::string turning = random_rotations(random, rotations);
  return random.one_in(4) ? turning + sliding : sliding + turning;
}

Skeleton make_random_tree(Random& random, double metres_per_unit) {
  std::vector<figures::JointPlan> plan;
  std::vector<JointIndex> open;
  const int joints = 1 + random.below(20);
  for (JointIndex joint = 0; joint < joints; ++joint) {
    if (random.one_in(3)) open.resize(idx(random.below(size_of(open) + 1)));
    if (open.empty() && joint > 0 && !random.one_in(8)) open.push_back(0);
    const JointIndex parent = open.empty() ? kNoParent : open.back();
    const glm::dvec3 offset = random_vector(random, 0.5 / metres_per_unit);
    const auto channels = figures::channels(random_channels(random, parent == kNoParent));
    plan.push_back({"J" + std::to_string(joint), parent, offset, channels, {}});
    open.push_back(joint);
  }
  return figures::make_skeleton(plan);
}

/// Three sines about a mean value, from `start_s` on.
void fill_curve(Random& random, double mean, double most, double start_s, double frame_time_s, std::span<double> samples) {
  std::fill(samples.begin(), samples.end(), mean);
  for (int wave = 0; wave < 3; ++wave) {
    const double size = most * random.between(0.1, 1.0);
    const double rate = 2.0 * std::numbers::pi * random.between(0.3, 3.0);
    const double phase = random.between(0.0, 2.0 * std::numbers::pi);
    for (int frame = 0; frame < size_of(samples); ++frame) {
      samples[idx(frame)] += size * std::sin(rate * (start_s + frame * frame_time_s) + phase);
    }
  }
}

Clip make_random_clip(Random& random) {
  constexpr std::array kUnits = {1.0, 0.01, 0.055};
  Clip clip;
  clip.settings.metres_per_unit = kUnits[idx(random.below(size_of(kUnits)))];
  clip.settings.position_rule = random.one_in(2) ? PositionRule::Add : PositionRule::Replace;
  clip.skeleton = make_random_tree(random, clip.settings.metres_per_unit);
  const double frame_time_s = 1.0 / random.between(60.0, 240.0);
  clip.motion = Motion(clip.skeleton.channel_count(), kRandomFrames, frame_time_s);
  for (ChannelIndex channel = 0; channel < clip.skeleton.channel_count(); ++channel) {
    const bool turns = is_rotation(clip.skeleton.channel(channel).kind);
    const double size = turns ? 40.0 : 0.3 / clip.settings.metres_per_unit;
    const double mean = turns ? random.between(-180.0, 180.0) : random.between(-size, size);
    fill_curve(random, mean, size, random.between(0.0, 10.0), frame_time_s, clip.motion.channel_samples(channel));
  }
  return clip;
}

Segment make_random_segment(Random& random, JointIndex joint) {
  Segment segment;
  segment.joint = joint;
  segment.mass_kg = 0.1 * std::pow(200.0, random.unit());
  segment.com_m = random_vector(random, 0.3);
  // Squares of the mean distances along three axes, of which no principal moment can exceed the sum of the others.
  glm::dvec3 spread(0.0);
  for (int i = 0; i < 3; ++i) spread[i] = std::pow(random.between(0.02, 0.2), 2);
  glm::dmat3 moments(0.0);
  for (int i = 0; i < 3; ++i) moments[i][i] = segment.mass_kg * (spread[(i + 1) % 3] + spread[(i + 2) % 3]);
  const glm::dmat3 turn = glm::mat3_cast(random_rotation(random));
  const glm::dmat3 tensor = turn * moments * glm::transpose(turn);
  segment.inertia_kgm2 = 0.5 * (tensor + glm::transpose(tensor));
  return segment;
}

BodyModel make_random_model(Random& random, const Skeleton& skeleton) {
  BodyModel model;
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    const bool has_children = skeleton.subtree_end(joint) > joint + 1;
    int segments = has_children && random.one_in(6) ? 0 : 1;
    if (segments > 0 && random.one_in(6)) segments += 1 + random.below(2);
    for (int i = 0; i < segments; ++i) model.segments.push_back(make_random_segment(random, joint));
  }
  return model;
}

}  // namespace

RandomBody make_random_body(Random& random) {
  RandomBody body;
  body.clip = make_random_clip(random);
  body.model = make_random_model(random, body.clip.skeleton);
  body.gravity_mps2 = random_rotation(random) * glm::dvec3(0.0, -9.81, 0.0);
  return body;
}

void fill_turning_joints(Random& random, RandomBody& body) {
  const Skeleton& skeleton = body.clip.skeleton;
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    const auto channels = skeleton.channels(joint);
    const auto& segments = body.model.segments;
    const bool turns = std::any_of(channels.begin(), channels.end(), [](const Channel& c) { return is_rotation(c.kind); });
    const bool is_bare = std::none_of(segments.begin(), segments.end(), [&](const Segment& s) { return s.joint == joint; });
    if (turns && is_bare) body.model.segments.push_back(make_random_segment(random, joint));
  }
}

RandomBody body_of_case(int which_case) {
  Random random(static_cast<std::uint64_t>(which_case));
  return make_random_body(random);
}

int body_cases() {
  const char* wanted = std::getenv("MAREY_BODY_CASES");
  return wanted != nullptr ? std::atoi(wanted) : 1000;
}

}  // namespace marey::test
