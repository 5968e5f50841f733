#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/biomechanics/quantity.h"
#include "core/skeleton/skeleton.h"

namespace marey {

/// One quantity of one owner, seen from somewhere.
struct AskedQuantity {
  const Quantity* quantity = nullptr;
  NodeIndex node = kNoParent;        ///< kNoParent for the whole body
  std::string label;                 ///< "torque:Body", "com", "position:Hand+0/0.1/0@Hips"
  glm::dvec3 point_m{0.0};           ///< a point fixed to the joint, from its origin in its axes
  std::optional<JointIndex> frame{};  ///< whose frame it is seen from, kNoParent for the world; none: see analyse()
};

/// A quantity of a node, kNoParent for the whole body, with its label. `frame` is what stands behind "@", "" for none. Refused as
/// below for a frame that there is not and one that the quantity cannot be seen from. Precondition: the node can have the
/// quantity, and `point_m` is 0 but for quantities of points, on joints.
[[nodiscard]] Result<AskedQuantity> ask_for(const Skeleton& skeleton, const Quantity& quantity, NodeIndex node,
                                            const glm::dvec3& point_m = glm::dvec3(0.0), std::string_view frame = {});

/// Whether two ask for the same numbers, whatever they are called.
[[nodiscard]] bool asks_the_same(const AskedQuantity& a, const AskedQuantity& b);

/// "NAME", "NAME:JOINT", and behind either "@FRAME"; '*' for every joint, or every joint and end site where the quantity is of
/// points. Behind a joint "+X/Y/Z" is a point fixed to it, in metres in its axes. FRAME is a joint, "world", "root" (the one
/// above the joint) or "parent". Names as node_label() gives them, taken whole before anything in them is read as one of
/// these signs; of joints of one name the first is meant. Refused with InvalidArgument: a quantity, joint or frame that there is
/// not, a missing or a needless one; the message names what could stand there.
[[nodiscard]] Result<std::vector<AskedQuantity>> find_quantities(const Skeleton& skeleton, std::span<const std::string> texts);

}  // namespace marey
