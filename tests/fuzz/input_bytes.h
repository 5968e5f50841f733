#pragma once

#include <cstdint>
#include <string_view>

namespace marey::test {

/// Decisions taken from the front of an input. An input that is used up gives zeros, so each one is a whole test.
class InputBytes {
 public:
  explicit InputBytes(std::string_view bytes) : bytes_(bytes) {}

  [[nodiscard]] bool empty() const { return bytes_.empty(); }
  [[nodiscard]] std::string_view rest() const { return bytes_; }

  int take_byte() {
    if (bytes_.empty()) return 0;
    const auto byte = static_cast<unsigned char>(bytes_.front());
    bytes_.remove_prefix(1);
    return byte;
  }
  /// 0 <= result < end, end <= 256; 0 for end <= 0.
  int take_below(int end) {
    const int byte = take_byte();
    return end <= 0 ? 0 : byte % end;
  }
  /// Around [-1, count], so that some lie outside of [0, count).
  int take_near(int count) { return take_byte() % (count + 2) - 1; }

 private:
  std::string_view bytes_;
};

}  // namespace marey::test
