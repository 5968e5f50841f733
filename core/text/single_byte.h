#pragma once

namespace marey {

// The single-byte code pages of Windows, as the WHATWG Encoding Standard has them but without its control characters:
// letters of bytes, bytes of letters. 0 means that there is none.

/// Precondition: 0x80 <= byte <= 0xff.
[[nodiscard]] char32_t windows_1251_letter(unsigned byte);
[[nodiscard]] char32_t windows_1252_letter(unsigned byte);

[[nodiscard]] unsigned windows_1251_code(char32_t letter);
[[nodiscard]] unsigned windows_1252_code(char32_t letter);

}  // namespace marey
