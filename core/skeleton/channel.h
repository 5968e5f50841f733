#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/math/axis.h"

namespace marey {

/// What one column of a BVH frame drives. Positions and scales are in file units and ratios, rotations in degrees.
enum class ChannelKind : std::uint8_t {
  Xposition,
  Yposition,
  Zposition,
  Xrotation,
  Yrotation,
  Zrotation,
  Xscale,
  Yscale,
  Zscale,
  Other,  ///< a name that Marey does not know: kept and written back, moves nothing
};

[[nodiscard]] constexpr bool is_position(ChannelKind kind) { return kind <= ChannelKind::Zposition; }
[[nodiscard]] constexpr bool is_rotation(ChannelKind kind) {
  return kind >= ChannelKind::Xrotation && kind <= ChannelKind::Zrotation;
}
[[nodiscard]] constexpr bool is_scale(ChannelKind kind) {
  return kind >= ChannelKind::Xscale && kind <= ChannelKind::Zscale;
}

/// Axis of a position, rotation or scale channel; X for Other.
[[nodiscard]] constexpr Axis axis_of(ChannelKind kind) {
  return kind == ChannelKind::Other ? Axis::X : static_cast<Axis>(static_cast<int>(kind) % 3);
}

/// "Xposition" ... "Zscale" as BVH writes them; "" for Other.
[[nodiscard]] std::string_view channel_keyword(ChannelKind kind);

/// The kind that a keyword names, in any case; nothing if it is not known.
[[nodiscard]] std::optional<ChannelKind> find_channel_kind(std::string_view keyword);

}  // namespace marey
