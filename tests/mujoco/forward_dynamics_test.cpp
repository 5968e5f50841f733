// Figures that are let go, against MuJoCo: by gravity alone they accelerate and move alike.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "core/biomechanics/passive_chain.h"
#include "tests/mujoco/forward_comparison.h"
#include "tests/mujoco/mujoco_state.h"
#include "tests/mujoco/spatial.h"

namespace marey::test {
namespace {

/// A figure about to be let go, moving; in every other case its roots are held.
struct LetGo {
  RandomBody body;
  ChainState state;
  bool root_held = false;

  [[nodiscard]] MujocoFigure figure() const {
    return {find_let_go_clip(body.clip, state, root_held), body.model, body.gravity_mps2, TwoAxes::Hinges};
  }
  [[nodiscard]] PassiveChain chain() const {
    return PassiveChain::make(body.clip.skeleton, body.model, state, {root_held, body.gravity_mps2}).value();
  }
};

LetGo let_go_of_case(int which_case) {
  LetGo result{body_of_case(which_case), {}, which_case % 2 == 0};
  Random random(static_cast<std::uint64_t>(which_case));
  fill_turning_joints(random, result.body);
  result.state = find_chain_state(result.body.clip, kMiddleFrame, true).value();
  return result;
}

// How close accelerations are hangs on the masses: a joint that little else holds may be thrown. The loads do not.
TEST(Mujoco, AcceleratesAlike) {
  ForwardDeviations deviations;
  int freedoms = 0;
  const int cases = body_cases();
  for (int i = 0; i < cases; ++i) {
    const LetGo let_go = let_go_of_case(i);
    const MujocoFigure figure = let_go.figure();
    find_forward(figure, state_of_chain(figure, let_go.state));
    compare_forward(let_go.body, let_go.state, let_go.root_held, figure, i, deviations);
    freedoms += figure.model()->nv;
  }
  expect_at_most(deviations.freedoms, 1e-9);
  expect_at_most(deviations.movement, 1e-10);
  expect_at_most(deviations.loads, 1e-11);
  std::cout << fmt::format("{} bodies with {} freedoms let go beside MuJoCo {}\n", cases, freedoms, mj_versionString());
  report("let go, freedoms", deviations.freedoms);
  report("let go, movement", deviations.movement);
  report("let go, loads left over", deviations.loads);
}

// Where a body that falls turns about one axis alone, its acceleration is 0 whatever its masses are.
TEST(Mujoco, SeesAMillionthOfWhatIsLetGo) {
  int seen = 0;
  for (int i = 0; i < 50; ++i) {
    LetGo let_go = let_go_of_case(i);
    const MujocoFigure figure = let_go.figure();
    find_forward(figure, state_of_chain(figure, let_go.state));
    let_go.body.model.segments.back().com_m *= 1.000001;
    ForwardDeviations deviations;
    compare_forward(let_go.body, let_go.state, let_go.root_held, figure, i, deviations);
    EXPECT_GT(std::max(deviations.loads.largest("force"), deviations.loads.largest("torque")), 1e-10) << i;
    seen += deviations.freedoms.largest("turning") > 1e-9 ? 1 : 0;
  }
  EXPECT_GE(seen, 45);
}

/// Where the joints are after some time, by MuJoCo's Runge-Kutta method.
std::vector<glm::dvec3> places_after(double seconds, int steps, const LetGo& let_go) {
  const MujocoFigure figure = let_go.figure();
  give_state(figure, state_of_chain(figure, let_go.state));
  figure.model()->opt.integrator = mjINT_RK4;
  figure.model()->opt.timestep = seconds / steps;
  for (int i = 0; i < steps; ++i) mj_step(figure.model(), figure.data());
  mj_kinematics(figure.model(), figure.data());
  std::vector<glm::dvec3> places;
  for (JointIndex joint = 0; joint < let_go.body.clip.skeleton.joint_count(); ++joint) {
    places.push_back(vector_at(figure.data()->xpos + 3 * figure.body_of(joint)));
  }
  return places;
}

// MuJoCo adds up the angular velocities of a step as if turns could change places, so that half the step leaves a quarter of the
// error: what two runs differ by takes off most of it (Richardson). Of the rest, which grows wherever a figure throws a joint
// about, no more than a twentieth of that difference is let pass.
TEST(Mujoco, MovesAlike) {
  constexpr int kFigures = 30;
  constexpr int kSteps = 1000;
  constexpr double kTime_s = 0.2;
  Deviations deviations;
  for (int i = 0; i < kFigures; ++i) {
    const LetGo let_go = let_go_of_case(i);
    const std::vector<glm::dvec3> coarse = places_after(kTime_s, kSteps, let_go);
    const std::vector<glm::dvec3> fine = places_after(kTime_s, 2 * kSteps, let_go);
    PassiveChain chain = let_go.chain();
    ASSERT_TRUE(chain.advance(kTime_s)) << i;
    const std::vector<JointState> states = chain.world_states();
    Spread place;
    Spread between_runs;
    for (std::size_t joint = 0; joint < fine.size(); ++joint) {
      place.add(states[joint].position, fine[joint] + (fine[joint] - coarse[joint]) / 3.0);
      between_runs.add(coarse[joint], fine[joint]);
    }
    EXPECT_LE(place.relative(), 1e-6 + 0.05 * between_runs.relative()) << i;
    deviations.add("places of joints", place, i);
    deviations.add("between its own two runs", between_runs, i);
  }
  report(fmt::format("{} bodies let go for {} s", kFigures, kTime_s), deviations);
}

}  // namespace
}  // namespace marey::test
