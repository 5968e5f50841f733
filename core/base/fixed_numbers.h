#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace marey {

/// Reads numbers that stand one behind the other, each "[-]digits.digits" with the same gap in front and the same decimals, as
/// neighbouring columns of nearly every row are. Where a number ends is known as soon as its point is found, before any digit
/// has been looked at, and whether anything was wrong is asked once, behind the last one: a processor works on several numbers
/// at once, and on the digits of each in one register.
class FixedNumbers {
 public:
  static constexpr int kMostDecimals = 8;
  static constexpr std::size_t kLongestGap = 4;
  /// Bytes that read() may look at before its first one,
  static constexpr int kReachBefore = 17;
  /// from there on for each number,
  static constexpr int kReachPerNumber = 16;
  /// and behind the last one.
  static constexpr int kReachBehind = 16;

  /// A gap of 1 to kLongestGap bytes; 1 <= decimals <= kMostDecimals.
  FixedNumbers(std::string_view gap, int decimals);

  /// Reads `count` numbers, from the gap of the first one on, into `values` and gives their end. Null, with `values` undefined,
  /// unless all have just that gap and these decimals, no surplus zero in front, at most 7 bytes from the gap to the point, and
  /// a blank stands behind the last one. Values are correctly rounded: at most 15 digits make an exact dividend.
  [[nodiscard]] const char* read(const char* p, int count, double* values) const;

 private:
  std::uint64_t gap_word_ = 0;
  std::uint64_t gap_mask_;
  std::int64_t gap_length_;
  std::int64_t decimals_;
  double scale_;
};

}  // namespace marey
