#pragma once

#include "core/biomechanics/chain_links.h"
#include "tests/mujoco/deviations.h"
#include "tests/mujoco/mujoco_figure.h"
#include "tests/mujoco/random_body.h"

namespace marey::test {

/// What MuJoCo is told of a figure that is let go: the same tree in metres, joints where `state` has them, turning by the
/// channels that they have. No position has a channel but those of free roots, which have three.
[[nodiscard]] Clip find_let_go_clip(const Clip& clip, const ChainState& state, bool root_held);

/// What was compared, over many cases.
struct ForwardDeviations {
  Deviations freedoms;  ///< accelerations along and about them
  Deviations movement;  ///< of the joints in the world, see compare_movement()
  Deviations loads;     ///< forces and torques of freedoms that Marey's accelerations take, if one asks MuJoCo: none
};

/// Compares the accelerations that Marey finds with what find_forward() has left in `figure`, which is then used up.
/// Accelerations are relative to the largest in the body, those of turning also to the square of the fastest turning, as a body
/// may keep its speed; how close they are hangs on how well the masses tell the freedoms apart. Loads, for which that is all
/// one, are relative to the largest that it takes to accelerate no freedom.
void compare_forward(const RandomBody& body, const ChainState& state, bool root_held, const MujocoFigure& figure, int which_case,
                     ForwardDeviations& deviations);

}  // namespace marey::test
