#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/skeleton/skeleton.h"

namespace marey {

enum class BodySide : std::uint8_t { Middle, Left, Right };

/// The side that a joint's name speaks of: "LeftArm", "hip_l", "R Thigh", "rShldr", "lfemur", "Mão.Esquerda",
/// "левое плечо", "右手"; Middle when it speaks of none. Vertebrae ("L5") have no side.
[[nodiscard]] BodySide find_side_in_name(std::string_view name);

/// The side of each joint. By name where any name in the skeleton has a side; a joint without one belongs to the side
/// of its parent. Otherwise by place, for a figure whose rest pose is mirrored in x or in z: left is +x as seen from a
/// figure that looks along +z, or -z when it looks along +x. All Middle for a figure without either.
[[nodiscard]] std::vector<BodySide> compute_body_sides(const Skeleton& skeleton);

}  // namespace marey
