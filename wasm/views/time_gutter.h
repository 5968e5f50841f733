#pragma once

namespace marey::app {

/// Widths beside the time axis, the same for ruler and curves so that their frames stand over one another.
inline constexpr float kChannelListWidth = 180.0f;
inline constexpr float kAxisGutter = 52.0f;

/// Room on the left of the time axis: channel list and value labels; labels alone on a narrow page.
[[nodiscard]] constexpr float time_gutter_left(bool compact) { return (compact ? 0.0f : kChannelListWidth) + kAxisGutter; }
[[nodiscard]] constexpr float time_gutter_right(bool compact) { return compact ? 40.0f : kAxisGutter; }

}  // namespace marey::app
