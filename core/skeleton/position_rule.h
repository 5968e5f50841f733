#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace marey {

/// What the position channels of a joint mean beside its OFFSET; real tools disagree (Blender and assimp replace,
/// three.js adds). An axis without a position channel keeps its OFFSET under either rule.
enum class PositionRule {
  Replace,   ///< the channel is the position in the parent's frame
  Add,       ///< the channel is added to OFFSET
  PerJoint,  ///< added where Skeleton::positions_add says so, replacing elsewhere
};

/// How programs call it, by its value.
inline constexpr std::array<std::string_view, 3> kPositionRuleIds = {"replace", "add", "per_joint"};

[[nodiscard]] constexpr std::string_view position_rule_id(PositionRule rule) {
  return kPositionRuleIds[static_cast<std::size_t>(rule)];
}

/// Nothing for a text that names none.
[[nodiscard]] constexpr std::optional<PositionRule> find_position_rule(std::string_view id) {
  for (std::size_t i = 0; i < kPositionRuleIds.size(); ++i) {
    if (kPositionRuleIds[i] == id) return static_cast<PositionRule>(i);
  }
  return std::nullopt;
}

}  // namespace marey
