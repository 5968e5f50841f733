#include "core/bvh/odd_tokens.h"

#include <utility>

namespace marey {

void OddTokens::add(std::int64_t index, double value, std::string_view gap, std::string_view number) {
  const std::size_t bytes = (tokens_.size() + 1) * sizeof(OddToken) + text_.size() + gap.size() + number.size();
  overflowed_ = overflowed_ || bytes > most_bytes_;
  if (overflowed_) return;
  const auto begin = static_cast<std::uint32_t>(text_.size());
  tokens_.push_back({index, value, begin, begin + static_cast<std::uint32_t>(gap.size())});
  text_.append(gap).append(number);
}

void OddTokens::move_into(MotionStyle& style) {
  style.odd_tokens = std::exchange(tokens_, {});
  style.odd_text = std::exchange(text_, {});
}

}  // namespace marey
