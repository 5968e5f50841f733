// Forward kinematics of a whole clip beside the plain loop that one would write with GLM. Items are joints x frames.
#include <benchmark/benchmark.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <vector>

#include "core/kinematics/forward_kinematics.h"
#include "core/kinematics/pose.h"
#include "core/math/sincos.h"
#include "tests/bench/bench_clip.h"

namespace marey {
namespace {

using bench::clip;

/// A sample of the clip, row after row as in the file: how a first program keeps them.
double sample_in_rows(ChannelIndex channel, FrameIndex frame) {
  static const std::vector<double> rows = [] {
    const Motion& motion = clip().motion;
    std::vector<double> samples;
    for (FrameIndex f = 0; f < motion.frame_count(); ++f) {
      for (ChannelIndex c = 0; c < motion.channel_count(); ++c) samples.push_back(motion.sample(c, f));
    }
    return samples;
  }();
  return rows[idx(frame) * idx(clip().motion.channel_count()) + idx(channel)];
}

/// Room for the positions of all nodes in all frames.
std::vector<float>& position_room() {
  static std::vector<float> positions(idx(clip().skeleton.node_count()) * 3 * idx(clip().motion.frame_count()));
  return positions;
}

void count_joint_frames(benchmark::State& state, int frames) {
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * clip().skeleton.joint_count() * frames);
}

glm::dvec3 axis_vector(Axis axis) {
  glm::dvec3 vector(0.0);
  vector[static_cast<int>(axis)] = 1.0;
  return vector;
}

// Offset and channels of a joint as one matrix, in the way of a first program.
glm::dmat4 local_matrix(const BvhClip& clip, JointIndex joint, FrameIndex frame) {
  glm::dvec3 translation = clip.skeleton.offset(joint);
  glm::dmat4 rotation(1.0);
  ChannelIndex index = clip.skeleton.first_channel(joint);
  for (const Channel& channel : clip.skeleton.channels(joint)) {
    const double sample = sample_in_rows(index++, frame);
    if (is_position(channel.kind)) {
      translation[static_cast<int>(axis_of(channel.kind))] = sample;
    } else {
      rotation = glm::rotate(rotation, glm::radians(sample), axis_vector(axis_of(channel.kind)));
    }
  }
  return glm::translate(glm::dmat4(1.0), translation) * rotation;
}

void glm_matrices(benchmark::State& state) {
  const BvhClip& clip = bench::clip();
  std::vector<glm::dmat4> world(idx(clip.skeleton.joint_count()));
  for (auto _ : state) {
    float* out = position_room().data();
    for (FrameIndex frame = 0; frame < clip.motion.frame_count(); ++frame) {
      for (JointIndex joint = 0; joint < clip.skeleton.joint_count(); ++joint) {
        const JointIndex parent = clip.skeleton.parent(joint);
        const glm::dmat4 local = local_matrix(clip, joint, frame);
        world[idx(joint)] = parent == kNoParent ? local : world[idx(parent)] * local;
        for (int axis = 0; axis < 3; ++axis) *out++ = static_cast<float>(world[idx(joint)][3][axis]);
      }
    }
  }
  count_joint_frames(state, clip.motion.frame_count());
}

struct QuaternionFrame {
  glm::dquat rotation;
  glm::dvec3 position;
};

QuaternionFrame local_frame(const BvhClip& clip, JointIndex joint, FrameIndex frame) {
  QuaternionFrame local{glm::dquat(1.0, 0.0, 0.0, 0.0), clip.skeleton.offset(joint)};
  ChannelIndex index = clip.skeleton.first_channel(joint);
  for (const Channel& channel : clip.skeleton.channels(joint)) {
    const double sample = sample_in_rows(index++, frame);
    if (is_position(channel.kind)) {
      local.position[static_cast<int>(axis_of(channel.kind))] = sample;
    } else {
      local.rotation = local.rotation * glm::angleAxis(glm::radians(sample), axis_vector(axis_of(channel.kind)));
    }
  }
  return local;
}

void glm_quaternions(benchmark::State& state) {
  const BvhClip& clip = bench::clip();
  std::vector<QuaternionFrame> world(idx(clip.skeleton.joint_count()));
  for (auto _ : state) {
    float* out = position_room().data();
    for (FrameIndex frame = 0; frame < clip.motion.frame_count(); ++frame) {
      for (JointIndex joint = 0; joint < clip.skeleton.joint_count(); ++joint) {
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
  count_joint_frames(state, clip.motion.frame_count());
}

void marey_clip(benchmark::State& state) {
  const BvhClip& clip = bench::clip();
  for (auto _ : state) {
    compute_world_positions(clip.skeleton, clip.motion, {0, clip.motion.frame_count()}, PositionRule::Replace,
                            std::span<float>(position_room()));
  }
  count_joint_frames(state, clip.motion.frame_count());
}

// Frames `step` apart: 1 is playing, a large step is scrubbing, where no sample is in the cache.
void marey_single_poses(benchmark::State& state, int step) {
  const BvhClip& clip = bench::clip();
  LocalPose local;
  WorldPose world;
  local.resize(clip.skeleton);
  world.resize(clip.skeleton);
  FrameIndex frame = 0;
  for (auto _ : state) {
    compute_local_pose(clip.skeleton, clip.motion, frame, PositionRule::Replace, local);
    compute_world_pose(clip.skeleton, local, world);
    benchmark::DoNotOptimize(world.world_positions.data());
    frame = (frame + step) % clip.motion.frame_count();
  }
  count_joint_frames(state, 1);
}

void marey_node_path(benchmark::State& state) {
  const BvhClip& clip = bench::clip();
  for (auto _ : state) {
    compute_node_path(clip.skeleton, clip.motion, {0, clip.motion.frame_count()}, PositionRule::Replace, clip.skeleton.node_count() - 1,
                      std::span(position_room()).first(3 * idx(clip.motion.frame_count())));
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
