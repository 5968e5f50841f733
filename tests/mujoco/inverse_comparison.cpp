#include "tests/mujoco/inverse_comparison.h"

#include <array>
#include <span>

#include "core/biomechanics/mechanics.h"
#include "tests/mujoco/movement_comparison.h"
#include "tests/mujoco/spatial.h"

namespace marey::test {
namespace {

/// What acts on a body from its parent, at the body's origin.
Spatial load_of(const MujocoFigure& figure, int body) {
  const mjData* data = figure.data();
  const double* reference = data->subtree_com + 3 * figure.model()->body_rootid[body];
  Spatial result;
  mju_transformSpatial(result.values.data(), data->cfrc_int + 6 * body, 1, data->xpos + 3 * body, reference, nullptr);
  return result;
}

template <class T>
Spread spread_of(const T& a, const T& b) {
  Spread spread;
  spread.add(a, b);
  return spread;
}

void compare_whole(const RandomBody& body, const BodyMotion& motion, const MujocoFigure& figure, int which_case,
                   Deviations& deviations) {
  const mjData* data = figure.data();
  const BodyState state = find_body_state(motion, body.model, body.gravity_mps2, kMiddleFrame);
  const double mass = total_mass_kg(body.model);
  deviations.add("centre of mass", spread_of(state.com, vector_at(data->subtree_com)), which_case);
  deviations.add("momentum", spread_of(state.momentum, mass * vector_at(data->subtree_linvel)), which_case);
  deviations.add("angular momentum", spread_of(state.angular_momentum, vector_at(data->subtree_angmom)), which_case);
  deviations.add("kinetic energy", spread_of(state.kinetic_energy, data->energy[1]), which_case);
  Spread potential = spread_of(state.potential_energy, data->energy[0]);
  potential.widen(mass * glm::length(body.gravity_mps2) * glm::length(state.com));
  deviations.add("potential energy", potential, which_case);
}

/// What a freedom is given of a load: along the axis of the parent on which it slides, about the axis on which it turns.
struct Given {
  std::array<double, 6> values{};
  int count = 0;
  int torques = 0;  ///< how many of them, which stand behind the forces
};

Given given_to(const Freedom& freedom, const JointLoad& load, const JointState& joint, const glm::dquat& parent) {
  const int axis = static_cast<int>(freedom.axis);
  const glm::dvec3 torque = glm::conjugate(joint.rotation) * load.torque;
  switch (freedom.kind) {
    case FreedomKind::Slide: return {{(glm::conjugate(parent) * load.force)[axis]}, 1, 0};
    case FreedomKind::Hinge: return {{torque[axis]}, 1, 1};
    case FreedomKind::Turn: return {{torque.x, torque.y, torque.z}, 3, 3};
    case FreedomKind::Free: return {{load.force.x, load.force.y, load.force.z, torque.x, torque.y, torque.z}, 6, 3};
  }
  return {};
}

void compare_loads(const RandomBody& body, const BodyMotion& motion, const MujocoFigure& figure, int which_case,
                   Deviations& deviations) {
  const Skeleton& skeleton = body.clip.skeleton;
  const mjData* data = figure.data();
  std::vector<JointLoad> loads(idx(motion.joint_count));
  find_joint_loads(motion, skeleton, body.model, body.gravity_mps2, kMiddleFrame, {}, loads);
  Spread force;
  Spread torque;
  for (JointIndex joint = 0; joint < motion.joint_count; ++joint) {
    const Spatial load = load_of(figure, figure.body_of(joint));
    force.add(loads[idx(joint)].force, load.linear());
    torque.add(loads[idx(joint)].torque, load.angular());
  }
  Spread force_along = force;
  Spread torque_about = torque;
  Spread power;
  for (const Freedom& freedom : figure.freedoms()) {
    const JointIndex parent = skeleton.parent(freedom.joint);
    const JointLoad& load = loads[idx(freedom.joint)];
    const glm::dquat turn = parent == kNoParent ? glm::dquat(1.0, 0.0, 0.0, 0.0) : motion.state(kMiddleFrame, parent).rotation;
    const Given given = given_to(freedom, load, motion.state(kMiddleFrame, freedom.joint), turn);
    double work = 0.0;
    for (int i = 0; i < given.count; ++i) {
      const bool turns = i >= given.count - given.torques;
      const double found = data->qfrc_inverse[freedom.velocity + i];
      (turns ? torque_about : force_along).add(given.values[idx(i)], found);
      work += turns ? found * data->qvel[freedom.velocity + i] : 0.0;
    }
    if (given.torques > 0) power.add(load.power, work);
  }
  deviations.add("force", force, which_case);
  deviations.add("torque", torque, which_case);
  deviations.add("force of freedoms", force_along, which_case);
  deviations.add("torque of freedoms", torque_about, which_case);
  deviations.add("power", power, which_case);
}

}  // namespace

void compare_inverse(const RandomBody& body, const BodyMotion& motion, const MujocoFigure& figure, int which_case,
                     InverseDeviations& deviations) {
  const std::span<const JointState> states(&motion.state(kMiddleFrame, 0), idx(motion.joint_count));
  compare_movement(states, body.gravity_mps2, figure, which_case, deviations.movement);
  compare_whole(body, motion, figure, which_case, deviations.whole);
  compare_loads(body, motion, figure, which_case, deviations.loads);
}

}  // namespace marey::test
