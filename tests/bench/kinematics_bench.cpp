// Forward kinematics of a whole clip beside the plain loop that one would write with GLM. Items are joints x frames.
#include <benchmark/benchmark.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <random>
#include <string>
#include <vector>

#include "core/kinematics/forward_kinematics.h"
#include "core/kinematics/pose.h"
#include "core/math/sincos.h"
#include "core/skeleton/skeleton_builder.h"

namespace marey {
namespace {

constexpr int kJoints = 60;
constexpr int kFrames = 20'000;

// Ten limbs of six joints below one root, as many joints as a full hand-and-face-less capture has.
Skeleton make_skeleton() {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> length(-10.0, 10.0);
  SkeletonBuilder builder;
  for (int joint = 0; joint < kJoints; ++joint) {
    while (joint > 0 && builder.open_depth() > (joint - 1) % 6 + 1) builder.close_joint();
    builder.open_joint("joint" + std::to_string(joint), {length(random), length(random), length(random)});
    if (joint == 0) {
      for (auto kind : {ChannelKind::Xposition, ChannelKind::Yposition, ChannelKind::Zposition}) builder.add_channel(kind);
    }
    for (auto kind : {ChannelKind::Zrotation, ChannelKind::Xrotation, ChannelKind::Yrotation}) builder.add_channel(kind);
  }
  while (builder.open_depth() > 0) builder.close_joint();
  return builder.build().value();
}

Motion make_motion(const Skeleton& skeleton) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  Motion motion(skeleton.channel_count(), kFrames, 1.0 / 120.0);
  for (ChannelIndex channel = 0; channel < motion.channel_count(); ++channel) {
    const double amplitude = 90.0 * unit(random);
    const double phase = 3.0 * unit(random);
    const auto samples = motion.channel_samples(channel);
    for (FrameIndex i = 0; i < kFrames; ++i) samples[idx(i)] = amplitude * std::sin(0.03 * i + phase);
  }
  return motion;
}

struct GeneratedClip {
  Skeleton skeleton = make_skeleton();
  Motion motion = make_motion(skeleton);
  std::vector<float> positions = std::vector<float>(idx(skeleton.node_count()) * 3 * kFrames);
};

GeneratedClip& generated_clip() {
  static GeneratedClip clip;
  return clip;
}

void count_joint_frames(benchmark::State& state, int frames) {
  state.SetItemsProcessed(state.iterations() * kJoints * frames);
}

glm::dvec3 axis_vector(Axis axis) {
  glm::dvec3 vector(0.0);
  vector[static_cast<int>(axis)] = 1.0;
  return vector;
}

// Offset and channels of a joint as one matrix, in the way of a first program.
glm::dmat4 local_matrix(const GeneratedClip& clip, JointIndex joint, FrameIndex frame) {
  glm::dvec3 translation = clip.skeleton.offset(joint);
  glm::dmat4 rotation(1.0);
  ChannelIndex index = clip.skeleton.first_channel(joint);
  for (const Channel& channel : clip.skeleton.channels(joint)) {
    const double sample = clip.motion.sample(index++, frame);
    if (is_position(channel.kind)) {
      translation[static_cast<int>(axis_of(channel.kind))] = sample;
    } else {
      rotation = glm::rotate(rotation, glm::radians(sample), axis_vector(axis_of(channel.kind)));
    }
  }
  return glm::translate(glm::dmat4(1.0), translation) * rotation;
}

void glm_matrices(benchmark::State& state) {
  GeneratedClip& clip = generated_clip();
  std::vector<glm::dmat4> world(kJoints);
  for (auto _ : state) {
    float* out = clip.positions.data();
    for (FrameIndex frame = 0; frame < kFrames; ++frame) {
      for (JointIndex joint = 0; joint < kJoints; ++joint) {
        const JointIndex parent = clip.skeleton.parent(joint);
        const glm::dmat4 local = local_matrix(clip, joint, frame);
        world[idx(joint)] = parent == kNoParent ? local : world[idx(parent)] * local;
        for (int axis = 0; axis < 3; ++axis) *out++ = static_cast<float>(world[idx(joint)][3][axis]);
      }
    }
  }
  count_joint_frames(state, kFrames);
}

struct QuaternionFrame {
  glm::dquat rotation;
  glm::dvec3 position;
};

QuaternionFrame local_frame(const GeneratedClip& clip, JointIndex joint, FrameIndex frame) {
  QuaternionFrame local{glm::dquat(1.0, 0.0, 0.0, 0.0), clip.skeleton.offset(joint)};
  ChannelIndex index = clip.skeleton.first_channel(joint);
  for (const Channel& channel : clip.skeleton.channels(joint)) {
    const double sample = clip.motion.sample(index++, frame);
    if (is_position(channel.kind)) {
      local.position[static_cast<int>(axis_of(channel.kind))] = sample;
    } else {
      local.rotation = local.rotation * glm::angleAxis(glm::radians(sample), axis_vector(axis_of(channel.kind)));
    }
  }
  return local;
}

void glm_quaternions(benchmark::State& state) {
  GeneratedClip& clip = generated_clip();
  std::vector<QuaternionFrame> world(kJoints);
  for (auto _ : state) {
    float* out = clip.positions.data();
    for (FrameIndex frame = 0; frame < kFrames; ++frame) {
      for (JointIndex joint = 0; joint < kJoints; ++joint) {
        const JointIndex parent = clip.skeleton.parent(joint);
        QuaternionFrame own = local_frame(clip, joint, frame);
        if (parent != kNoParent) {
          const QuaternionFrame& above = world[idx(parent)];
          own = {above.rotation * own.rotation, above.position + above.rotation * own.position};
        }
        world[idx(joint)] = own;
        for (int axis = 0; axis < 3; ++axis) *out++ = static_cast<float>(own.position[axis]);
      }
    }
  }
  count_joint_frames(state, kFrames);
}

void marey_clip(benchmark::State& state) {
  GeneratedClip& clip = generated_clip();
  for (auto _ : state) {
    compute_world_positions(clip.skeleton, clip.motion, {0, kFrames}, PositionRule::Replace,
                            std::span<float>(clip.positions));
  }
  count_joint_frames(state, kFrames);
}

// Frames `step` apart: 1 is playing, a large step is scrubbing, where no sample is in the cache.
void marey_single_poses(benchmark::State& state, int step) {
  const GeneratedClip& clip = generated_clip();
  LocalPose local;
  WorldPose world;
  local.resize(clip.skeleton);
  world.resize(clip.skeleton);
  FrameIndex frame = 0;
  for (auto _ : state) {
    compute_local_pose(clip.skeleton, clip.motion, frame, PositionRule::Replace, local);
    compute_world_pose(clip.skeleton, local, world);
    benchmark::DoNotOptimize(world.world_positions.data());
    frame = (frame + step) % kFrames;
  }
  count_joint_frames(state, 1);
}

void marey_node_path(benchmark::State& state) {
  GeneratedClip& clip = generated_clip();
  for (auto _ : state) {
    compute_node_path(clip.skeleton, clip.motion, {0, kFrames}, PositionRule::Replace, kJoints - 1,
                      std::span(clip.positions).first(3 * kFrames));
  }
}

void sincos_library(benchmark::State& state) {
  double angle_deg = 0.0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(std::sin(glm::radians(angle_deg)) + std::cos(glm::radians(angle_deg)));
    angle_deg += 0.37;
  }
}

void sincos_marey(benchmark::State& state) {
  double angle_deg = 0.0;
  for (auto _ : state) {
    const SinCos<double> found = sincos_deg(angle_deg);
    benchmark::DoNotOptimize(found.sine + found.cosine);
    angle_deg += 0.37;
  }
}

BENCHMARK(glm_matrices)->Name("fk/clip/glm_matrices")->Unit(benchmark::kMillisecond);
BENCHMARK(glm_quaternions)->Name("fk/clip/glm_quaternions")->Unit(benchmark::kMillisecond);
BENCHMARK(marey_clip)->Name("fk/clip/marey")->Unit(benchmark::kMillisecond);
BENCHMARK(marey_node_path)->Name("fk/node_path/marey")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(marey_single_poses, playing, 1)->Name("fk/one_pose/playing/marey");
BENCHMARK_CAPTURE(marey_single_poses, scrubbing, 997)->Name("fk/one_pose/scrubbing/marey");
BENCHMARK(sincos_library)->Name("sincos/library");
BENCHMARK(sincos_marey)->Name("sincos/marey");

}  // namespace
}  // namespace marey
