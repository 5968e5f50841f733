#include "core/base/byte_search.h"

#include <algorithm>

namespace marey {
namespace {

constexpr std::size_t kBlock = 64;

/// Where in text[from, end) is_wanted() holds first; npos if nowhere.
template <class IsWanted>
std::size_t find_in(std::string_view text, std::size_t from, IsWanted is_wanted) {
  const std::string_view rest = text.substr(std::min(from, text.size()));
  const auto at = std::find_if(rest.begin(), rest.end(), is_wanted);
  return at == rest.end() ? std::string_view::npos : from + static_cast<std::size_t>(at - rest.begin());
}

}  // namespace

std::size_t find_either(std::string_view text, char a, char b, std::size_t from) {
  for (; from + kBlock <= text.size(); from += kBlock) {
    const char* block = text.data() + from;
    unsigned char found = 0;
    for (std::size_t i = 0; i < kBlock; ++i) {
      found = static_cast<unsigned char>(found | static_cast<unsigned char>((block[i] == a) | (block[i] == b)));
    }
    if (found != 0) break;
  }
  return find_in(text, from, [a, b](char c) { return c == a || c == b; });
}

std::size_t find_beyond_ascii(std::string_view text, std::size_t from) {
  for (; from + kBlock <= text.size(); from += kBlock) {
    const char* block = text.data() + from;
    unsigned char bits = 0;
    for (std::size_t i = 0; i < kBlock; ++i) bits = static_cast<unsigned char>(bits | static_cast<unsigned char>(block[i]));
    if (bits >= 0x80) break;
  }
  return find_in(text, from, [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
}

std::size_t count_line_ends(std::string_view text, std::size_t from, std::size_t to) {
  constexpr std::size_t kMostInByte = 255;
  std::size_t count = 0;
  while (from < to) {
    const std::size_t block = std::min(kMostInByte, to - from);
    unsigned char feeds = 0;
    unsigned char returns = 0;
    for (std::size_t i = 0; i < block; ++i) {
      feeds = static_cast<unsigned char>(feeds + (text[from + i] == '\n' ? 1 : 0));
      returns = static_cast<unsigned char>(returns + (text[from + i] == '\r' ? 1 : 0));
    }
    count += feeds;
    if (returns > 0) {
      for (std::size_t i = from; i < from + block; ++i) count += text[i] == '\r' && text.substr(i + 1, 1) != "\n" ? 1U : 0U;
    }
    from += block;
  }
  return count;
}

}  // namespace marey
