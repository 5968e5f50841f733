#pragma once

#include <cstdint>
#include <random>

namespace marey::test {

/// Random numbers that are the same on every machine (the distributions of <random> are not).
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  [[nodiscard]] std::uint64_t bits() { return engine_(); }
  /// 0 <= result < end; 0 for end <= 0.
  [[nodiscard]] int below(int end) { return end <= 0 ? 0 : static_cast<int>(engine_() % static_cast<std::uint64_t>(end)); }
  [[nodiscard]] bool one_in(int n) { return below(n) == 0; }
  /// Uniform in [0, 1).
  [[nodiscard]] double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  [[nodiscard]] double between(double low, double high) { return low + (high - low) * unit(); }
  /// Any finite double, all bit patterns equally likely.
  [[nodiscard]] double any_finite();

 private:
  std::mt19937_64 engine_;
};

}  // namespace marey::test
