#include "core/lint/wording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/text_cursor.h"

namespace marey::lint {

std::string quoted(std::string_view name) { return fmt::format("'{}'", shown(name)); }

std::string listed(const std::vector<std::string>& items) {
  constexpr std::size_t kMostItems = 4;
  if (items.size() > kMostItems) {
    std::string text;
    for (std::size_t i = 0; i + 1 < kMostItems; ++i) text += (i == 0 ? "" : ", ") + items[i];
    return fmt::format("{} and {} more", text, items.size() - kMostItems + 1);
  }
  std::string text = items.front();
  for (std::size_t i = 1; i < items.size(); ++i) text += (i + 1 == items.size() ? " and " : ", ") + items[i];
  return text;
}

std::string listed(const Skeleton& skeleton, const std::vector<NodeIndex>& nodes) {
  std::vector<std::string> items;
  items.reserve(nodes.size());
  for (NodeIndex node : nodes) items.push_back(quoted(node_label(skeleton, node)));
  return listed(items);
}

std::string frames_text(FrameRange frames) {
  return frames.count == 1 ? fmt::format("frame {}", frames.first + 1)
                           : fmt::format("frames {}-{}", frames.first + 1, frames.end());
}

std::string rounded(double value) {
  const double size = std::abs(value);
  if (size == 0.0) return "0";
  if (!(size >= 1e-4 && size < 1e15)) return fmt::format("{:.3g}", value);
  const int decimals = std::max(0, 2 - static_cast<int>(std::floor(std::log10(size))));
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (decimals == 0) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string length_text(double length, std::optional<double> metres_per_unit) {
  const std::string units = fmt::format("{} units", rounded(length));
  return metres_per_unit ? fmt::format("{} ({} m)", units, rounded(length * *metres_per_unit)) : units;
}

std::string amount_text(const Channel& channel, double amount, std::optional<double> metres_per_unit) {
  return is_rotation(channel.kind) ? fmt::format("{} degrees", rounded(amount)) : length_text(amount, metres_per_unit);
}

}  // namespace marey::lint
