#include "core/bvh/text_encoding.h"

#include <fmt/format.h>

#include <cstdint>
#include <utility>

#include "core/base/counted.h"
#include "core/text/utf8.h"

namespace marey {
namespace {

constexpr std::string_view kUtf8Mark = "\xef\xbb\xbf";
constexpr std::string_view kUtf16LittleEndianMark = "\xff\xfe";
constexpr std::string_view kUtf16BigEndianMark = "\xfe\xff";

bool begins_with(std::string_view text, std::string_view start) { return text.substr(0, start.size()) == start; }

unsigned byte_at(std::string_view bytes, std::size_t at) { return static_cast<unsigned char>(bytes[at]); }

struct Conversion {
  std::string utf8;
  int lone_halves = 0;  ///< of surrogate pairs; U+FFFD stands for each
};

Conversion utf8_from_utf16(std::string_view bytes, bool little_endian) {
  const auto unit_at = [&](std::size_t at) {
    const unsigned first = byte_at(bytes, at);
    const unsigned second = byte_at(bytes, at + 1);
    return static_cast<char32_t>(little_endian ? first | second << 8 : first << 8 | second);
  };
  Conversion result;
  std::string& out = result.utf8;
  out.reserve(bytes.size() / 2);
  for (std::size_t at = 0; at + 1 < bytes.size(); at += 2) {
    const char32_t unit = unit_at(at);
    const bool high = unit >= 0xd800 && unit < 0xdc00;
    const char32_t next = high && at + 3 < bytes.size() ? unit_at(at + 2) : 0;
    if (next >= 0xdc00 && next < 0xe000) {
      append_utf8(0x10000 + ((unit - 0xd800) << 10) + (next - 0xdc00), out);
      at += 2;
    } else {
      const bool lone = unit >= 0xd800 && unit < 0xe000;
      result.lone_halves += lone ? 1 : 0;
      append_utf8(lone ? kReplacement : unit, out);
    }
  }
  return result;
}

void take_utf16(std::string_view bytes, bool little_endian, DecodedText& decoded, Report& report) {
  Conversion conversion = utf8_from_utf16(bytes.substr(2), little_endian);
  decoded.encoding = little_endian ? TextEncoding::Utf16LittleEndian : TextEncoding::Utf16BigEndian;
  decoded.converted = std::move(conversion.utf8);
  decoded.text = decoded.converted;
  report.add(DiagnosticCode::Utf16Text, 0, "The file is UTF-16 and is saved so; most other programs want UTF-8.",
             "UTF-8", "UTF-16");
  if (conversion.lone_halves > 0) {
    report.add(DiagnosticCode::UnexpectedToken, 0,
               fmt::format("The file has {} without the other half; each was read as U+FFFD.",
                           counted(conversion.lone_halves, "half UTF-16 character")),
               "UTF-16", "half of a pair");
  }
  if (bytes.size() % 2 != 0) {
    report.add(DiagnosticCode::UnexpectedEnd, 0, "The file ends within a UTF-16 character; its last byte was left out.",
               "an even number of bytes", counted(static_cast<std::int64_t>(bytes.size()), "byte"));
  }
}

std::size_t size_without_trailing_nuls(std::string_view text) {
  const std::size_t last = text.find_last_not_of('\0');
  return last == std::string_view::npos ? 0 : last + 1;
}

void drop_trailing_nuls(DecodedText& decoded, Report& report) {
  const std::size_t size = size_without_trailing_nuls(decoded.text);
  if (size < decoded.text.size() && trimmed(decoded.text.substr(0, size)).empty()) {
    report.fail(DiagnosticCode::EmptyFile, 0,
                fmt::format("The file holds nothing but {}; it was never written properly. Use another copy.",
                            counted(static_cast<std::int64_t>(decoded.text.size()), "NUL byte")),
                "HIERARCHY", "NUL");
    return;
  }
  decoded.text = without_trailing_nuls(decoded.text, 0, report);
}

}  // namespace

void decode_text(std::string_view bytes, DecodedText& decoded, Report& report) {
  decoded.text = bytes;
  const bool little_endian = begins_with(bytes, kUtf16LittleEndianMark);
  if (little_endian || begins_with(bytes, kUtf16BigEndianMark)) {
    take_utf16(bytes, little_endian, decoded, report);
  } else if (begins_with(bytes, kUtf8Mark)) {
    decoded.begin = kUtf8Mark.size();
    report.add(DiagnosticCode::ByteOrderMark, 0,
               "The file begins with a byte order mark, which is kept; some other programs refuse it.", "HIERARCHY",
               "byte order mark");
  } else if (bytes.size() > 1 && (bytes[0] == '\0') != (bytes[1] == '\0')) {
    report.fail(DiagnosticCode::UnsupportedEncoding, 0,
                "The file looks like UTF-16 without a byte order mark. Save it as UTF-8 and open it again.", "UTF-8",
                "a NUL byte");
    return;
  }
  drop_trailing_nuls(decoded, report);
  if (!report.failed() && trimmed(decoded.text.substr(decoded.begin)).empty()) {
    report.fail(DiagnosticCode::EmptyFile, 0, "The file is empty. Open a file written as BVH.", "HIERARCHY",
                "the end of the file");
  }
}

std::string_view without_trailing_nuls(std::string_view text, std::size_t begin, Report& report) {
  const std::size_t size = size_without_trailing_nuls(text);
  if (size == text.size()) return text;
  report.add(DiagnosticCode::TrailingNul, begin + size,
             fmt::format("Behind the text the file goes on with {}, kept as they are.",
                         counted(static_cast<std::int64_t>(text.size() - size), "NUL byte")),
             "", "NUL bytes");
  return text.substr(0, size);
}

std::string_view text_in_utf8(std::string_view bytes, std::string& converted) {
  const bool little_endian = begins_with(bytes, kUtf16LittleEndianMark);
  if (!little_endian && !begins_with(bytes, kUtf16BigEndianMark)) return bytes;
  converted = utf8_from_utf16(bytes.substr(2), little_endian).utf8;
  return converted;
}

std::string encoded_as_utf16(std::string_view utf8, TextEncoding encoding) {
  const bool little_endian = encoding == TextEncoding::Utf16LittleEndian;
  std::string out(little_endian ? kUtf16LittleEndianMark : kUtf16BigEndianMark);
  const auto add_unit = [&](char32_t unit) {
    const char low = static_cast<char>(static_cast<unsigned char>(unit & 0xff));
    const char high = static_cast<char>(static_cast<unsigned char>(unit >> 8 & 0xff));
    out += little_endian ? low : high;
    out += little_endian ? high : low;
  };
  for (std::size_t at = begins_with(utf8, kUtf8Mark) ? kUtf8Mark.size() : 0; at < utf8.size();) {
    const unsigned byte = byte_at(utf8, at);
    const char32_t code_point = take_utf8(utf8, at).value_or(byte);  // bytes that are not UTF-8 count as Latin-1
    if (code_point < 0x10000) {
      add_unit(code_point);
    } else {
      add_unit(0xd800 + ((code_point - 0x10000) >> 10));
      add_unit(0xdc00 + ((code_point - 0x10000) & 0x3ff));
    }
  }
  return out;
}

}  // namespace marey
