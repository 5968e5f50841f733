#include "cli/frame_selection.h"

#include <charconv>
#include <system_error>

namespace marey::cli {
namespace {

std::optional<int> parse_frame_number(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_whole = error == std::errc() && end == text.data() + text.size();
  return is_whole && number >= 1 ? std::optional(number) : std::nullopt;
}

}  // namespace

std::optional<FrameSelection> parse_frame_selection(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const std::optional<int> first = parse_frame_number(text.substr(0, colon));
  const std::optional<int> last = parse_frame_number(text.substr(colon + 1));
  if (!first || !last || *last < *first) return std::nullopt;
  return FrameSelection{*first, *last};
}

}  // namespace marey::cli
