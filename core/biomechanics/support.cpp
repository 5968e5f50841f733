#include "core/biomechanics/support.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/kinematics/pose.h"

namespace marey {
namespace {

// In the order of SupportKind.
constexpr std::array<std::pair<std::string_view, SupportKind>, 4> kKinds = {
    {{"pivot", SupportKind::Pivot}, {"flight", SupportKind::Flight}, {"ground", SupportKind::Ground}, {"auto", SupportKind::Auto}}};

glm::dvec3 unit_of(Axis axis) {
  glm::dvec3 unit(0.0);
  unit[static_cast<int>(axis)] = 1.0;
  return unit;
}

std::vector<ContactPoint> find_points(const BodyMotion& body, const Skeleton& skeleton) {
  std::vector<ContactPoint> points;
  for (const NodeIndex n : find_contact_nodes(skeleton, kNoParent)) {
    const Node& node = skeleton.node(n);
    points.push_back({node.joint, node.is_end_site ? body.metres_per_unit * node.offset : glm::dvec3(0.0), n});
  }
  return points;
}

double find_floor(std::vector<std::pair<double, double>> lowest_height_and_speed, double slow_mps) {
  double least = std::numeric_limits<double>::infinity();
  std::vector<double> slow;
  for (const auto& [height, speed] : lowest_height_and_speed) {
    least = std::min(least, height);
    if (speed <= slow_mps) slow.push_back(height);
  }
  if (slow.empty()) return std::isfinite(least) ? least : 0.0;
  std::nth_element(slow.begin(), slow.begin() + size_of(slow) / 2, slow.end());
  return slow[slow.size() / 2];
}

/// Runs of `value` that are shorter than `least` frames and lie between others take the other value.
void take_out_short_runs(std::vector<std::uint8_t>& down, std::uint8_t value, int least) {
  std::size_t begin = 0;
  while (begin < down.size()) {
    std::size_t end = begin;
    while (end < down.size() && down[end] == down[begin]) ++end;
    const bool is_inner = begin > 0 && end < down.size();
    if (down[begin] == value && is_inner && end - begin < idx(least)) {
      std::fill(down.begin() + static_cast<std::ptrdiff_t>(begin), down.begin() + static_cast<std::ptrdiff_t>(end),
                static_cast<std::uint8_t>(1 - value));
    }
    begin = end;
  }
}

std::vector<std::uint8_t> find_contact(const BodyMotion& body, const ContactPoint& point, int up, double floor_m,
                                       const ContactLimits& limits) {
  std::vector<std::uint8_t> down(idx(body.frame_count));
  bool is_down = false;
  for (FrameIndex frame = 0; frame < body.frame_count; ++frame) {
    const JointState state = state_of_point(body.state(frame, point.joint), point.local_m);
    const double height = state.position[up] - floor_m;
    const double speed = glm::length(state.velocity);
    is_down = is_down ? height < limits.end_height_m && speed < limits.end_speed_mps
                      : height < limits.begin_height_m && speed < limits.begin_speed_mps;
    down[idx(frame)] = is_down ? 1 : 0;
  }
  const int least = static_cast<int>(std::ceil(limits.least_duration_s / body.frame_time_s));
  take_out_short_runs(down, 0, least);
  take_out_short_runs(down, 1, least);
  return down;
}

}  // namespace

bool Contacts::any_down(FrameIndex frame) const {
  for (std::size_t point = 0; point < points.size(); ++point) {
    if (is_down(frame, point)) return true;
  }
  return false;
}

SettledSupport SettledSupport::of_frames(FrameRange frames) const {
  SettledSupport part{kind, follows_contacts, {contacts.floor_m, contacts.points, {}}};
  const auto points = static_cast<std::ptrdiff_t>(contacts.points.size());
  part.contacts.down.assign(contacts.down.begin() + frames.first * points, contacts.down.begin() + frames.end() * points);
  return part;
}

Contacts find_contacts(const BodyMotion& body, const Skeleton& skeleton, Axis up, const ContactLimits& limits) {
  Contacts contacts;
  contacts.points = find_points(body, skeleton);
  const int axis = static_cast<int>(up);
  std::vector<std::pair<double, double>> lowest;
  for (FrameIndex frame = 0; frame < body.frame_count; ++frame) {
    std::pair<double, double> best(std::numeric_limits<double>::infinity(), 0.0);
    for (const ContactPoint& point : contacts.points) {
      const JointState state = state_of_point(body.state(frame, point.joint), point.local_m);
      if (state.position[axis] < best.first) best = {state.position[axis], glm::length(state.velocity)};
    }
    lowest.push_back(best);
  }
  contacts.floor_m = find_floor(std::move(lowest), limits.begin_speed_mps);
  contacts.down.resize(idx(body.frame_count) * contacts.points.size());
  for (std::size_t point = 0; point < contacts.points.size(); ++point) {
    const auto down = find_contact(body, contacts.points[point], axis, contacts.floor_m, limits);
    for (std::size_t frame = 0; frame < down.size(); ++frame) contacts.down[frame * contacts.points.size() + point] = down[frame];
  }
  return contacts;
}

Contacts apply_own_contacts(Contacts found, std::span<const OwnContact> own) {
  const std::size_t count = found.points.size();
  const int frame_count = count == 0 ? 0 : size_of(found.down) / size_of(found.points);
  for (const OwnContact& contact : own) {
    for (std::size_t point = 0; point < count; ++point) {
      if (found.points[point].node != contact.node) continue;
      for (FrameIndex frame = std::max(contact.first, 0); frame <= std::min(contact.last, frame_count - 1); ++frame) {
        found.down[idx(frame) * count + point] = contact.touches ? 1 : 0;
      }
    }
  }
  return found;
}

std::vector<NodeIndex> find_contact_nodes(const Skeleton& skeleton, NodeIndex node) {
  enum : std::uint8_t { kOutside, kInside, kInner };
  std::vector<std::uint8_t> places(idx(skeleton.node_count()), node == kNoParent ? kInside : kOutside);
  if (node >= 0 && node < skeleton.node_count()) places[idx(node)] = kInside;
  for (NodeIndex n = 0; n < skeleton.node_count(); ++n) {
    const NodeIndex parent = skeleton.node(n).parent;
    if (parent == kNoParent || places[idx(parent)] == kOutside) continue;
    places[idx(parent)] = kInner;
    places[idx(n)] = kInside;
  }
  std::vector<NodeIndex> nodes;
  for (NodeIndex n = 0; n < skeleton.node_count(); ++n) {
    if (places[idx(n)] == kInside) nodes.push_back(n);
  }
  return nodes;
}

Result<std::vector<OwnContact>> make_own_contacts(const Skeleton& skeleton, std::string_view label, FrameIndex first, FrameIndex last,
                                                  bool touches) {
  const auto refusal = [](std::string message) { return Error{DiagnosticCode::InvalidArgument, {}, std::move(message), {}, {}}; };
  NodeIndex node = 0;
  while (node < skeleton.node_count() && node_label(skeleton, node) != label) ++node;
  if (node == skeleton.node_count()) return refusal(fmt::format("There is no joint '{}' and no such end site.", label));
  if (first < 0 || last < first) return refusal(fmt::format("The frames of the contact of '{}' do not follow one another.", label));
  std::vector<OwnContact> contacts;
  for (const NodeIndex n : find_contact_nodes(skeleton, node)) contacts.push_back({n, first, last, touches});
  return contacts;
}

bool roots_stand_still(const BodyMotion& body, const Skeleton& skeleton) {
  const double limit = 1e-3 * body.metres_per_unit * compute_stature(skeleton);
  for (JointIndex joint = 0; joint < body.joint_count; ++joint) {
    if (skeleton.parent(joint) != kNoParent) continue;
    for (FrameIndex frame = 1; frame < body.frame_count; ++frame) {
      if (glm::distance(body.state(frame, joint).position, body.state(0, joint).position) > limit) return false;
    }
  }
  return true;
}

bool roots_stand_still(const Clip& clip) {
  const double limit = 1e-3 * compute_stature(clip.skeleton);
  for (JointIndex joint = 0; joint < clip.skeleton.joint_count(); ++joint) {
    if (clip.skeleton.parent(joint) != kNoParent) continue;
    const auto place = [&](FrameIndex frame) {
      return joint_translation(clip.skeleton, clip.motion, joint, frame, clip.settings.position_rule);
    };
    for (FrameIndex frame = 1; frame < clip.motion.frame_count(); ++frame) {
      if (glm::distance(place(frame), place(0)) > limit) return false;
    }
  }
  return true;
}

GroundReaction find_ground_reaction(const BodyState& state, double mass_kg, const glm::dvec3& gravity_mps2, Axis up,
                                    double floor_m) {
  constexpr double kLeastPressure = 1e-6;  // of the weight
  GroundReaction reaction;
  reaction.force = mass_kg * (state.com_acceleration - gravity_mps2);
  const glm::dvec3 normal = unit_of(up);
  const glm::dvec3 floor = floor_m * normal;
  const glm::dvec3 moment = state.angular_momentum_rate + glm::cross(state.com - floor, reaction.force);
  const double pressure = glm::dot(normal, reaction.force);
  const bool presses = pressure > kLeastPressure * mass_kg * glm::length(gravity_mps2);
  reaction.centre_of_pressure = presses ? floor + glm::cross(normal, moment) / pressure
                                        : glm::dvec3(std::numeric_limits<double>::quiet_NaN());
  return reaction;
}

std::vector<OuterForce> share_out(const GroundReaction& reaction, const BodyState& state, const BodyMotion& body,
                                  const Contacts& contacts, FrameIndex frame) {
  constexpr double kLeastDistance_m = 1e-6;
  std::vector<OuterForce> forces;
  std::vector<double> shares;
  double sum = 0.0;
  for (std::size_t i = 0; i < contacts.points.size(); ++i) {
    if (!contacts.is_down(frame, i)) continue;
    const ContactPoint& point = contacts.points[i];
    const glm::dvec3 position = state_of_point(body.state(frame, point.joint), point.local_m).position;
    const double distance = glm::distance(position, reaction.centre_of_pressure);
    shares.push_back(std::isfinite(distance) ? 1.0 / std::max(distance, kLeastDistance_m) : 1.0);
    sum += shares.back();
    forces.push_back({point.joint, position, {}, {}});
  }
  glm::dvec3 moment = state.angular_momentum_rate + glm::cross(state.com, reaction.force);
  for (std::size_t i = 0; i < forces.size(); ++i) {
    shares[i] /= sum;
    forces[i].force = shares[i] * reaction.force;
    moment -= glm::cross(forces[i].point, forces[i].force);
  }
  for (std::size_t i = 0; i < forces.size(); ++i) forces[i].moment = shares[i] * moment;
  return forces;
}

const SupportKind* find_support_kind(std::string_view name) {
  const auto found = std::find_if(kKinds.begin(), kKinds.end(), [&](const auto& kind) { return kind.first == name; });
  return found == kKinds.end() ? nullptr : &found->second;
}

std::string_view support_name(SupportKind kind) { return kKinds[static_cast<std::size_t>(kind)].first; }

}  // namespace marey
