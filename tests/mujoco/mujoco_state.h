#pragma once

#include <span>
#include <vector>

#include "core/biomechanics/joint_tracks.h"
#include "tests/mujoco/mujoco_figure.h"

namespace marey::test {

/// A state in MuJoCo's coordinates: SI, radians, quaternions w x y z. Places in it: MujocoFigure::freedoms().
struct MujocoState {
  std::vector<double> positions;      ///< qpos
  std::vector<double> velocities;     ///< qvel
  std::vector<double> accelerations;  ///< qacc
};

/// The state that Marey's tracks have at a frame: those of all joints, of one clip, which `figure` was made of.
[[nodiscard]] MujocoState state_of_tracks(const MujocoFigure& figure, const Clip& clip, std::span<const JointTrack> tracks,
                                          FrameIndex frame);

/// The state at a frame that is not at an end, by nothing of Marey's but the samples: MuJoCo makes quaternions of the angles and
/// takes the differences to the neighbouring frames.
[[nodiscard]] MujocoState state_of_samples(const MujocoFigure& figure, const Clip& clip, FrameIndex frame);

/// Writes the state into `figure`'s data, from which MuJoCo's functions take it.
void give_state(const MujocoFigure& figure, const MujocoState& state);

/// Gives the state to MuJoCo and has it compute what it can: inverse dynamics, accelerations of bodies and forces between them,
/// momenta, energies.
void find_inverse(const MujocoFigure& figure, const MujocoState& state);

}  // namespace marey::test
