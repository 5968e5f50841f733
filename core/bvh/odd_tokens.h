#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/bvh/style.h"

namespace marey {

/// Collects the samples whose text their column does not predict, up to a bound in memory.
class OddTokens {
 public:
  /// Keeps at most `most_bytes`, later tokens are forgotten.
  explicit OddTokens(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  /// `index` rises from call to call.
  void add(std::int64_t index, double value, std::string_view gap, std::string_view number);

  /// Raises the bound.
  void allow(std::size_t most_bytes) { most_bytes_ = std::max(most_bytes_, most_bytes); }

  /// For going back when a row turns out to be irregular.
  struct Mark {
    std::size_t tokens = 0;
    std::size_t text = 0;
  };
  [[nodiscard]] Mark mark() const { return {tokens_.size(), text_.size()}; }
  void go_back(Mark mark) {
    tokens_.resize(mark.tokens);
    text_.resize(mark.text);
  }

  /// True if a token had to be forgotten.
  [[nodiscard]] bool overflowed() const { return overflowed_; }

  void move_into(MotionStyle& style);

 private:
  std::size_t most_bytes_;
  std::vector<OddToken> tokens_;
  std::string text_;
  bool overflowed_ = false;
};

}  // namespace marey
