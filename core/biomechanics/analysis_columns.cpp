#include "core/biomechanics/analysis_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/biomechanics/joint_angles.h"
#include "core/math/angle.h"
#include "core/math/rotation_vector.h"

namespace marey {
namespace {

constexpr double kNotDefined = std::numeric_limits<double>::quiet_NaN();

/// A value per frame; a quantity without direction has it in x.
using Values = std::vector<glm::dvec3>;

AnalysisColumn make_column(const AskedQuantity& asked, char component) {
  const std::string_view unit = asked.quantity->unit;
  std::string name = component == 0 ? fmt::format("{}[{}]", asked.label, unit) : fmt::format("{}.{}[{}]", asked.label, component, unit);
  return {std::move(name), asked, component, {}};
}

bool is_defined(const AnalysedClip& clip, DerivativeLevel level, FrameIndex frame) {
  if (level == DerivativeLevel::Pose) return true;
  const DerivationKind kind = clip.request().derivation.kind;
  const bool is_fitted = kind == DerivationKind::SavitzkyGolay || kind == DerivationKind::Gcv || kind == DerivationKind::Spline;
  return is_fitted || (frame > 0 && frame + 1 < clip.body().frame_count);
}

/// Makes the values of one quantity.
class ValueMaker {
 public:
  ValueMaker(const AnalysedClip& clip, const AskedQuantity& asked)
      : clip_(clip), asked_(asked), joint_(asked.node == kNoParent ? kNoParent : clip.clip().skeleton.node(asked.node).joint) {}

  [[nodiscard]] Values make() const {
    switch (asked_.quantity->kind) {
      case QuantityKind::Position: return track().positions;
      case QuantityKind::Velocity: return track().velocities;
      case QuantityKind::Acceleration: return track().accelerations;
      case QuantityKind::PathLength: return path_length();
      case QuantityKind::PlaneAngle: return plane_angles();
      case QuantityKind::Work: return work();
      default: break;
    }
    return for_each_frame([&](FrameIndex frame) { return asked_.quantity->is_vector ? vector_at(frame) : glm::dvec3(number_at(frame)); });
  }

  /// The rotation of the joint in its parent, or in the frame that it is seen from, as the file has it.
  [[nodiscard]] glm::dquat rotation_at(FrameIndex frame) const {
    const JointIndex other = asked_.frame.value_or(clip_.clip().skeleton.parent(joint_));
    const glm::dquat& own = clip_.poses().rotation(frame, joint_);
    return other == kNoParent ? own : glm::conjugate(clip_.poses().rotation(frame, other)) * own;
  }

 private:
  template <class ValueAt>
  [[nodiscard]] Values for_each_frame(const ValueAt& value_at) const {
    Values values(idx(clip_.body().frame_count));
    for (FrameIndex frame = 0; frame < size_of(values); ++frame) values[idx(frame)] = value_at(frame);
    return values;
  }

  [[nodiscard]] bool is_seen_from_joint() const { return asked_.frame.value_or(kNoParent) != kNoParent; }

  [[nodiscard]] JointState frame_at(FrameIndex frame) const {
    return is_seen_from_joint() ? clip_.body().state(frame, *asked_.frame) : JointState{};
  }

  // A path is differentiated as it is seen, in the file's own pose.
  [[nodiscard]] PointTrack track() const {
    const FilePoses& poses = clip_.poses();
    const Values path = for_each_frame([&](FrameIndex frame) {
      glm::dvec3 place = poses.position(frame, asked_.node);
      if (asked_.point_m != glm::dvec3(0.0)) place += poses.rotation(frame, joint_) * asked_.point_m;
      if (!is_seen_from_joint()) return place;
      const NodeIndex origin = clip_.clip().skeleton.node_of(*asked_.frame);
      return glm::conjugate(poses.rotation(frame, *asked_.frame)) * (place - poses.position(frame, origin));
    });
    return differentiate_path(path, clip_.request().derivation, 1.0 / clip_.body().frame_time_s);
  }

  [[nodiscard]] Values path_length() const {
    const Values path = track().positions;
    Values lengths(path.size(), glm::dvec3(0.0));
    for (std::size_t i = 1; i < path.size(); ++i) lengths[i].x = lengths[i - 1].x + glm::distance(path[i - 1], path[i]);
    return lengths;
  }

  [[nodiscard]] Values plane_angles() const {
    const NodeIndex tip = find_bone_tip(clip_.clip().skeleton, joint_);
    const NodeIndex origin = clip_.clip().skeleton.node_of(joint_);
    const FilePoses& poses = clip_.poses();
    Values angles = for_each_frame([&](FrameIndex frame) {
      if (tip == kNoParent) return glm::dvec3(kNotDefined);
      const glm::dvec3 bone = poses.position(frame, tip) - poses.position(frame, origin);
      return angles_in_planes(is_seen_from_joint() ? glm::conjugate(poses.rotation(frame, *asked_.frame)) * bone : bone);
    });
    unroll(angles);
    return angles;
  }

  // By trapezoids, from the first frame on that has a power.
  [[nodiscard]] Values work() const {
    Values sums(idx(clip_.body().frame_count), glm::dvec3(0.0));
    const auto power = [&](FrameIndex frame) { return is_defined(clip_, DerivativeLevel::Acceleration, frame) ? clip_.load(frame, joint_).power : 0.0; };
    const int first = is_defined(clip_, DerivativeLevel::Acceleration, 0) ? 0 : 1;
    for (FrameIndex frame = first + 1; frame < size_of(sums); ++frame) {
      sums[idx(frame)].x = sums[idx(frame - 1)].x + 0.5 * clip_.body().frame_time_s * (power(frame - 1) + power(frame));
    }
    return sums;
  }

  [[nodiscard]] JointState segment_at(FrameIndex frame) const {
    double mass = 0.0;
    glm::dvec3 moment(0.0);
    for (const Segment& segment : clip_.request().model->segments) {
      if (segment.joint != joint_) continue;
      mass += segment.mass_kg;
      moment += segment.mass_kg * segment.com_m;
    }
    return state_of_point(clip_.body().state(frame, joint_), mass > 0.0 ? moment / mass : glm::dvec3(kNotDefined));
  }

  [[nodiscard]] JointState place_at(FrameIndex frame) const {
    JointState place;
    const BodyState& state = clip_.state(frame);
    switch (asked_.quantity->kind) {
      case QuantityKind::SegmentCom:
      case QuantityKind::SegmentComVelocity:
      case QuantityKind::SegmentComAcceleration: return segment_at(frame);
      case QuantityKind::CentreOfPressure: place.position = clip_.reaction(frame).centre_of_pressure; break;
      case QuantityKind::ZeroMomentPoint:
        place.position = find_ground_reaction(state, total_mass_kg(*clip_.request().model), clip_.gravity(), clip_.clip().settings.up_axis,
                                              clip_.floor_m())
                             .centre_of_pressure;
        break;
      default:
        place.position = state.com;
        place.velocity = state.com_velocity;
        place.acceleration = state.com_acceleration;
    }
    return place;
  }

  [[nodiscard]] glm::dvec3 vector_at(FrameIndex frame) const {
    switch (asked_.quantity->kind) {
      case QuantityKind::RotationAxis: {
        const glm::dvec3 vector = rotation_vector(rotation_at(frame));
        return vector / glm::length(vector);
      }
      case QuantityKind::AngularVelocity: return seen_from(frame_at(frame), clip_.body().state(frame, joint_)).angular_velocity;
      case QuantityKind::AngularAcceleration: return seen_from(frame_at(frame), clip_.body().state(frame, joint_)).angular_acceleration;
      case QuantityKind::SegmentComVelocity:
      case QuantityKind::ComVelocity: return seen_from(frame_at(frame), place_at(frame)).velocity;
      case QuantityKind::SegmentComAcceleration: return seen_from(frame_at(frame), place_at(frame)).acceleration;
      default: break;
    }
    if (asked_.quantity->sight == QuantitySight::Place) return seen_from(frame_at(frame), place_at(frame)).position;
    return glm::conjugate(frame_at(frame).rotation) * arrow_at(frame);
  }

  [[nodiscard]] glm::dvec3 arrow_at(FrameIndex frame) const {
    const BodyState& state = clip_.state(frame);
    switch (asked_.quantity->kind) {
      case QuantityKind::Force: return clip_.load(frame, joint_).force;
      case QuantityKind::Torque: return clip_.load(frame, joint_).torque;
      case QuantityKind::Momentum: return state.momentum;
      case QuantityKind::AngularMomentum:
        return joint_ == kNoParent ? state.angular_momentum : angular_momentum_about(state, clip_.body().state(frame, joint_).position);
      default: return clip_.reaction(frame).force;
    }
  }

  [[nodiscard]] double number_at(FrameIndex frame) const {
    switch (asked_.quantity->kind) {
      case QuantityKind::RotationAngle: return glm::length(rotation_vector(rotation_at(frame)));
      case QuantityKind::IncludedAngle: return find_included_angle(clip_.clip().skeleton, clip_.poses(), joint_, frame);
      case QuantityKind::Power: return clip_.load(frame, joint_).power;
      case QuantityKind::KineticEnergy: return clip_.state(frame).kinetic_energy;
      case QuantityKind::PotentialEnergy: return clip_.state(frame).potential_energy;
      default: return clip_.state(frame).kinetic_energy + clip_.state(frame).potential_energy;
    }
  }

  const AnalysedClip& clip_;
  const AskedQuantity& asked_;
  JointIndex joint_;
};

/// With the noise of angles where a path has that of places: angles in radians are no metres.
Derivation for_angles(Derivation derivation) {
  derivation.noise_mm = 1e3 * to_radians(derivation.noise_deg);
  return derivation;
}

/// The curves of a joint's own rotation channels, in radians and without jumps of whole turns; with `rates` their derivatives.
void add_channels(const AnalysedClip& clip, const AskedQuantity& asked, bool rates, AnalysisTable& table) {
  const Skeleton& skeleton = clip.clip().skeleton;
  const JointIndex joint = skeleton.node(asked.node).joint;
  for (int i = 0; i < skeleton.channel_count(joint); ++i) {
    const ChannelIndex channel = skeleton.first_channel(joint) + i;
    const ChannelKind kind = skeleton.channel(channel).kind;
    if (!is_rotation(kind)) continue;
    Values curve;
    for (const double sample : clip.clip().motion.channel_samples(channel)) curve.emplace_back(to_radians(sample), 0.0, 0.0);
    unroll(curve);
    if (rates) curve = differentiate_path(std::move(curve), for_angles(clip.request().derivation), 1.0 / clip.body().frame_time_s).velocities;
    AnalysisColumn column = make_column(asked, "xyz"[static_cast<int>(axis_of(kind))]);
    for (FrameIndex frame = 0; frame < size_of(curve); ++frame) {
      column.values.push_back(is_defined(clip, asked.quantity->level, frame) ? curve[idx(frame)].x : kNotDefined);
    }
    table.columns.push_back(std::move(column));
  }
}

void add_values(const AnalysedClip& clip, const AskedQuantity& asked, const Values& values, AnalysisTable& table) {
  for (int c = 0; c < (asked.quantity->is_vector ? 3 : 1); ++c) {
    AnalysisColumn column = make_column(asked, asked.quantity->is_vector ? "xyz"[c] : '\0');
    for (FrameIndex frame = 0; frame < size_of(values); ++frame) {
      column.values.push_back(is_defined(clip, asked.quantity->level, frame) ? values[idx(frame)][c] : kNotDefined);
    }
    table.columns.push_back(std::move(column));
  }
}

}  // namespace

bool needs_poses(const AskedQuantity& asked) {
  const Quantity& quantity = *asked.quantity;
  return quantity.owner == QuantityOwner::Point || quantity.kind == QuantityKind::IncludedAngle || quantity.kind == QuantityKind::PlaneAngle ||
         needs_rotations(asked);
}

bool needs_rotations(const AskedQuantity& asked) {
  const QuantityKind kind = asked.quantity->kind;
  const bool is_placed = asked.quantity->owner == QuantityOwner::Point || kind == QuantityKind::PlaneAngle;
  const bool is_elsewhere = asked.frame.has_value() || asked.point_m != glm::dvec3(0.0);
  return kind == QuantityKind::RotationAngle || kind == QuantityKind::RotationAxis ||
         (is_elsewhere && (is_placed || kind == QuantityKind::Angle));
}

void add_analysis_columns(const AnalysedClip& clip, const AskedQuantity& asked, AnalysisTable& table) {
  const QuantityKind kind = asked.quantity->kind;
  if (kind == QuantityKind::AngleRate || (kind == QuantityKind::Angle && !asked.frame)) {
    return add_channels(clip, asked, kind == QuantityKind::AngleRate, table);
  }
  const ValueMaker maker(clip, asked);
  if (kind != QuantityKind::Angle) return add_values(clip, asked, maker.make(), table);
  const EulerAngles euler(clip.clip().skeleton, clip.clip().skeleton.node(asked.node).joint);
  Values angles;
  for (FrameIndex frame = 0; frame < clip.body().frame_count; ++frame) {
    angles.push_back(euler.angles_of(maker.rotation_at(frame), angles.empty() ? glm::dvec3(0.0) : angles.back()));
  }
  add_values(clip, asked, angles, table);
}

}  // namespace marey
