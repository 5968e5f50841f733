#include "tests/mujoco/mujoco_state.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace marey::test {
namespace {

void store(const glm::dvec3& v, double* place) {
  for (int i = 0; i < 3; ++i) place[i] = v[i];
}

void store(const glm::dquat& q, double* place) {
  const std::array values = {q.w, q.x, q.y, q.z};
  std::copy(values.begin(), values.end(), place);
}

MujocoState make_state(const mjModel* model) {
  const std::vector<double> velocities(idx(model->nv), 0.0);
  return {std::vector<double>(idx(model->nq), 0.0), velocities, velocities};
}

/// How far along the axis of a slide the joint is from where the model has it: its offset.
double slid(const Clip& clip, const Freedom& slide, const glm::dvec3& from_parent_m) {
  const int axis = static_cast<int>(slide.axis);
  return from_parent_m[axis] - clip.settings.metres_per_unit * clip.skeleton.offset(slide.joint)[axis];
}

/// The angle about an axis, to the next whole turn; also of a turn about one axis and then about another.
double angle_about(const glm::dquat& q, Axis axis) {
  const double sine = std::array{q.x, q.y, q.z}[static_cast<std::size_t>(axis)];
  return 2.0 * std::atan2(sine, q.w);
}

void set_turn(const JointTrack& track, std::size_t frame, double* position, double* velocity, double* acceleration) {
  const glm::dquat& turn = track.rotations[frame];
  store(turn, position);
  store(glm::conjugate(turn) * track.angular_velocities[frame], velocity);
  store(glm::conjugate(turn) * track.angular_accelerations[frame], acceleration);
}

glm::dvec3 unit_of(Axis axis) {
  glm::dvec3 unit(0.0);
  unit[static_cast<int>(axis)] = 1.0;
  return unit;
}

/// The place of a joint in its parent, in metres, by its samples.
glm::dvec3 place_of(const Clip& clip, JointIndex joint, FrameIndex frame) {
  const Skeleton& skeleton = clip.skeleton;
  glm::dvec3 place = skeleton.offset(joint);
  for (int i = 0; i < skeleton.channel_count(joint); ++i) {
    const ChannelIndex channel = skeleton.first_channel(joint) + i;
    if (!is_position(skeleton.channel(channel).kind)) continue;
    const int axis = static_cast<int>(axis_of(skeleton.channel(channel).kind));
    const double start = skeleton.positions_add(joint, clip.settings.position_rule) ? place[axis] : 0.0;
    place[axis] = start + clip.motion.channel_samples(channel)[idx(frame)];
  }
  return clip.settings.metres_per_unit * place;
}

/// Writes the rotation of a joint by its samples as the angle of a hinge or as a quaternion.
void set_rotation(const Clip& clip, const Freedom& freedom, FrameIndex frame, double* place) {
  const Skeleton& skeleton = clip.skeleton;
  std::array<double, 4> turn = {1.0, 0.0, 0.0, 0.0};
  for (int i = 0; i < skeleton.channel_count(freedom.joint); ++i) {
    const ChannelIndex channel = skeleton.first_channel(freedom.joint) + i;
    if (!is_rotation(skeleton.channel(channel).kind)) continue;
    const double angle = clip.motion.channel_samples(channel)[idx(frame)] * std::numbers::pi / 180.0;
    if (freedom.kind == FreedomKind::Hinge) place[0] = angle;
    std::array<double, 3> axis{};
    axis[static_cast<std::size_t>(axis_of(skeleton.channel(channel).kind))] = 1.0;
    std::array<double, 4> step{};
    mju_axisAngle2Quat(step.data(), axis.data(), angle);
    const std::array<double, 4> before = turn;
    mju_mulQuat(turn.data(), before.data(), step.data());
  }
  if (freedom.kind != FreedomKind::Hinge) std::copy(turn.begin(), turn.end(), place);
}

std::vector<double> positions_of_samples(const MujocoFigure& figure, const Clip& clip, FrameIndex frame) {
  std::vector<double> positions(idx(figure.model()->nq), 0.0);
  for (const Freedom& freedom : figure.freedoms()) {
    double* place = positions.data() + freedom.position;
    const glm::dvec3 from_parent = place_of(clip, freedom.joint, frame);
    if (freedom.kind == FreedomKind::Slide) {
      *place = slid(clip, freedom, from_parent);
      continue;
    }
    if (freedom.kind == FreedomKind::Free) store(from_parent, place);
    set_rotation(clip, freedom, frame, freedom.kind == FreedomKind::Free ? place + 3 : place);
  }
  return positions;
}

}  // namespace

MujocoState state_of_tracks(const MujocoFigure& figure, const Clip& clip, std::span<const JointTrack> tracks, FrameIndex frame) {
  MujocoState state = make_state(figure.model());
  const std::size_t at = idx(frame);
  for (const Freedom& freedom : figure.freedoms()) {
    const JointTrack& track = tracks[idx(freedom.joint)];
    double* position = state.positions.data() + freedom.position;
    double* velocity = state.velocities.data() + freedom.velocity;
    double* acceleration = state.accelerations.data() + freedom.velocity;
    const int axis = static_cast<int>(freedom.axis);
    if (freedom.kind == FreedomKind::Slide) {
      *position = slid(clip, freedom, track.origin.positions[at]);
      *velocity = track.origin.velocities[at][axis];
      *acceleration = track.origin.accelerations[at][axis];
    } else if (freedom.kind == FreedomKind::Hinge) {
      *position = angle_about(track.rotations[at], freedom.axis);
      *velocity = track.angular_velocities[at][axis];
      *acceleration = track.angular_accelerations[at][axis];
    } else if (freedom.kind == FreedomKind::Turn) {
      set_turn(track, at, position, velocity, acceleration);
    } else {
      store(track.origin.positions[at], position);
      store(track.origin.velocities[at], velocity);
      store(track.origin.accelerations[at], acceleration);
      set_turn(track, at, position + 3, velocity + 3, acceleration + 3);
    }
  }
  return state;
}

MujocoState state_of_samples(const MujocoFigure& figure, const Clip& clip, FrameIndex frame) {
  MujocoState state = make_state(figure.model());
  state.positions = positions_of_samples(figure, clip, frame);
  std::vector<double> ahead = state.velocities;
  std::vector<double> back = state.velocities;
  const double time_s = clip.motion.frame_time_s();
  for (const auto& [step, difference] : {std::pair(1, &ahead), std::pair(-1, &back)}) {
    const std::vector<double> there = positions_of_samples(figure, clip, frame + step);
    mj_differentiatePos(figure.model(), difference->data(), time_s, state.positions.data(), there.data());
  }
  for (std::size_t i = 0; i < ahead.size(); ++i) {
    state.velocities[i] = 0.5 * (ahead[i] - back[i]);
    state.accelerations[i] = (ahead[i] + back[i]) / time_s;
  }
  return state;
}

MujocoState state_of_chain(const MujocoFigure& figure, const ChainState& chain) {
  MujocoState state = make_state(figure.model());
  JointIndex last = kNoParent;
  glm::dquat turned(1.0, 0.0, 0.0, 0.0);  // by the hinges of a joint so far
  for (const Freedom& freedom : figure.freedoms()) {
    if (std::exchange(last, freedom.joint) != freedom.joint) turned = glm::dquat(1.0, 0.0, 0.0, 0.0);
    const std::size_t joint = idx(freedom.joint);
    const glm::dvec3& turning = chain.angular_velocities[joint];
    double* position = state.positions.data() + freedom.position;
    double* velocity = state.velocities.data() + freedom.velocity;
    if (freedom.kind == FreedomKind::Slide) {
      *velocity = chain.velocities[joint][static_cast<int>(freedom.axis)];
      continue;
    }
    if (freedom.kind == FreedomKind::Hinge) {
      const glm::dvec3 axis = unit_of(freedom.axis);
      *position = angle_about(chain.rotations[joint], freedom.axis);
      *velocity = glm::dot(turned * axis, turning);
      turned = turned * glm::angleAxis(*position, axis);
      continue;
    }
    const int before = freedom.kind == FreedomKind::Free ? 3 : 0;
    if (before > 0) store(chain.positions[joint], position);
    if (before > 0) store(chain.velocities[joint], velocity);
    store(chain.rotations[joint], position + before);
    store(glm::conjugate(chain.rotations[joint]) * turning, velocity + before);
  }
  return state;
}

void give_state(const MujocoFigure& figure, const MujocoState& state) {
  mjData* data = figure.data();
  std::copy(state.positions.begin(), state.positions.end(), data->qpos);
  std::copy(state.velocities.begin(), state.velocities.end(), data->qvel);
  std::copy(state.accelerations.begin(), state.accelerations.end(), data->qacc);
}

void find_inverse(const MujocoFigure& figure, const MujocoState& state) {
  give_state(figure, state);
  const mjModel* model = figure.model();
  mjData* data = figure.data();
  // On its way MuJoCo factors the mass matrix, which is singular where a joint without mass can turn beside the next one. Nothing
  // here rests on the factors; a warning that was already counted is not given.
  data->warning[mjWARN_INERTIA].number = 1;
  mj_inverse(model, data);
  mj_rnePostConstraint(model, data);
  mj_subtreeVel(model, data);
  mj_energyPos(model, data);
  mj_energyVel(model, data);
}

void find_forward(const MujocoFigure& figure, const MujocoState& state) {
  give_state(figure, state);
  mj_forward(figure.model(), figure.data());
  mj_rnePostConstraint(figure.model(), figure.data());
}

}  // namespace marey::test
