#pragma once

#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/base/index.h"
#include "core/biomechanics/body_motion.h"

namespace marey {

/// How a link moves on its parent.
enum class LinkKind : std::uint8_t {
  Fixed,
  Hinge,  ///< turns about `axis`
  Ball,   ///< turns about anything
  Slide,  ///< goes anywhere and does not turn; on the world alone
};

/// One rigid body of a tree, by its own axes and from its own origin, about which it turns. SI.
struct Link {
  int parent = kNoParent;  ///< an earlier link; kNoParent: the world
  LinkKind kind = LinkKind::Fixed;
  glm::dvec3 axis{0.0};    ///< of a hinge: unit length
  glm::dvec3 offset{0.0};  ///< of the origin from that of the parent, in the parent's axes
  double mass = 0.0;       ///< may be 0 where something hangs on the link
  glm::dvec3 moment{0.0};  ///< mass by the place of the centre of mass
  glm::dmat3 inertia{0.0};
};

/// Where a link is on its parent, and how it moves there.
struct LinkState {
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
  glm::dvec3 shift{0.0};  ///< of a slide, beside its offset
  glm::dvec3 speed{0.0};  ///< angular velocity on the parent, rad/s in the link's own axes; of a slide m/s
};

/// Forward dynamics of a tree of links by the articulated-body method (R. Featherstone, Rigid Body Dynamics Algorithms, 2008,
/// chapter 7): the cost grows with the number of links. Everything is taken in world axes about each link's own origin, so
/// that going to the parent is a shift. An axis about which nothing turns, as that of a thin rod, keeps its speed: what turns
/// about it is below 1e-10 of what turns about all.
class ArticulatedBody {
 public:
  ArticulatedBody(std::vector<Link> links, const glm::dvec3& gravity_mps2);

  [[nodiscard]] const std::vector<Link>& links() const { return links_; }

  /// The rates of LinkState::speed where no joint has a torque or force of its own. Does not allocate.
  void find_accelerations(std::span<const LinkState> states, std::span<glm::dvec3> accelerations);

  /// Of the states given last: how a link moves in the world, and the energies; the potential one is 0 at the origin.
  [[nodiscard]] const JointState& world(int link) const { return work_[idx(link)].world; }
  [[nodiscard]] double kinetic_energy() const { return kinetic_energy_; }
  [[nodiscard]] double potential_energy() const { return potential_energy_; }

 private:
  /// What force f and moment n at a link's origin it takes to move the link with all that hangs on it:
  /// n = turn a + cross v + moment, f = transpose(cross) a + shift v + force, for angular acceleration a and acceleration v.
  struct Inertia {
    glm::dmat3 turn{0.0};
    glm::dmat3 cross{0.0};
    glm::dmat3 shift{0.0};
    glm::dvec3 moment{0.0};
    glm::dvec3 force{0.0};
  };
  struct Work {
    JointState world;
    glm::dmat3 axes{1.0};        // of the link in the world
    glm::dvec3 arm{0.0};         // from the parent's origin
    glm::dvec3 turn_bias{0.0};   // acceleration beside that of the parent and the joint
    glm::dvec3 shift_bias{0.0};
    Inertia inertia;
    glm::dmat3 gain{0.0};        // from moment (of a slide: force) to the joint's acceleration
    bool gives_way = false;      // to any moment: a ball about which all directions turn something
  };

  void place(std::size_t i, const LinkState& state);
  void weigh(std::size_t i);
  void find_gain(std::size_t i);
  [[nodiscard]] Inertia left_of(const Work& work) const;
  void hang_on_parent(std::size_t i);
  [[nodiscard]] glm::dvec3 accelerate(std::size_t i);
  [[nodiscard]] const JointState& parent_of(std::size_t i) const;

  std::vector<Link> links_;
  glm::dvec3 gravity_;
  std::vector<Work> work_;
  double kinetic_energy_ = 0.0;
  double potential_energy_ = 0.0;
};

}  // namespace marey
