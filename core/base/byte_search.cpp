#include "core/base/byte_search.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace marey {
namespace {

using Bytes = std::uint8_t __attribute__((vector_size(16)));

/// Bytes that are wanted are not 0 afterwards; the others are.
using Wanted = Bytes;

constexpr std::size_t kBlock = 4 * sizeof(Bytes);

/// Whether a block of kBlock bytes has a wanted one.
template <class MarkWanted>
bool has_wanted(const char* block, MarkWanted mark_wanted) {
  Bytes parts[4];
  std::memcpy(parts, block, sizeof parts);
  const Wanted wanted = mark_wanted(parts[0]) | mark_wanted(parts[1]) | mark_wanted(parts[2]) | mark_wanted(parts[3]);
  std::uint64_t bits[2];
  std::memcpy(bits, &wanted, sizeof bits);
  return (bits[0] | bits[1]) != 0;
}

/// From `from` on, the begin of the first block that has a wanted byte, or of what is left behind the last block.
template <class MarkWanted>
std::size_t pass_blocks(std::string_view text, std::size_t from, MarkWanted mark_wanted) {
  while (from + kBlock <= text.size() && !has_wanted(text.data() + from, mark_wanted)) from += kBlock;
  return from;
}

/// Marks what is one of two bytes.
auto mark_either(char a, char b) {
  return [a = static_cast<std::uint8_t>(a), b = static_cast<std::uint8_t>(b)](Bytes bytes) {
    return reinterpret_cast<Wanted>(bytes == a) | reinterpret_cast<Wanted>(bytes == b);
  };
}

/// Where in text[from, end) is_wanted() holds first; npos if nowhere.
template <class IsWanted>
std::size_t find_in(std::string_view text, std::size_t from, IsWanted is_wanted) {
  const std::string_view rest = text.substr(std::min(from, text.size()));
  const auto at = std::find_if(rest.begin(), rest.end(), is_wanted);
  return at == rest.end() ? std::string_view::npos : from + static_cast<std::size_t>(at - rest.begin());
}

}  // namespace

std::size_t find_either(std::string_view text, char a, char b, std::size_t from) {
  return find_in(text, pass_blocks(text, from, mark_either(a, b)), [a, b](char c) { return c == a || c == b; });
}

std::size_t find_last_line_end(std::string_view text) {
  const auto mark = mark_either('\r', '\n');
  std::size_t end = text.size();
  while (end >= kBlock && !has_wanted(text.data() + end - kBlock, mark)) end -= kBlock;
  while (end > 0 && text[end - 1] != '\r' && text[end - 1] != '\n') --end;
  return end == 0 ? std::string_view::npos : end - 1;
}

std::size_t find_beyond_ascii(std::string_view text, std::size_t from) {
  const auto mark = [](Bytes bytes) { return bytes & 0x80; };
  return find_in(text, pass_blocks(text, from, mark), [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
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
