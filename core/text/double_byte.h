#pragma once

namespace marey {

// The double-byte code pages of Windows for Chinese (936) and Japanese (932), without the areas for private use. A code
// is a byte from 80 to FF, or lead byte * 256 + trail byte. 0 means that there is none.

[[nodiscard]] char32_t gbk_letter(unsigned code);
[[nodiscard]] char32_t shift_jis_letter(unsigned code);

/// The reverse; the first call makes a table.
[[nodiscard]] unsigned gbk_code(char32_t letter);
[[nodiscard]] unsigned shift_jis_code(char32_t letter);

}  // namespace marey
