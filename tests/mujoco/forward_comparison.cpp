#include "tests/mujoco/forward_comparison.h"

#include <algorithm>
#include <cmath>

#include "core/biomechanics/passive_chain.h"
#include "tests/core/kinematics/figures.h"
#include "tests/mujoco/movement_comparison.h"

namespace marey::test {
namespace {

/// How many of a freedom's velocities are those of sliding; these come first.
int slides_of(FreedomKind kind) { return kind == FreedomKind::Free ? 3 : kind == FreedomKind::Slide ? 1 : 0; }

int turns_of(FreedomKind kind) {
  if (kind == FreedomKind::Slide) return 0;
  return kind == FreedomKind::Hinge ? 1 : 3;
}

/// The link that a freedom turns: of two hinges the one about its axis.
int turned_link(const ChainLinks& links, const Freedom& freedom) {
  const int last = links.first_links[idx(freedom.joint) + 1] - 1;
  const bool is_last = freedom.kind != FreedomKind::Hinge || links.links[idx(last)].axis[static_cast<int>(freedom.axis)] > 0.0;
  return is_last ? last : last - 1;
}

/// Marey's accelerations as MuJoCo counts them: qacc.
std::vector<double> find_accelerations(const ChainLinks& links, const glm::dvec3& gravity_mps2, const MujocoFigure& figure) {
  std::vector<glm::dvec3> found(links.links.size());
  ArticulatedBody(links.links, gravity_mps2).find_accelerations(links.states, found);
  std::vector<double> accelerations(idx(figure.model()->nv));
  for (const Freedom& freedom : figure.freedoms()) {
    double* place = accelerations.data() + freedom.velocity;
    const int axis = static_cast<int>(freedom.axis);
    const glm::dvec3& slide = found[idx(links.first_links[idx(freedom.joint)])];
    const glm::dvec3& turn = found[idx(turned_link(links, freedom))];
    const int slides = slides_of(freedom.kind);
    const int turns = turns_of(freedom.kind);
    for (int i = 0; i < slides; ++i) *place++ = slide[slides == 1 ? axis : i];
    for (int i = 0; i < turns; ++i) *place++ = turn[turns == 1 ? axis : i];
  }
  return accelerations;
}

void compare_freedoms(std::span<const double> accelerations, const MujocoFigure& figure, int which_case,
                      ForwardDeviations& deviations) {
  mjData* data = figure.data();
  Spread slide;
  Spread turn;
  Spread force;
  Spread torque;
  const std::vector<double> found(data->qacc, data->qacc + accelerations.size());
  std::copy(accelerations.begin(), accelerations.end(), data->qacc);
  mj_inverse(figure.model(), data);
  for (const Freedom& freedom : figure.freedoms()) {
    const int end_of_slides = freedom.velocity + slides_of(freedom.kind);
    for (int i = freedom.velocity; i < end_of_slides + turns_of(freedom.kind); ++i) {
      (i < end_of_slides ? slide : turn).add(accelerations[idx(i)], found[idx(i)]);
      if (i >= end_of_slides) turn.widen(data->qvel[i] * data->qvel[i]);
      (i < end_of_slides ? force : torque).add(data->qfrc_inverse[i], 0.0);
      (i < end_of_slides ? force : torque).widen(std::abs(data->qfrc_bias[i]));
    }
  }
  deviations.freedoms.add("sliding", slide, which_case);
  deviations.freedoms.add("turning", turn, which_case);
  deviations.loads.add("force", force, which_case);
  deviations.loads.add("torque", torque, which_case);
}

}  // namespace

Clip find_let_go_clip(const Clip& clip, const ChainState& state, bool root_held) {
  const Skeleton& skeleton = clip.skeleton;
  std::vector<figures::JointPlan> plan;
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    const JointIndex parent = skeleton.parent(joint);
    std::vector<ChannelKind> channels = figures::channels(parent == kNoParent && !root_held ? "xyz" : "");
    for (const Channel& channel : skeleton.channels(joint)) {
      if (is_rotation(channel.kind)) channels.push_back(channel.kind);
    }
    plan.push_back({skeleton.name(joint), parent, state.positions[idx(joint)], channels, {}});
  }
  Clip result;
  result.skeleton = figures::make_skeleton(plan);
  result.settings.metres_per_unit = 1.0;
  return result;
}

void compare_forward(const RandomBody& body, const ChainState& state, bool root_held, const MujocoFigure& figure, int which_case,
                     ForwardDeviations& deviations) {
  const Skeleton& skeleton = body.clip.skeleton;
  const auto chain = PassiveChain::make(skeleton, body.model, state, {root_held, body.gravity_mps2});
  compare_movement(chain.value().world_states(), body.gravity_mps2, figure, which_case, deviations.movement);
  const ChainLinks links = make_chain_links(skeleton, body.model, state, root_held);
  compare_freedoms(find_accelerations(links, body.gravity_mps2, figure), figure, which_case, deviations);
}

}  // namespace marey::test
