#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/bvh/report.h"
#include "core/bvh/style.h"

namespace marey {

/// A file's bytes as text.
struct DecodedText {
  std::string_view text;     ///< the input itself, or `converted`; without NUL bytes at its end
  std::size_t begin = 0;     ///< behind a byte order mark
  std::string converted;     ///< UTF-8, where the file was UTF-16
  TextEncoding encoding = TextEncoding::Bytes;

  DecodedText() = default;
  DecodedText(const DecodedText&) = delete;
  DecodedText& operator=(const DecodedText&) = delete;
};

/// Finds out the encoding; fails for a file without text. Bytes that are not UTF-8 stay as they are. `report` belongs
/// to the bytes of the file.
void decode_text(std::string_view bytes, DecodedText& decoded, Report& report);

/// `text`, the end of a file from its byte `begin` on, without the NUL bytes at its end, which are reported.
[[nodiscard]] std::string_view without_trailing_nuls(std::string_view text, std::size_t begin, Report& report);

/// The text that the places of findings count in: the bytes of the file or, where they are UTF-16, `converted`, which
/// gets their UTF-8.
[[nodiscard]] std::string_view text_in_utf8(std::string_view bytes, std::string& converted);

/// UTF-8 (byte order mark optional) as UTF-16 with a byte order mark.
[[nodiscard]] std::string encoded_as_utf16(std::string_view utf8, TextEncoding encoding);

}  // namespace marey
