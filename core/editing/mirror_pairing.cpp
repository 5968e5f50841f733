#include "core/editing/mirror_pairing.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>
#include <string>
#include <utility>

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
    std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& x, const Candidate& y) { return y.fit < x.fit; });
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

Axis find_lateral_axis(const Skeleton& skeleton, const MirrorPairing& pairing) {
  std::vector<glm::dvec3> places;
  glm::dvec3 apart(0.0);
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    const JointIndex parent = skeleton.parent(joint);
    places.push_back(parent == kNoParent ? glm::dvec3(0.0) : places[idx(parent)] + skeleton.offset(joint));
  }
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    apart += glm::abs(places[idx(joint)] - places[idx(pairing.partner[idx(joint)])]);
  }
  if (apart.z > apart.x && apart.z >= apart.y) return Axis::Z;
  return apart.y > apart.x ? Axis::Y : Axis::X;
}

std::vector<JointIndex> find_unsymmetric_joints(const Skeleton& skeleton, const MirrorPairing& pairing, Axis axis) {
  const double tolerance = kSymmetryShare * compute_stature(skeleton);
  std::vector<JointIndex> joints;
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    if (skeleton.parent(joint) == kNoParent) continue;
    glm::dvec3 image = skeleton.offset(pairing.partner[idx(joint)]);
    image[static_cast<int>(axis)] = -image[static_cast<int>(axis)];
    if (!(glm::distance(image, skeleton.offset(joint)) <= tolerance)) joints.push_back(joint);
  }
  return joints;
}

}  // namespace marey
