#pragma once

#include <span>

#include "core/biomechanics/body_motion.h"
#include "tests/mujoco/deviations.h"
#include "tests/mujoco/mujoco_figure.h"

namespace marey::test {

/// Compares how all joints move in the world, `states` by joint, with what MuJoCo has of their bodies after
/// mj_rnePostConstraint(): place, velocity and acceleration, and the same of the rotation, each relative to its largest value,
/// angular acceleration also to the square of the fastest turning.
void compare_movement(std::span<const JointState> states, const glm::dvec3& gravity_mps2, const MujocoFigure& figure,
                      int which_case, Deviations& deviations);

}  // namespace marey::test
