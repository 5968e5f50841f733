#include "tests/mujoco/movement_comparison.h"

#include <array>

#include "tests/mujoco/spatial.h"

namespace marey::test {
namespace {

Spatial velocity_of(const MujocoFigure& figure, int body) {
  Spatial result;
  mj_objectVelocity(figure.model(), figure.data(), mjOBJ_XBODY, body, result.values.data(), 0);
  return result;
}

/// As an accelerometer feels it: gravity pulls all bodies up.
Spatial acceleration_of(const MujocoFigure& figure, int body) {
  Spatial result;
  mj_objectAcceleration(figure.model(), figure.data(), mjOBJ_XBODY, body, result.values.data(), 0);
  return result;
}

}  // namespace

void compare_movement(std::span<const JointState> states, const glm::dvec3& gravity_mps2, const MujocoFigure& figure,
                      int which_case, Deviations& deviations) {
  std::array<Spread, 6> spreads;
  auto& [position, velocity, acceleration, orientation, angular_velocity, angular_acceleration] = spreads;
  for (std::size_t joint = 0; joint < states.size(); ++joint) {
    const JointState& state = states[joint];
    const int number = figure.body_of(static_cast<JointIndex>(joint));
    position.add(state.position, vector_at(figure.data()->xpos + 3 * number));
    for (int axis = 0; axis < 3; ++axis) {
      const double* matrix = figure.data()->xmat + 9 * number;
      orientation.add(glm::mat3_cast(state.rotation)[axis], {matrix[axis], matrix[3 + axis], matrix[6 + axis]});
    }
    const Spatial moving = velocity_of(figure, number);
    velocity.add(state.velocity, moving.linear());
    angular_velocity.add(state.angular_velocity, moving.angular());
    const Spatial felt = acceleration_of(figure, number);
    acceleration.add(state.acceleration - gravity_mps2, felt.linear());
    angular_acceleration.add(state.angular_acceleration, felt.angular());
    angular_acceleration.widen(glm::dot(state.angular_velocity, state.angular_velocity));
  }
  constexpr std::array kNames = {"position",    "velocity",         "acceleration",
                                 "orientation", "angular velocity", "angular acceleration"};
  for (std::size_t i = 0; i < kNames.size(); ++i) deviations.add(kNames[i], spreads[i], which_case);
}

}  // namespace marey::test
