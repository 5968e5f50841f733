#pragma once

#include <span>
#include <vector>

#include "core/biomechanics/chain_links.h"
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

/// The pose and the speeds that a figure is let go with, accelerations 0. `figure` is made of find_let_go_clip() with
/// TwoAxes::Hinges; of an angular velocity a hinge takes what is along its axis.
[[nodiscard]] MujocoState state_of_chain(const MujocoFigure& figure, const ChainState& chain);

/// Writes the state into `figure`'s data, from which MuJoCo's functions take it.
void give_state(const MujocoFigure& figure, const MujocoState& state);

/// Gives the state to MuJoCo and has it compute what it can: inverse dynamics, accelerations of bodies and forces between them,
/// momenta, energies.
void find_inverse(const MujocoFigure& figure, const MujocoState& state);

/// Gives positions and velocities to MuJoCo and has it find the accelerations of freedoms and bodies by gravity alone.
void find_forward(const MujocoFigure& figure, const MujocoState& state);

}  // namespace marey::test
