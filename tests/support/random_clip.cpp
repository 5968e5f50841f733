#include "tests/support/random_clip.h"

#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "core/skeleton/skeleton_builder.h"

namespace marey::test {
namespace {

std::string random_name(Random& random) {
  constexpr std::array<std::string_view, 8> kNames = {"Hips",    "mixamorig:Spine", "spine.001", "Bip01 Neck",
                                                      "Голова", "L#1",             "End",       "a-b|c(d)"};
  return std::string(kNames[static_cast<std::size_t>(random.below(8))]) + std::to_string(random.below(20));
}

glm::dvec3 random_offset(Random& random) {
  return {random_sample(random), random_sample(random), random_sample(random)};
}

void add_channels(Random& random, SkeletonBuilder& builder) {
  const int count = random.one_in(4) ? random.below(9) : 3;
  for (int i = 0; i < count; ++i) {
    const bool other = random.one_in(40);
    const auto kind = other ? ChannelKind::Other : static_cast<ChannelKind>(random.below(9));
    builder.add_channel(kind, other ? "Finger" + std::to_string(i) : std::string());
  }
}

}  // namespace

double random_sample(Random& random) {
  switch (random.below(8)) {
    case 0: return 0.0;
    case 1: return -0.0;
    case 2: return random.below(2001) - 1000;
    case 3: return std::round(random.between(-180.0, 180.0) * 1e4) / 1e4;
    case 4: return random.any_finite();
    case 5: return random.between(-1e-12, 1e-12);
    case 6: return random.unit() * 5e-310;
    default: return random.between(-360.0, 360.0);
  }
}

Skeleton random_skeleton(Random& random, int most_joints) {
  SkeletonBuilder builder;
  const int joints = 1 + random.below(most_joints);
  while (builder.joint_count() < joints || builder.open_depth() > 0) {
    const bool may_open = builder.joint_count() < joints;
    const bool may_close = builder.open_depth() > 0;
    if (may_open && (!may_close || !random.one_in(3))) {
      builder.open_joint(random_name(random), random_offset(random));
      add_channels(random, builder);
    } else if (random.one_in(2)) {
      builder.add_end_site(random_offset(random), random.one_in(5) ? random_name(random) : std::string());
    } else {
      builder.close_joint();
    }
  }
  return *builder.build();
}

Motion random_motion(Random& random, int channel_count, int frame_count) {
  Motion motion(channel_count, frame_count, random.between(0.001, 0.1));
  for (ChannelIndex c = 0; c < channel_count; ++c) {
    for (double& sample : motion.channel_samples(c)) sample = random_sample(random);
  }
  return motion;
}

}  // namespace marey::test
