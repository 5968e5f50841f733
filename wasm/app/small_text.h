#pragma once

#include <fmt/format.h>

#include <iterator>
#include <string_view>
#include <utility>

namespace marey::app {

/// A text that is made anew in each frame: an id, a number with its unit. It stands on the stack and takes memory from the heap
/// only when it is very long. Ends with a NUL.
class SmallText {
 public:
  SmallText() { bytes_.push_back('\0'); }
  template <class... Values>
  explicit SmallText(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(bytes_), format, std::forward<Values>(values)...);
    bytes_.push_back('\0');
  }

  [[nodiscard]] const char* c_str() const { return bytes_.data(); }
  [[nodiscard]] std::string_view view() const { return {bytes_.data(), bytes_.size() - 1}; }
  operator std::string_view() const { return view(); }
  friend bool operator==(const SmallText& a, std::string_view b) { return a.view() == b; }

 private:
  static constexpr std::size_t kRoom = 120;
  fmt::basic_memory_buffer<char, kRoom> bytes_;
};

}  // namespace marey::app
