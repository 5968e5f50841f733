#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/index.h"
#include "core/skeleton/skeleton.h"

namespace marey::lint {

/// "'Hips'", shortened and without control characters as shown() has it.
[[nodiscard]] std::string quoted(std::string_view name);

/// "'A'", "'A' and 'B'", "'A', 'B', 'C' and 17 more". Not empty.
[[nodiscard]] std::string listed(const std::vector<std::string>& items);
/// The same for the labels of nodes.
[[nodiscard]] std::string listed(const Skeleton& skeleton, const std::vector<NodeIndex>& nodes);

/// "frame 12", "frames 12-20": numbered from 1.
[[nodiscard]] std::string frames_text(FrameRange frames);

/// Three significant digits, "0.0123", "45.6", "1230".
[[nodiscard]] std::string rounded(double value);

/// "12.3 units", and "12.3 units (0.123 m)" where the unit is known.
[[nodiscard]] std::string length_text(double length, std::optional<double> metres_per_unit);

/// An amount of a channel: "45.6 degrees", or a length.
[[nodiscard]] std::string amount_text(const Channel& channel, double amount, std::optional<double> metres_per_unit);

}  // namespace marey::lint
