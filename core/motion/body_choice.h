#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "core/base/index.h"
#include "core/skeleton/body_side.h"

namespace marey {

/// Where the numbers of a body come from: core/biomechanics/body_tables.h.
enum class BodyTable : std::uint8_t {
  DeLevaMale,    ///< P. de Leva 1996, J. Biomech. 29(9):1223-1230, table 4
  DeLevaFemale,
  Winter,        ///< D. A. Winter 2009, Biomechanics and Motor Control of Human Movement, table 4.1, after Dempster
  Rods,          ///< every bone a uniform rod whose mass goes with its length, whatever the figure
};

/// Where the mass of what a joint carries lies, in the joint's own axes, which stand like the world's in the rest pose.
struct OwnShape {
  glm::dvec3 com_m{0.0};                    ///< centre of mass, from the joint's origin
  std::array<double, 6> inertia_kgm2{};     ///< about the centre of mass: xx yy zz xy xz yz, as in symmetric_tensor()
  friend bool operator==(const OwnShape&, const OwnShape&) = default;
};

/// All that a joint carries, in place of what the table says.
struct OwnSegment {
  JointIndex joint = 0;
  double mass_kg = 0.0;           ///< >= 0
  std::optional<OwnShape> shape;  ///< none: that of the table, whose inertia goes along with the mass
  friend bool operator==(const OwnSegment&, const OwnSegment&) = default;
};

/// Parts of a human body.
enum class BodyPart : std::uint8_t { Head, Trunk, UpperArm, Forearm, Hand, Thigh, Shank, Foot };

/// Which part of the body begins at a joint, in place of what its name tells.
struct OwnPart {
  JointIndex joint = 0;
  std::optional<BodyPart> part;       ///< none: the joint carries nothing of its own
  BodySide side = BodySide::Middle;   ///< of a limb, Middle: both in one, as of a figure seen from the side
  friend bool operator==(const OwnPart&, const OwnPart&) = default;
};

/// What people say of a point that can touch the floor, in place of what its path tells.
struct OwnContact {
  NodeIndex node = 0;    ///< a node without children
  FrameIndex first = 0;
  FrameIndex last = 0;   ///< >= first; the frame belongs to it
  bool touches = true;
  friend bool operator==(const OwnContact&, const OwnContact&) = default;
};

/// What people have said of the masses of a figure and of its contacts with the floor; a BVH file has neither.
struct BodyChoice {
  std::optional<BodyTable> table;  ///< none: de Leva, male, where the joints tell a human body, else rods
  std::optional<double> mass_kg;   ///< > 0; none: that of the table's average subject
  std::vector<OwnSegment> segments{};  ///< rising by joint
  bool is_only_own = false;        ///< no table is asked: what is not in `segments` has no mass
  std::optional<glm::dvec3> gravity_mps2{};  ///< in the world; none: 9.81 down the up axis
  std::vector<OwnPart> parts{};    ///< rising by joint
  std::vector<OwnContact> contacts{};  ///< rising by node, then by frame; none overlaps another
  friend bool operator==(const BodyChoice&, const BodyChoice&) = default;
};

}  // namespace marey
