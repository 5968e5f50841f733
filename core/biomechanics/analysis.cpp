#include "core/biomechanics/analysis.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "core/base/counted.h"
#include "core/biomechanics/quantity.h"
#include "core/kinematics/forward_kinematics.h"
#include "core/math/angle.h"

namespace marey {
namespace {

constexpr double kNotDefined = std::numeric_limits<double>::quiet_NaN();

Error refusal(std::string message) { return {DiagnosticCode::InvalidArgument, {}, std::move(message), {}, {}}; }

AnalysisColumn make_column(const AskedQuantity& asked, char component) {
  const std::string_view unit = asked.quantity->unit;
  std::string name = component == 0 ? fmt::format("{}[{}]", asked.label, unit) : fmt::format("{}.{}[{}]", asked.label, component, unit);
  return {std::move(name), asked.quantity, asked.node, component, {}};
}

/// All that columns are made of; mechanics only where the request needs them.
class Analysis {
 public:
  Analysis(const Clip& clip, const AnalysisRequest& request, BodyMotion body)
      : clip_(clip), request_(request), body_(std::move(body)) {
    gravity_ = glm::dvec3(0.0);
    gravity_[static_cast<int>(clip.settings.up_axis)] = -9.81;
    if (request.model && request.model->gravity_mps2) gravity_ = *request.model->gravity_mps2;
  }

  void find_positions();
  void find_mechanics();
  void add_columns(const AskedQuantity& asked, AnalysisTable& table) const;
  void add_notes(AnalysisTable& table) const;

 private:
  [[nodiscard]] bool is_ground(FrameIndex frame) const;
  void find_frame_loads(FrameIndex frame);
  [[nodiscard]] bool is_defined(const Quantity& quantity, FrameIndex frame) const;
  [[nodiscard]] glm::dvec3 vector_of(const AskedQuantity& asked, FrameIndex frame) const;
  [[nodiscard]] double number_of(const AskedQuantity& asked, FrameIndex frame) const;
  void add_angles(const AskedQuantity& asked, AnalysisTable& table) const;
  [[nodiscard]] PointTrack track_of(NodeIndex node) const;

  [[nodiscard]] const JointLoad& load(FrameIndex frame, JointIndex joint) const {
    return loads_[idx(frame) * idx(body_.joint_count) + idx(joint)];
  }

  const Clip& clip_;
  const AnalysisRequest& request_;
  BodyMotion body_;
  glm::dvec3 gravity_;
  SupportKind support_ = SupportKind::Flight;  // never Auto
  bool follows_contacts_ = false;              // ground and flight in turn
  Contacts contacts_;
  std::vector<BodyState> states_;
  std::vector<GroundReaction> reactions_;
  std::vector<JointLoad> loads_;
  int shared_frames_ = 0;  // in which more than one point touches
  std::vector<double> positions_m_;  // [frame][node][x y z]
};

void Analysis::find_positions() {
  positions_m_.resize(idx(body_.frame_count) * idx(clip_.skeleton.node_count()) * 3);
  compute_world_positions(clip_.skeleton, clip_.motion, {0, body_.frame_count}, clip_.settings.position_rule, positions_m_);
  for (double& coordinate : positions_m_) coordinate *= body_.metres_per_unit;
}

void Analysis::find_mechanics() {
  const Skeleton& skeleton = clip_.skeleton;
  support_ = request_.support;
  if (support_ == SupportKind::Auto) {
    support_ = roots_stand_still(body_, skeleton) ? SupportKind::Pivot : SupportKind::Ground;
    follows_contacts_ = support_ == SupportKind::Ground;
  }
  if (support_ == SupportKind::Ground) contacts_ = find_contacts(body_, skeleton, clip_.settings.up_axis);
  loads_.resize(idx(body_.frame_count) * idx(body_.joint_count));
  for (FrameIndex frame = 0; frame < body_.frame_count; ++frame) {
    states_.push_back(find_body_state(body_, *request_.model, gravity_, frame));
    find_frame_loads(frame);
  }
}

bool Analysis::is_ground(FrameIndex frame) const {
  return support_ == SupportKind::Ground && (!follows_contacts_ || contacts_.any_down(frame));
}

void Analysis::find_frame_loads(FrameIndex frame) {
  const BodyModel& model = *request_.model;
  const std::span<JointLoad> loads = std::span(loads_).subspan(idx(frame) * idx(body_.joint_count), idx(body_.joint_count));
  GroundReaction reaction{glm::dvec3(0.0), glm::dvec3(kNotDefined)};
  std::vector<OuterForce> outer;
  if (is_ground(frame)) {
    reaction = find_ground_reaction(states_.back(), total_mass_kg(model), gravity_, clip_.settings.up_axis, contacts_.floor_m);
    outer = share_out(reaction, states_.back(), body_, contacts_, frame);
    shared_frames_ += outer.size() > 1 ? 1 : 0;
  }
  find_joint_loads(body_, clip_.skeleton, model, gravity_, frame, outer, loads);
  if (support_ == SupportKind::Pivot) {
    for (JointIndex joint = 0; joint < body_.joint_count; ++joint) {
      if (clip_.skeleton.parent(joint) == kNoParent) reaction.force += loads[idx(joint)].force;
    }
  }
  reactions_.push_back(reaction);
}

bool Analysis::is_defined(const Quantity& quantity, FrameIndex frame) const {
  if (quantity.level == DerivativeLevel::Pose) return true;
  const bool is_fitted =
      request_.derivation.kind == DerivationKind::SavitzkyGolay || request_.derivation.kind == DerivationKind::Gcv;
  return is_fitted || (frame > 0 && frame + 1 < body_.frame_count);
}

// The path of a point in the file's own pose, differentiated as it is seen.
PointTrack Analysis::track_of(NodeIndex node) const {
  std::vector<glm::dvec3> path(idx(body_.frame_count));
  for (FrameIndex frame = 0; frame < body_.frame_count; ++frame) {
    const double* at = positions_m_.data() + 3 * (idx(frame) * idx(clip_.skeleton.node_count()) + idx(node));
    path[idx(frame)] = {at[0], at[1], at[2]};
  }
  return differentiate_path(std::move(path), request_.derivation, 1.0 / body_.frame_time_s);
}

glm::dvec3 Analysis::vector_of(const AskedQuantity& asked, FrameIndex frame) const {
  switch (asked.quantity->kind) {
    case QuantityKind::Force: return load(frame, clip_.skeleton.node(asked.node).joint).force;
    case QuantityKind::Torque: return load(frame, clip_.skeleton.node(asked.node).joint).torque;
    case QuantityKind::Com: return states_[idx(frame)].com;
    case QuantityKind::ComVelocity: return states_[idx(frame)].com_velocity;
    case QuantityKind::Momentum: return states_[idx(frame)].momentum;
    case QuantityKind::AngularMomentum:
      if (asked.node == kNoParent) return states_[idx(frame)].angular_momentum;
      return angular_momentum_about(states_[idx(frame)], body_.state(frame, clip_.skeleton.node(asked.node).joint).position);
    case QuantityKind::Reaction: return reactions_[idx(frame)].force;
    case QuantityKind::CentreOfPressure: return reactions_[idx(frame)].centre_of_pressure;
    case QuantityKind::AngularVelocity: return body_.state(frame, clip_.skeleton.node(asked.node).joint).angular_velocity;
    default: return body_.state(frame, clip_.skeleton.node(asked.node).joint).angular_acceleration;
  }
}

double Analysis::number_of(const AskedQuantity& asked, FrameIndex frame) const {
  switch (asked.quantity->kind) {
    case QuantityKind::Power: return load(frame, clip_.skeleton.node(asked.node).joint).power;
    case QuantityKind::KineticEnergy: return states_[idx(frame)].kinetic_energy;
    default: return states_[idx(frame)].potential_energy;
  }
}

void Analysis::add_angles(const AskedQuantity& asked, AnalysisTable& table) const {
  const JointIndex joint = clip_.skeleton.node(asked.node).joint;
  for (int i = 0; i < clip_.skeleton.channel_count(joint); ++i) {
    const ChannelIndex channel = clip_.skeleton.first_channel(joint) + i;
    const ChannelKind kind = clip_.skeleton.channel(channel).kind;
    if (!is_rotation(kind)) continue;
    AnalysisColumn column = make_column(asked, "xyz"[static_cast<int>(axis_of(kind))]);
    double previous_deg = 0.0;
    for (const double sample : clip_.motion.channel_samples(channel)) {
      previous_deg = column.values.empty() ? sample : nearest_turn(sample, previous_deg);
      column.values.push_back(to_radians(previous_deg));
    }
    table.columns.push_back(std::move(column));
  }
}

void Analysis::add_columns(const AskedQuantity& asked, AnalysisTable& table) const {
  const Quantity& quantity = *asked.quantity;
  if (quantity.kind == QuantityKind::Angle) return add_angles(asked, table);
  const int components = quantity.is_vector ? 3 : 1;
  const std::size_t first = table.columns.size();
  for (int c = 0; c < components; ++c) {
    table.columns.push_back(make_column(asked, quantity.is_vector ? "xyz"[c] : '\0'));
    table.columns.back().values.assign(idx(body_.frame_count), kNotDefined);
  }
  const PointTrack track = quantity.owner == QuantityOwner::Point ? track_of(asked.node) : PointTrack{};
  const std::vector<glm::dvec3>& path = quantity.kind == QuantityKind::Position   ? track.positions
                                        : quantity.kind == QuantityKind::Velocity ? track.velocities
                                                                                  : track.accelerations;
  for (FrameIndex frame = 0; frame < body_.frame_count; ++frame) {
    if (!is_defined(quantity, frame)) continue;
    if (!quantity.is_vector) {
      table.columns[first].values[idx(frame)] = number_of(asked, frame);
      continue;
    }
    const glm::dvec3 vector = path.empty() ? vector_of(asked, frame) : path[idx(frame)];
    for (int c = 0; c < 3; ++c) table.columns[first + idx(c)].values[idx(frame)] = vector[c];
  }
}

void Analysis::add_notes(AnalysisTable& table) const {
  if (!request_.model || !request_.model->metres_per_unit) {
    table.notes.push_back(fmt::format("A unit of the file is taken for {:g} m.", body_.metres_per_unit));
  }
  if (states_.empty()) return;
  if (support_ == SupportKind::Pivot) {
    table.notes.emplace_back("Held at its root; the torque there is a residual, as a bar passes on next to none.");
  } else if (support_ == SupportKind::Flight) {
    table.notes.emplace_back("In flight; force and torque at the root are residuals.");
  } else if (shared_frames_ > 0) {
    table.notes.push_back(fmt::format("On the ground with more than one point in {}: how they share the reaction is an estimate.",
                                      counted(shared_frames_, "frame")));
  }
}

}  // namespace

Result<AnalysisTable> analyse(const Clip& clip, const AnalysisRequest& request) {
  Result<std::vector<AskedQuantity>> asked = find_quantities(clip.skeleton, request.quantities);
  if (!asked) return asked.error();
  asked->insert(asked->end(), request.asked.begin(), request.asked.end());
  const auto needs_body = std::find_if(asked->begin(), asked->end(), [](const AskedQuantity& a) { return a.quantity->needs_body; });
  if (needs_body != asked->end()) {
    if (!request.model) {
      return refusal(fmt::format("'{}' needs the masses of the segments; give a model of the body, or a table to make one by.",
                                 needs_body->quantity->name));
    }
    if (Status status = check_body_model(*request.model, clip.skeleton); !status) return status.error();
  }
  const bool has_unit = request.model && request.model->metres_per_unit;
  const double unit = has_unit ? *request.model->metres_per_unit : clip.settings.metres_per_unit;
  const double frame_time = request.frame_time_s.value_or(clip.motion.frame_time_s());
  if (!(frame_time > 0.0)) return refusal("The clip has no frame time; give one.");
  Result<BodyMotion> body = find_body_motion(clip, request.derivation, frame_time, unit);
  if (!body) return body.error();
  Analysis analysis(clip, request, std::move(*body));
  const bool has_points = std::any_of(asked->begin(), asked->end(),
                                      [](const AskedQuantity& a) { return a.quantity->owner == QuantityOwner::Point; });
  if (has_points) analysis.find_positions();
  if (needs_body != asked->end()) analysis.find_mechanics();
  AnalysisTable table;
  for (const AskedQuantity& quantity : *asked) analysis.add_columns(quantity, table);
  analysis.add_notes(table);
  return table;
}

}  // namespace marey
