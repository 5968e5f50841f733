#include "core/biomechanics/asked_quantity.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "core/base/number_text.h"

namespace marey {
namespace {

Error refusal(std::string message, std::string_view found) {
  return {DiagnosticCode::InvalidArgument, {}, std::move(message), {}, std::string(found)};
}

std::string known_names() {
  std::vector<std::string_view> names;
  for (const Quantity& quantity : quantities()) names.push_back(quantity.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

bool is_of_points(const Quantity& quantity) { return quantity.owner == QuantityOwner::Point; }

/// A text, taken apart at the last of a sign.
struct Parted {
  std::string_view before;
  std::optional<std::string_view> behind;
};

Parted part_at_last(std::string_view text, char sign) {
  const std::size_t at = text.rfind(sign);
  return at == std::string_view::npos ? Parted{text, {}} : Parted{text.substr(0, at), text.substr(at + 1)};
}

std::optional<glm::dvec3> read_point(std::string_view text) {
  glm::dvec3 point(0.0);
  for (int i = 0; i < 3; ++i) {
    const std::string_view word = text.substr(0, i < 2 ? text.find('/') : text.size());
    const NumberRead read = read_number(word);
    if (read.length == 0 || read.length != word.size() || !std::isfinite(read.value)) return std::nullopt;
    point[i] = read.value;
    if (i == 2) return point;
    if (word.size() == text.size()) return std::nullopt;
    text.remove_prefix(word.size() + 1);
  }
  return std::nullopt;
}

/// The joint that a word means, kNoParent for the world.
Result<JointIndex> find_frame(const Skeleton& skeleton, const Quantity& quantity, NodeIndex node, std::string_view text) {
  if (quantity.sight == QuantitySight::None) {
    return refusal(fmt::format("'{}' is the same in every frame of reference; '@{}' cannot stand behind it.", quantity.name, text), text);
  }
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    if (!text.empty() && skeleton.name(joint) == text) return joint;
  }
  if (text == "world") return kNoParent;
  const JointIndex own = node == kNoParent ? 0 : skeleton.node(node).joint;
  if (text == "parent" && node != kNoParent) return skeleton.node(node).is_end_site ? own : skeleton.parent(own);
  if (text == "root" && skeleton.joint_count() > 0) {
    JointIndex root = own;
    while (skeleton.parent(root) != kNoParent) root = skeleton.parent(root);
    return root;
  }
  return refusal(fmt::format("'{}' is no frame of reference: a joint, world{}.", text, node == kNoParent ? " or root" : ", root or parent"), text);
}

/// Reads what stands behind a quantity's name.
class OwnerReader {
 public:
  OwnerReader(const Skeleton& skeleton, const Quantity& quantity) : skeleton_(skeleton), quantity_(quantity) {}

  /// "JOINT", "JOINT+X/Y/Z", either with "@FRAME".
  [[nodiscard]] Status add(std::string_view text, std::vector<AskedQuantity>& asked) const {
    if (Status status = add_owners(text, {}, {}, asked); status) return status;
    // Names may hold the signs: each is tried, from the right.
    for (std::size_t at = text.rfind('@'); at != std::string_view::npos; at = at == 0 ? std::string_view::npos : text.rfind('@', at - 1)) {
      const std::string_view before = text.substr(0, at);
      if (has_owner(before) || has_point(before)) return add_with_point(before, text.substr(at + 1), asked);
    }
    if (has_point(text)) return add_with_point(text, {}, asked);
    return refusal(fmt::format("There is no joint '{}'{}.", text, is_of_points(quantity_) ? " and no such end site" : ""), text);
  }

  [[nodiscard]] Status add_whole_body(std::optional<std::string_view> frame, std::vector<AskedQuantity>& asked) const {
    return add_one(kNoParent, {}, frame, asked);
  }

 private:
  /// Whether a text is an owner with "+X/Y/Z" behind it.
  [[nodiscard]] bool has_point(std::string_view text) const {
    const Parted point = part_at_last(text, '+');
    return point.behind && has_owner(point.before);
  }

  [[nodiscard]] Status add_with_point(std::string_view text, std::optional<std::string_view> frame, std::vector<AskedQuantity>& asked) const {
    if (has_owner(text)) return add_owners(text, {}, frame, asked);
    const Parted point = part_at_last(text, '+');
    return add_owners(point.before, point.behind, frame, asked);
  }

  [[nodiscard]] bool can_own(NodeIndex node) const { return !skeleton_.node(node).is_end_site || is_of_points(quantity_); }

  [[nodiscard]] bool has_owner(std::string_view label) const {
    for (NodeIndex node = 0; node < skeleton_.node_count(); ++node) {
      if (can_own(node) && (label == "*" || node_label(skeleton_, node) == label)) return true;
    }
    return false;
  }

  [[nodiscard]] Status add_owners(std::string_view wanted, std::optional<std::string_view> point, std::optional<std::string_view> frame,
                                  std::vector<AskedQuantity>& asked) const {
    const std::size_t before = asked.size();
    for (NodeIndex node = 0; node < skeleton_.node_count(); ++node) {
      const bool is_wanted = wanted == "*" ? !point || !skeleton_.node(node).is_end_site : node_label(skeleton_, node) == wanted;
      if (!can_own(node) || !is_wanted) continue;
      if (Status status = add_one(node, point, frame, asked); !status) return status;
      if (wanted != "*") return {};
    }
    return asked.size() > before ? Status{} : refusal({}, wanted);
  }

  [[nodiscard]] Status add_one(NodeIndex node, std::optional<std::string_view> point, std::optional<std::string_view> frame,
                               std::vector<AskedQuantity>& asked) const {
    glm::dvec3 point_m(0.0);
    if (point) {
      if (!is_of_points(quantity_) || skeleton_.node(node).is_end_site) {
        return refusal(fmt::format("'{}:{}' has no point fixed to it, so '+{}' cannot stand behind it: only places of joints do.", quantity_.name,
                                   node_label(skeleton_, node), *point),
                       *point);
      }
      const std::optional<glm::dvec3> place = read_point(*point);
      if (!place) return refusal(fmt::format("'+{}' is not a point: write +X/Y/Z, in metres.", *point), *point);
      point_m = *place;
    }
    if (frame && frame->empty()) return find_frame(skeleton_, quantity_, node, {}).error();
    Result<AskedQuantity> one = ask_for(skeleton_, quantity_, node, point_m, frame.value_or(std::string_view()));
    if (!one) return one.error();
    asked.push_back(std::move(*one));
    return {};
  }

  const Skeleton& skeleton_;
  const Quantity& quantity_;
};

}  // namespace

Result<AskedQuantity> ask_for(const Skeleton& skeleton, const Quantity& quantity, NodeIndex node, const glm::dvec3& point_m,
                              std::string_view frame) {
  AskedQuantity one{&quantity, node, std::string(quantity.name), point_m};
  if (node != kNoParent) one.label += ":" + node_label(skeleton, node);
  if (point_m != glm::dvec3(0.0)) one.label += fmt::format("+{}/{}/{}", point_m.x, point_m.y, point_m.z);
  if (frame.empty()) return one;
  const Result<JointIndex> joint = find_frame(skeleton, quantity, node, frame);
  if (!joint) return joint.error();
  one.frame = *joint;
  one.label += fmt::format("@{}", frame);
  return one;
}

bool asks_the_same(const AskedQuantity& a, const AskedQuantity& b) {
  return a.quantity == b.quantity && a.node == b.node && a.point_m == b.point_m && a.frame == b.frame;
}

Result<std::vector<AskedQuantity>> find_quantities(const Skeleton& skeleton, std::span<const std::string> texts) {
  std::vector<AskedQuantity> asked;
  for (const std::string& text : texts) {
    const std::size_t end = text.find_first_of(":@");
    const std::string_view name = std::string_view(text).substr(0, end);
    const Quantity* found = find_quantity(name);
    if (found == nullptr) return refusal(fmt::format("'{}' is not a quantity; there are {}.", name, known_names()), name);
    const bool has_owner = end != std::string::npos && text[end] == ':';
    const OwnerReader reader(skeleton, *found);
    Status status;
    if (has_owner && found->owner == QuantityOwner::Body) {
      status = refusal(fmt::format("'{}' is of the whole body; no joint stands behind it.", name), name);
    } else if (!has_owner && (is_of_points(*found) || found->owner == QuantityOwner::Joint)) {
      status = refusal(fmt::format("'{0}' is of a joint: write {0}:JOINT, or {0}:* for all.", name), name);
    } else if (has_owner) {
      status = reader.add(std::string_view(text).substr(end + 1), asked);
    } else {
      status = reader.add_whole_body(end == std::string::npos ? std::nullopt : std::optional(std::string_view(text).substr(end + 1)), asked);
    }
    if (!status) return status.error();
  }
  return asked;
}

}  // namespace marey
