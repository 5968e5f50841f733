#include "core/skeleton/channel.h"

#include <algorithm>
#include <array>

namespace marey {
namespace {

constexpr std::array<std::string_view, 9> kKeywords = {"Xposition", "Yposition", "Zposition", "Xrotation", "Yrotation",
                                                       "Zrotation", "Xscale",    "Yscale",    "Zscale"};

constexpr char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool equal_ignoring_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return lower(x) == lower(y); });
}

}  // namespace

std::string_view channel_keyword(ChannelKind kind) {
  return kind == ChannelKind::Other ? std::string_view{} : kKeywords[static_cast<std::size_t>(kind)];
}

std::optional<ChannelKind> find_channel_kind(std::string_view keyword) {
  for (std::size_t i = 0; i < kKeywords.size(); ++i) {
    if (equal_ignoring_case(kKeywords[i], keyword)) return static_cast<ChannelKind>(i);
  }
  return std::nullopt;
}

}  // namespace marey
