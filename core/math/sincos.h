#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/math/lanes.h"

namespace marey {

/// Sine and cosine of one angle (T = double) or of several (T = Lanes).
template <class T>
struct SinCos {
  T sine;
  T cosine;
};

/// Within 2 ulp; NaN for NaN and infinity. Multiples of 90 degrees give exactly 0 and +-1. Made of + - * and exact
/// operations only, so the bits are the same on every machine, native or wasm, and for double and Lanes.
[[nodiscard]] SinCos<double> sincos_deg(double angle_deg);
[[nodiscard]] SinCos<Lanes> sincos_deg(const Lanes& angle_deg);

namespace sincos_detail {

/// Up to this size an angle is reduced by rounding; larger ones are brought into one turn first.
inline constexpr double kLargeAngleDeg = 1099511627776.0;  // 2^40

/// Brings large angles into one turn, exactly.
[[nodiscard]] double within_one_turn(double angle_deg);
[[nodiscard]] Lanes within_one_turn(const Lanes& angle_deg);

/// Adding this to |x| < 2^51 rounds x to an integer, which then stands in the low bits of the sum.
inline constexpr double kRoundToInteger = 6755399441055744.0;  // 1.5 * 2^52

// fdlibm's polynomials for sine and cosine on [-pi/4, pi/4] in powers of the squared angle, restated in degrees.
// The leading coefficient of the sine, pi/180, has its rounding error as a second word.
inline constexpr double kSineHigh = 0.017453292519943295;
inline constexpr double kSine[] = {2.9486522708701687e-19, -8.860961557012962e-07, 1.3496016231614988e-11,
                                   -9.788384855987847e-17, 4.141266588184523e-22,  -1.146758463569729e-27,
                                   2.2167590637893565e-33};
inline constexpr double kCosine2 = 0.0001523087098933543;
inline constexpr double kCosine4[] = {3.866323851562988e-09,   -3.925831985738917e-14, 2.1354943025522278e-19,
                                      -7.227873885660916e-25, 1.6678997404084905e-30, -2.7646999426681e-36};

template <class T, std::size_t N>
[[nodiscard]] inline T polynomial(const T& x, const double (&coefficients)[N]) {
  T sum = x * coefficients[N - 1] + coefficients[N - 2];
  for (std::size_t i = N - 2; i-- > 0;) sum = sum * x + coefficients[i];
  return sum;
}

template <class To, class From>
[[nodiscard]] inline To bits_as(const From& from) {
  static_assert(sizeof(To) == sizeof(From));
  To to;
  std::memcpy(&to, &from, sizeof(To));
  return to;
}

/// For |angle_deg| <= kLargeAngleDeg. The reduction r = angle - 90 n, |r| <= 45, is exact: neither 90 n nor the
/// difference rounds, since degrees, unlike radians, divide a turn evenly.
template <class T, class Bits>
[[nodiscard]] inline SinCos<T> sincos_small_deg(const T& angle_deg) {
  const T shifted = angle_deg * (1.0 / 90.0) + kRoundToInteger;
  const T r = angle_deg - (shifted - kRoundToInteger) * 90.0;
  const T r2 = r * r;
  const T sine = kSineHigh * r + polynomial(r2, kSine) * r;
  const T cosine = 1.0 - (kCosine2 * r2 - polynomial(r2, kCosine4) * (r2 * r2));

  // Odd quarter turns swap the two; bit 1 of the quarter and of its successor are their signs.
  const Bits quarter = bits_as<Bits>(shifted);
  const Bits sine_bits = bits_as<Bits>(sine);
  const Bits cosine_bits = bits_as<Bits>(cosine);
  const Bits swapped = (sine_bits ^ cosine_bits) & -(quarter & 1);
  return {bits_as<T>(sine_bits ^ swapped ^ ((quarter & 2) << 62)),
          bits_as<T>(cosine_bits ^ swapped ^ (((quarter + 1) & 2) << 62))};
}

}  // namespace sincos_detail

inline SinCos<double> sincos_deg(double angle_deg) {
  return sincos_detail::sincos_small_deg<double, std::uint64_t>(sincos_detail::within_one_turn(angle_deg));
}

inline SinCos<Lanes> sincos_deg(const Lanes& angle_deg) {
  using namespace sincos_detail;
  const auto is_large = (angle_deg > kLargeAngleDeg) | (angle_deg < -kLargeAngleDeg);
  if ((is_large[0] | is_large[1]) != 0) [[unlikely]] {
    return sincos_small_deg<Lanes, LaneBits>(within_one_turn(angle_deg));
  }
  return sincos_small_deg<Lanes, LaneBits>(angle_deg);
}

}  // namespace marey
