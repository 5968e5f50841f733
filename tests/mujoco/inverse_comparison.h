#pragma once

#include "core/biomechanics/body_motion.h"
#include "tests/mujoco/deviations.h"
#include "tests/mujoco/mujoco_figure.h"
#include "tests/mujoco/random_body.h"

namespace marey::test {

/// What was compared, over many cases. Each is relative to its largest value in the body.
struct InverseDeviations {
  Deviations movement;  ///< of the joints: place, velocity, acceleration and the same of the rotation
  Deviations whole;     ///< centre of mass, momenta, energies
  Deviations loads;     ///< forces and torques in all joints, and along their freedoms; powers
};

/// Compares Marey's view of the middle frame with what find_inverse() has left in `figure`. The state is given; what is compared
/// of it is how it adds up from joint to joint.
void compare_inverse(const RandomBody& body, const BodyMotion& motion, const MujocoFigure& figure, int which_case,
                     InverseDeviations& deviations);

}  // namespace marey::test
