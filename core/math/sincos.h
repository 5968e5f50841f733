#pragma once

#include <cstdint>
#include <cstring>

namespace marey {

/// Sine and cosine of one angle, or of several where T is a SIMD vector of doubles.
template <class T>
struct SinCos {
  T sine;
  T cosine;
};

/// Beyond this the angle is first brought into one turn.
inline constexpr double kLargeAngleDeg = 1099511627776.0;  // 2^40

namespace sincos_detail {

// Adding this to |x| < 2^51 rounds x to an integer that stands in the low bits of the sum.
inline constexpr double kRoundToInteger = 6755399441055744.0;  // 1.5 * 2^52

template <class T>
struct BitsOf;
template <>
struct BitsOf<double> {
  using type = std::uint64_t;
};

template <class To, class From>
[[nodiscard]] inline To bits_as(const From& from) {
  static_assert(sizeof(To) == sizeof(From));
  To to;
  std::memcpy(&to, &from, sizeof(To));
  return to;
}

}  // namespace sincos_detail

/// Sine and cosine for |angle_deg| <= kLargeAngleDeg, within 1.5 ulp; NaN for NaN and infinity. Multiples of 90 degrees
/// give exactly 0 and +-1. Arithmetic is only + - *: the bits are the same on every machine, native or wasm.
///
/// The reduction is exact: r = angle - 90 n has |r| <= 45, and neither the product nor the difference rounds, since
/// degrees, unlike radians, divide a turn evenly. The polynomials are those of fdlibm on [-pi/4, pi/4], restated in
/// degrees.
template <class T>
[[nodiscard]] inline SinCos<T> sincos_small_deg(T angle_deg) {
  using Bits = typename sincos_detail::BitsOf<T>::type;
  using sincos_detail::bits_as;
  using sincos_detail::kRoundToInteger;

  const T shifted = angle_deg * (1.0 / 90.0) + kRoundToInteger;
  const T r = angle_deg - (shifted - kRoundToInteger) * 90.0;
  const T r2 = r * r;
  const T s = ((((2.2167590637893565e-33 * r2 - 1.146758463569729e-27) * r2 + 4.141266588184523e-22) * r2 -
                9.788384855987847e-17) *
                   r2 +
               1.3496016231614988e-11) *
                  r2 -
              8.860961557012962e-07;
  const T sine = 0.017453292519943295 * r + (s * r2 + 2.9486522708701687e-19) * r;
  const T c = ((((-2.7646999426681e-36 * r2 + 1.6678997404084905e-30) * r2 - 7.227873885660916e-25) * r2 +
                2.1354943025522278e-19) *
                   r2 -
               3.925831985738917e-14) *
                  r2 +
              3.866323851562988e-09;
  const T cosine = 1.0 - (0.0001523087098933543 * r2 - c * (r2 * r2));

  const Bits quarter = bits_as<Bits>(shifted);
  const Bits swap = -(quarter & 1);
  const Bits sine_bits = bits_as<Bits>(sine);
  const Bits cosine_bits = bits_as<Bits>(cosine);
  const Bits difference = (sine_bits ^ cosine_bits) & swap;
  return {bits_as<T>(sine_bits ^ difference ^ ((quarter & 2) << 62)),
          bits_as<T>(cosine_bits ^ difference ^ (((quarter + 1) & 2) << 62))};
}

/// Sine and cosine of any angle; NaN for NaN and infinity.
[[nodiscard]] SinCos<double> sincos_deg(double angle_deg);

}  // namespace marey
