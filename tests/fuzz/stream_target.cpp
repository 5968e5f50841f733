#include <algorithm>

#include "tests/fuzz/input_bytes.h"
#include "tests/fuzz/target.h"
#include "tests/support/streamed.h"

namespace marey::test {
namespace {

/// The row behind the frame time forty times more, so that there are enough rows to be read while they come.
std::string with_more_rows(std::string_view text) {
  constexpr int kMore = 40;
  const std::size_t time = text.find("Time:");
  const std::size_t begin = text.find('\n', std::min(time, text.size()));
  if (begin == std::string_view::npos) return std::string(text);
  const std::string_view row = text.substr(begin, text.find('\n', begin + 1) - begin);
  std::string result(text.substr(0, begin));
  for (int i = 0; i < kMore; ++i) result += row;
  return result += text.substr(begin);
}

}  // namespace

Harm find_harm_in_streaming(std::string_view input) {
  InputBytes choices(input);
  StreamOptions options;
  options.step_bytes = static_cast<std::size_t>(1 + 8 * choices.take_byte());
  const auto piece = static_cast<std::size_t>(1 + 2 * choices.take_byte());
  const std::string text = with_more_rows(choices.rest());
  if (choices.take_byte() % 2 == 0) options.expected_bytes = static_cast<std::int64_t>(text.size());
  const std::string difference = difference_when_streamed(text, options, [piece] { return piece; });
  return difference.empty() ? std::nullopt : Harm(difference);
}

}  // namespace marey::test
