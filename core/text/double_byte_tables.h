#pragma once

#include <span>
#include <string_view>

namespace marey {

// The letters of the double-byte character sets, as rows of up to 94 or 96; a row ends with its last letter, and
// kNoLetter stands where a code has none. How they came here: docs/decisions/character-sets.md.

inline constexpr char16_t kNoLetter = u'\u25af';

/// Rows of the lead bytes A1 to F7, from trail byte A1 on: GB/T 2312 with what GBK adds to its first nine rows.
[[nodiscard]] std::span<const std::u16string_view> gb2312_rows();
/// Rows of the lead bytes A8 and A9 from trail byte 40 on, without 7F: the symbols of GBK/5.
[[nodiscard]] std::span<const std::u16string_view> gbk_symbol_rows();
/// What follows the last unified ideograph of GBK/4 (code FD9B): FD9C to FDA0 and FE40 to FE4F.
[[nodiscard]] std::u16string_view gbk_compatibility_ideographs();

/// Rows 1 to 119 of Windows code page 932: JIS X 0208 with the additions of NEC and IBM. Two rows to a lead byte.
[[nodiscard]] std::span<const std::u16string_view> jis_rows();

}  // namespace marey
