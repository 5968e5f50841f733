#include "core/editing/mirror_pairing.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>
#include <span>
#include <string>
#include <utility>

#include "core/base/stable_order.h"
#include "core/skeleton/body_side.h"

namespace marey {
namespace {

constexpr double kSymmetryShare = 0.02;  // of the stature

BodySide opposite(BodySide side) {
  return side == BodySide::Left ? BodySide::Right : side == BodySide::Right ? BodySide::Left : BodySide::Middle;
}

// Letters that two names share at their beginning and at their end.
int shared_letters(const std::string& a, const std::string& b) {
  const std::size_t most = std::min(a.size(), b.size());
  std::size_t front = 0;
  while (front < most && a[front] == b[front]) ++front;
  std::size_t back = 0;
  while (back < most - front && a[a.size() - 1 - back] == b[b.size() - 1 - back]) ++back;
  return static_cast<int>(front + back);
}

/// How well two joints fit as counterparts; the larger the better.
struct Fit {
  int letters = 0;
  double closeness = 0.0;
  friend bool operator<(const Fit& a, const Fit& b) {
    return a.letters != b.letters ? a.letters < b.letters : a.closeness < b.closeness;
  }
};

Fit fit_of(const Skeleton& skeleton, JointIndex a, JointIndex b) {
  const glm::dvec3 difference = glm::abs(glm::abs(skeleton.offset(a)) - glm::abs(skeleton.offset(b)));
  return {shared_letters(skeleton.name(a), skeleton.name(b)), -(difference.x + difference.y + difference.z)};
}

/// A bone below a joint, and where its mirror image wants it.
struct BonePair {
  glm::dvec3 own;
  glm::dvec3 image;
};

glm::dvec3 mirrored(glm::dvec3 v, Axis axis) {
  v[static_cast<int>(axis)] = -v[static_cast<int>(axis)];
  return v;
}

// End sites are paired in their order.
void add_end_sites(const Skeleton& skeleton, JointIndex joint, JointIndex partner, Axis axis, std::vector<BonePair>& bones) {
  const auto ends_of = [&](JointIndex owner) {
    std::vector<glm::dvec3> ends;
    for (NodeIndex node = skeleton.node_of(owner) + 1; node < skeleton.node_count(); ++node) {
      const Node& n = skeleton.node(node);
      if (n.is_end_site && n.joint == owner) ends.push_back(n.offset);
      if (n.parent < skeleton.node_of(owner)) break;
    }
    return ends;
  };
  const std::vector<glm::dvec3> own = ends_of(joint);
  const std::vector<glm::dvec3> other = ends_of(partner);
  for (std::size_t i = 0; i < std::min(own.size(), other.size()); ++i) bones.push_back({own[i], mirrored(other[i], axis)});
}

// The smallest turn of one direction onto another; of the opposite ones a half turn about an axis that the mirror keeps.
glm::dquat turn_onto(const glm::dvec3& from, const glm::dvec3& to, Axis axis) {
  const glm::dvec3 a = glm::normalize(from);
  const glm::dvec3 b = glm::normalize(to);
  if (glm::dot(a, b) > -1.0 + 1e-9) return glm::normalize(glm::dquat(1.0 + glm::dot(a, b), glm::cross(a, b)));
  glm::dvec3 normal(0.0);
  normal[static_cast<int>(axis)] = 1.0;
  glm::dvec3 about = glm::cross(normal, a);
  if (glm::length(about) < 1e-6) about[(static_cast<int>(axis) + 1) % 3] = 1.0;
  return {0.0, glm::normalize(about)};
}

// Around `bone`, which is in its place, the turn that brings the other bones nearest to theirs.
glm::dquat turn_around(const glm::dvec3& bone, const glm::dquat& turned, std::span<const BonePair> bones) {
  const glm::dvec3 along = glm::normalize(bone);
  double sine = 0.0;
  double cosine = 0.0;
  for (const BonePair& pair : bones) {
    const glm::dvec3 own = turned * pair.own;
    const glm::dvec3 a = own - along * glm::dot(own, along);
    const glm::dvec3 b = pair.image - along * glm::dot(pair.image, along);
    sine += glm::dot(along, glm::cross(a, b));
    cosine += glm::dot(a, b);
  }
  if (std::hypot(sine, cosine) <= 1e-9 * glm::dot(bone, bone)) return {1.0, 0.0, 0.0, 0.0};
  return glm::angleAxis(std::atan2(sine, cosine), along);
}

glm::dquat find_correction(std::span<const BonePair> bones, double tolerance, Axis axis) {
  const glm::dquat none(1.0, 0.0, 0.0, 0.0);
  const bool fits = std::all_of(bones.begin(), bones.end(), [tolerance](const BonePair& pair) {
    return glm::distance(pair.own, pair.image) <= tolerance;
  });
  if (fits) return none;
  const auto longest = std::max_element(bones.begin(), bones.end(), [](const BonePair& a, const BonePair& b) {
    return glm::length(a.own) + glm::length(a.image) < glm::length(b.own) + glm::length(b.image);
  });
  if (glm::length(longest->own) == 0.0 || glm::length(longest->image) == 0.0) return none;
  const glm::dquat turned = turn_onto(longest->own, longest->image, axis);
  return glm::normalize(turn_around(longest->image, turned, bones) * turned);
}

class Pairing {
 public:
  explicit Pairing(const Skeleton& skeleton) : skeleton_(skeleton), sides_(compute_body_sides(skeleton)) {
    result_.partner.assign(idx(skeleton.joint_count()), kNoParent);
    children_.resize(idx(skeleton.joint_count()));
    for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
      const JointIndex parent = skeleton.parent(joint);
      (parent == kNoParent ? roots_ : children_[idx(parent)]).push_back(joint);
    }
  }

  MirrorPairing find() {
    pair_siblings(roots_, roots_);
    // Parents stand before their children, so each partner is known when its children are asked for.
    for (JointIndex joint = 0; joint < skeleton_.joint_count(); ++joint) {
      const JointIndex partner = result_.partner[idx(joint)];
      if (partner != kNoParent && partner >= joint) pair_siblings(children_[idx(joint)], children_[idx(partner)]);
    }
    for (JointIndex joint = 0; joint < skeleton_.joint_count(); ++joint) {
      JointIndex& partner = result_.partner[idx(joint)];
      if (partner == kNoParent) partner = joint;
      if (partner == joint && sides_[idx(joint)] != BodySide::Middle) result_.unpaired.push_back(joint);
    }
    return std::move(result_);
  }

 private:
  // Best fits first; what is left of the middle is its own counterpart.
  void pair_siblings(const std::vector<JointIndex>& some, const std::vector<JointIndex>& others) {
    struct Candidate {
      Fit fit;
      JointIndex a;
      JointIndex b;
    };
    std::vector<Candidate> candidates;
    for (const JointIndex a : some) {
      for (const JointIndex b : others) {
        if (a == b || sides_[idx(b)] != opposite(sides_[idx(a)])) continue;
        if (sides_[idx(a)] == BodySide::Middle && &some == &others) continue;
        candidates.push_back({fit_of(skeleton_, a, b), a, b});
      }
    }
    sort_stably(candidates, [](const Candidate& x, const Candidate& y) { return y.fit < x.fit; });
    for (const Candidate& candidate : candidates) {
      if (is_free(candidate.a) && is_free(candidate.b)) join(candidate.a, candidate.b);
    }
    for (const JointIndex joint : some) {
      if (is_free(joint) && sides_[idx(joint)] == BodySide::Middle) join(joint, joint);
    }
  }

  [[nodiscard]] bool is_free(JointIndex joint) const { return result_.partner[idx(joint)] == kNoParent; }
  void join(JointIndex a, JointIndex b) {
    result_.partner[idx(a)] = b;
    result_.partner[idx(b)] = a;
  }

  const Skeleton& skeleton_;
  std::vector<BodySide> sides_;
  std::vector<JointIndex> roots_;
  std::vector<std::vector<JointIndex>> children_;
  MirrorPairing result_;
};

}  // namespace

MirrorPairing find_mirror_pairs(const Skeleton& skeleton) { return Pairing(skeleton).find(); }

Axis find_lateral_axis(const Skeleton& skeleton, const MirrorPairing& pairing, Axis up) {
  std::vector<glm::dvec3> places;
  glm::dvec3 apart(0.0);
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    const JointIndex parent = skeleton.parent(joint);
    places.push_back(parent == kNoParent ? glm::dvec3(0.0) : places[idx(parent)] + skeleton.offset(joint));
  }
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    apart += glm::abs(places[idx(joint)] - places[idx(pairing.partner[idx(joint)])]);
  }
  apart[static_cast<int>(up)] = -1.0;
  Axis widest = up == Axis::X ? Axis::Z : Axis::X;
  for (const Axis axis : {Axis::Z, Axis::Y}) {
    if (apart[static_cast<int>(axis)] > apart[static_cast<int>(widest)]) widest = axis;
  }
  return widest;
}

std::vector<glm::dquat> find_mirror_corrections(const Skeleton& skeleton, const MirrorPairing& pairing, Axis axis) {
  std::vector<std::vector<BonePair>> pairs(idx(skeleton.joint_count()));
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    const JointIndex parent = skeleton.parent(joint);
    const JointIndex partner = pairing.partner[idx(joint)];
    const bool fits = parent != kNoParent && skeleton.parent(partner) == pairing.partner[idx(parent)];
    if (fits) pairs[idx(parent)].push_back({skeleton.offset(joint), mirrored(skeleton.offset(partner), axis)});
    add_end_sites(skeleton, joint, partner, axis, pairs[idx(joint)]);
  }
  const double tolerance = kSymmetryShare * compute_stature(skeleton);
  std::vector<glm::dquat> corrections;
  for (const std::vector<BonePair>& bones : pairs) corrections.push_back(find_correction(bones, tolerance, axis));
  // Counterparts undo each other's, however little alike their bones are, so that mirroring twice changes nothing.
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    const JointIndex partner = pairing.partner[idx(joint)];
    const glm::dquat own = corrections[idx(joint)];
    if (own.w == 1.0 && corrections[idx(partner)].w == 1.0) continue;
    glm::dquat undone = own;
    undone[static_cast<int>(axis)] = -undone[static_cast<int>(axis)];
    if (partner > joint) corrections[idx(partner)] = undone;
    if (partner == joint) corrections[idx(joint)] = glm::normalize(glm::slerp(own, undone, 0.5));
  }
  return corrections;
}

std::vector<JointIndex> find_unsymmetric_joints(const Skeleton& skeleton, const MirrorPairing& pairing, Axis axis) {
  const double tolerance = kSymmetryShare * compute_stature(skeleton);
  const std::vector<glm::dquat> corrections = find_mirror_corrections(skeleton, pairing, axis);
  std::vector<JointIndex> joints;
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    const JointIndex parent = skeleton.parent(joint);
    if (parent == kNoParent) continue;
    const glm::dvec3 image = mirrored(skeleton.offset(pairing.partner[idx(joint)]), axis);
    if (!(glm::distance(image, corrections[idx(parent)] * skeleton.offset(joint)) <= tolerance)) joints.push_back(joint);
  }
  return joints;
}

}  // namespace marey
