#include "core/biomechanics/body_guess.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace marey {
namespace {

constexpr double kLeastLength_m = 1e-6;

/// Of gyration, of the part's length.
struct Radii {
  double sagittal = 0.0;
  double transverse = 0.0;
  double longitudinal = 0.0;
};

std::vector<glm::dvec3> rest_positions_m(const Skeleton& skeleton, double metres_per_unit) {
  std::vector<glm::dvec3> positions;
  for (const Node& node : skeleton.nodes()) {
    const glm::dvec3 parent = node.parent == kNoParent ? glm::dvec3(0.0) : positions[idx(node.parent)];
    positions.push_back(parent + metres_per_unit * node.offset);
  }
  return positions;
}

/// A unit vector across `along`, as near to `wanted` as it gets; any where that is nearly the same direction.
glm::dvec3 across(const glm::dvec3& along, glm::dvec3 wanted) {
  constexpr double kNearlyParallel = 0.3;
  wanted -= glm::dot(wanted, along) * along;
  if (glm::length(wanted) > kNearlyParallel) return glm::normalize(wanted);
  const glm::dvec3 other = std::abs(along.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
  return glm::normalize(other - glm::dot(other, along) * along);
}

class BodyGuess {
 public:
  BodyGuess(const Skeleton& skeleton, BodyTable table, double mass_kg, double metres_per_unit, std::span<const OwnPart> own)
      : skeleton_(skeleton), table_(table), mass_kg_(mass_kg), rest_(rest_positions_m(skeleton, metres_per_unit)),
        named_(find_named_parts(skeleton, own)) {}

  Result<GuessedBody> make_human();
  Result<GuessedBody> make_rods();

 private:
  [[nodiscard]] const glm::dvec3& origin(JointIndex joint) const { return rest_[idx(skeleton_.node_of(joint))]; }
  [[nodiscard]] JointIndex find(BodyPart part, BodySide side) const;
  [[nodiscard]] glm::dvec3 tip_of(JointIndex joint) const;
  [[nodiscard]] std::optional<glm::dvec3> mean_of(BodyPart part) const;
  [[nodiscard]] std::vector<JointIndex> trunk_joints() const;
  void find_lateral();
  void add(JointIndex joint, std::string name, const glm::dvec3& begin, const glm::dvec3& end, double share, double com, const Radii& radii);
  void add_part(JointIndex joint, BodyPart part, std::string name, const glm::dvec3& begin, const glm::dvec3& end, double times = 1.0);
  void add_limb(std::array<BodyPart, 3> parts, BodySide side);
  void add_both_limbs(JointIndex joint, std::array<BodyPart, 3> parts);
  void add_trunk();
  void add_head(const glm::dvec3& hips, const glm::dvec3& shoulders, JointIndex trunk);
  void settle_mass();

  const Skeleton& skeleton_;
  BodyTable table_;
  double mass_kg_;
  std::vector<glm::dvec3> rest_;
  std::vector<std::optional<NamedPart>> named_;
  glm::dvec3 lateral_{1.0, 0.0, 0.0};
  GuessedBody body_;
  std::vector<std::string> missing_;
};

JointIndex BodyGuess::find(BodyPart part, BodySide side) const {
  for (JointIndex joint = 0; joint < skeleton_.joint_count(); ++joint) {
    const auto& named = named_[idx(joint)];
    if (named && named->part == part && named->side == side) return joint;
  }
  return kNoParent;
}

/// The node of the subtree that is farthest away.
glm::dvec3 BodyGuess::tip_of(JointIndex joint) const {
  glm::dvec3 tip = origin(joint);
  for (NodeIndex node = skeleton_.node_of(joint); node < skeleton_.node_count(); ++node) {
    const JointIndex owner = skeleton_.node(node).joint;
    if (owner < joint || owner >= skeleton_.subtree_end(joint)) continue;
    if (glm::distance(rest_[idx(node)], origin(joint)) > glm::distance(tip, origin(joint))) tip = rest_[idx(node)];
  }
  return tip;
}

std::optional<glm::dvec3> BodyGuess::mean_of(BodyPart part) const {
  const JointIndex left = find(part, BodySide::Left);
  const JointIndex right = find(part, BodySide::Right);
  if (left != kNoParent && right != kNoParent) return 0.5 * (origin(left) + origin(right));
  const JointIndex both = find(part, BodySide::Middle);
  return both == kNoParent ? std::nullopt : std::optional(origin(both));
}

void BodyGuess::find_lateral() {
  for (const BodyPart part : {BodyPart::Thigh, BodyPart::UpperArm}) {
    const JointIndex left = find(part, BodySide::Left);
    const JointIndex right = find(part, BodySide::Right);
    if (left == kNoParent || right == kNoParent || glm::distance(origin(left), origin(right)) < kLeastLength_m) continue;
    lateral_ = glm::normalize(origin(left) - origin(right));
    return;
  }
  lateral_ = {0.0, 0.0, 1.0};  // a figure that is seen from the side
}

/// `com` and `radii` are of the distance from `begin` to `end`; `share` is of the body's mass.
void BodyGuess::add(JointIndex joint, std::string name, const glm::dvec3& begin, const glm::dvec3& end, double share, double com,
                    const Radii& radii) {
  const double length = glm::distance(begin, end);
  if (length < kLeastLength_m) {
    missing_.push_back(std::move(name));
    return;
  }
  const glm::dvec3 along = (end - begin) / length;
  const glm::dvec3 side = across(along, lateral_);
  const glm::dvec3 front = glm::cross(side, along);
  const auto moment = [&](double radius, const glm::dvec3& axis) {
    return share * mass_kg_ * radius * radius * length * length * glm::outerProduct(axis, axis);
  };
  Segment segment;
  segment.joint = joint;
  segment.mass_kg = share * mass_kg_;
  segment.com_m = begin + com * (end - begin) - origin(joint);
  segment.inertia_kgm2 = moment(radii.sagittal, front) + moment(radii.transverse, side) + moment(radii.longitudinal, along);
  body_.model.segments.push_back(segment);
  body_.parts.push_back({joint, std::move(name), segment.mass_kg});
}

void BodyGuess::add_part(JointIndex joint, BodyPart part, std::string name, const glm::dvec3& begin, const glm::dvec3& end, double times) {
  const PartProportions& p = proportions_of(table_, part);
  add(joint, std::move(name), begin, end, times * p.mass, p.com, {p.radius_sagittal, p.radius_transverse, p.radius_longitudinal});
}

void BodyGuess::add_limb(std::array<BodyPart, 3> parts, BodySide side) {
  const std::string_view side_name = side == BodySide::Left ? "left" : "right";
  for (std::size_t i = 0; i < parts.size(); ++i) {
    std::string name = fmt::format("{} {}", side_name, body_part_name(parts[i]));
    const JointIndex joint = find(parts[i], side);
    if (joint == kNoParent) {
      missing_.push_back(std::move(name));
      continue;
    }
    const JointIndex next = i + 1 < parts.size() ? find(parts[i + 1], side) : kNoParent;
    glm::dvec3 end = next != kNoParent ? origin(next) : tip_of(joint);
    // A foot ends at its toe base, which is its first child.
    const bool has_toes = parts[i] == BodyPart::Foot && skeleton_.subtree_end(joint) > joint + 1;
    if (has_toes) end = origin(joint + 1);
    add_part(joint, parts[i], std::move(name), origin(joint), end);
  }
}

/// Both limbs of a figure that is seen from the side, stretched out over one bone: the parts at the lengths that they have to
/// each other. Where the trunk hangs on the joint, the limb's far end is at the joint.
void BodyGuess::add_both_limbs(JointIndex joint, std::array<BodyPart, 3> parts) {
  glm::dvec3 near = origin(joint);
  glm::dvec3 far = skeleton_.subtree_end(joint) > joint + 1 ? origin(joint + 1) : tip_of(joint);
  const JointIndex trunk = find(BodyPart::Trunk, BodySide::Middle);
  if (trunk > joint && trunk < skeleton_.subtree_end(joint)) std::swap(near, far);
  double total = 0.0;
  for (const BodyPart part : parts) total += proportions_of(table_, part).length_mm;
  double at = 0.0;
  for (const BodyPart part : parts) {
    const double end = at + proportions_of(table_, part).length_mm / total;
    std::string name = part == BodyPart::Foot ? "both feet" : fmt::format("both {}s", body_part_name(part));
    add_part(joint, part, std::move(name), near + at * (far - near), near + end * (far - near), 2.0);
    at = end;
  }
}

/// Those between hips and shoulders.
std::vector<JointIndex> BodyGuess::trunk_joints() const {
  std::vector<JointIndex> joints;
  JointIndex upper = find(BodyPart::UpperArm, BodySide::Left);
  if (upper == kNoParent) upper = find(BodyPart::Head, BodySide::Middle);
  for (JointIndex joint = upper == kNoParent ? kNoParent : skeleton_.parent(upper); joint != kNoParent; joint = skeleton_.parent(joint)) {
    if (named_[idx(joint)] && named_[idx(joint)]->part == BodyPart::Trunk) joints.insert(joints.begin(), joint);
  }
  if (joints.empty()) joints.push_back(find(BodyPart::Trunk, BodySide::Middle));
  return joints;
}

void BodyGuess::add_trunk() {
  const std::vector<JointIndex> joints = trunk_joints();
  const JointIndex arms = find(BodyPart::UpperArm, BodySide::Middle);
  const bool hangs_on_arms = arms != kNoParent && joints[0] > arms;
  const glm::dvec3 hips = mean_of(BodyPart::Thigh).value_or(origin(joints[0]));
  const glm::dvec3 shoulders = hangs_on_arms ? origin(joints[0]) : mean_of(BodyPart::UpperArm).value_or(tip_of(joints[0]));
  if (joints.size() == 1) {
    add_part(joints[0], BodyPart::Trunk, "trunk", hips, shoulders);
  } else {
    static constexpr std::array<std::string_view, 3> kNames = {"lower trunk", "middle trunk", "upper trunk"};
    const std::array<JointIndex, 3> owners = {joints.front(), joints.size() == 2 ? joints.back() : joints[joints.size() / 2], joints.back()};
    for (std::size_t i = 0; i < 3; ++i) {
      const TrunkPiece& piece = trunk_pieces_of(table_)[i];
      add(owners[i], std::string(kNames[i]), hips, shoulders, piece.mass, piece.com,
          {piece.radius_sagittal, piece.radius_transverse, piece.radius_longitudinal});
    }
  }
  add_head(hips, shoulders, joints.back());
}

void BodyGuess::add_head(const glm::dvec3& hips, const glm::dvec3& shoulders, JointIndex trunk) {
  const JointIndex neck = find(BodyPart::Head, BodySide::Middle);
  if (neck != kNoParent && glm::distance(tip_of(neck), origin(neck)) > kLeastLength_m) {
    add_part(neck, BodyPart::Head, "head", origin(neck), tip_of(neck));
    return;
  }
  const glm::dvec3 per_mm = (shoulders - hips) / proportions_of(table_, BodyPart::Trunk).length_mm;
  const glm::dvec3 begin = shoulders + neck_height_mm(table_) * per_mm;
  add_part(trunk, BodyPart::Head, "head", begin, begin + proportions_of(table_, BodyPart::Head).length_mm * per_mm);
}

/// The masses of parts that are missing go to the others.
void BodyGuess::settle_mass() {
  const double placed = total_mass_kg(body_.model);
  for (Segment& segment : body_.model.segments) {
    segment.mass_kg *= mass_kg_ / placed;
    segment.inertia_kgm2 *= mass_kg_ / placed;
  }
  for (GuessedPart& part : body_.parts) part.mass_kg *= mass_kg_ / placed;
  if (missing_.empty()) return;
  body_.notes.push_back(fmt::format("No joint was found for {}; {:.1f} kg of {:.1f} kg are spread over the other parts.",
                                    fmt::join(missing_, ", "), mass_kg_ - placed, mass_kg_));
}

Result<GuessedBody> BodyGuess::make_human() {
  const bool has_trunk = find(BodyPart::Trunk, BodySide::Middle) != kNoParent;
  if (!has_trunk || (!mean_of(BodyPart::Thigh) && !mean_of(BodyPart::UpperArm))) {
    return Error{DiagnosticCode::InvalidArgument, {}, "The joints do not tell a human body. Say what they carry, give a model, or take rods.", {}, {}};
  }
  find_lateral();
  add_trunk();
  constexpr std::array kArm = {BodyPart::UpperArm, BodyPart::Forearm, BodyPart::Hand};
  constexpr std::array kLeg = {BodyPart::Thigh, BodyPart::Shank, BodyPart::Foot};
  for (const auto& limb : {kArm, kLeg}) {
    const JointIndex both = find(limb[0], BodySide::Middle);
    if (both != kNoParent) {
      add_both_limbs(both, limb);
      continue;
    }
    for (const BodySide side : {BodySide::Left, BodySide::Right}) add_limb(limb, side);
  }
  settle_mass();
  return std::move(body_);
}

Result<GuessedBody> BodyGuess::make_rods() {
  constexpr double kRodRadius = 0.28867513459481287;  // 1 / sqrt(12)
  double total = 0.0;
  for (const Node& node : skeleton_.nodes()) total += node.parent == kNoParent ? 0.0 : glm::length(node.offset);
  if (total <= 0.0) return Error{DiagnosticCode::InvalidArgument, {}, "No bone of the figure has a length.", {}, {}};
  for (NodeIndex n = 0; n < skeleton_.node_count(); ++n) {
    const Node& node = skeleton_.node(n);
    if (node.parent == kNoParent || glm::length(node.offset) == 0.0) continue;
    const JointIndex owner = node.is_end_site ? node.joint : skeleton_.parent(node.joint);
    add(owner, "bone", origin(owner), rest_[idx(n)], glm::length(node.offset) / total, 0.5, {kRodRadius, kRodRadius, 0.0});
  }
  missing_.clear();
  settle_mass();
  return std::move(body_);
}

}  // namespace

double usual_mass_kg(BodyTable table) {
  return table == BodyTable::DeLevaMale ? 73.0 : table == BodyTable::DeLevaFemale ? 61.9 : 70.0;
}

Result<GuessedBody> guess_body(const Skeleton& skeleton, BodyTable table, double mass_kg, double metres_per_unit,
                               std::span<const OwnPart> own) {
  BodyGuess guess(skeleton, table, mass_kg, metres_per_unit, own);
  Result<GuessedBody> body = table == BodyTable::Rods ? guess.make_rods() : guess.make_human();
  if (body) body->model.metres_per_unit = metres_per_unit;
  return body;
}

}  // namespace marey
