#include "core/base/fixed_numbers.h"

#include <array>
#include <bit>
#include <cstring>

#include "core/base/plain_number.h"

namespace marey {
namespace {

using Bytes = std::uint8_t __attribute__((vector_size(16)));
using Pairs = std::uint16_t __attribute__((vector_size(16)));
using Fours = std::int32_t __attribute__((vector_size(16)));
using Halves = std::uint64_t __attribute__((vector_size(16)));
using Doubles = double __attribute__((vector_size(32)));

Bytes load_bytes(const void* p) {
  Bytes bytes;
  std::memcpy(&bytes, p, sizeof bytes);
  return bytes;
}

constexpr std::array<std::uint8_t, 32> kLastBytes = {0,    0,    0,    0,    0,    0,    0,    0,    0,    0,    0,
                                                     0,    0,    0,    0,    0,    0xff, 0xff, 0xff, 0xff, 0xff, 0xff,
                                                     0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff};

/// Keeps the last `count` bytes of a register, 0 to 15.
Bytes last_bytes(std::int64_t count) { return load_bytes(kLastBytes.data() + (count & 15)); }

/// The number that sixteen digits make, the first at the lowest address: they become pairs, then fours. Below 10^15 every sum
/// is exact.
double number_of(Bytes digits) {
  const Pairs pairs = reinterpret_cast<Pairs>(digits) * (10 * 256 + 1) >> 8;
  const Fours hundreds = reinterpret_cast<Fours>(pairs * Pairs{100, 1, 100, 1, 100, 1, 100, 1});
  const Fours fours = (hundreds & 0xffff) + (hundreds >> 16);
  const Doubles parts = __builtin_convertvector(fours, Doubles) * Doubles{1e12, 1e8, 1e4, 1.0};
  return (parts[0] + parts[2]) + (parts[1] + parts[3]);
}

/// Where the first byte is 0, its highest bit is the lowest one set.
std::uint64_t zero_bytes(std::uint64_t word) { return (word - 0x0101010101010101U) & ~word & 0x8080808080808080U; }

/// Without a branch: signs cannot be predicted.
double with_sign(double magnitude, std::uint64_t negative) {
  std::uint64_t bits;
  std::memcpy(&bits, &magnitude, sizeof bits);
  bits |= negative << 63;
  std::memcpy(&magnitude, &bits, sizeof bits);
  return magnitude;
}

}  // namespace

FixedNumbers::FixedNumbers(std::string_view gap, int decimals)
    : gap_mask_(~std::uint64_t{0} >> (64 - 8 * gap.size())),
      gap_length_(static_cast<std::int64_t>(gap.size())),
      decimals_(decimals),
      scale_(kExactPowersOfTen[static_cast<std::size_t>(decimals)]) {
  std::memcpy(&gap_word_, gap.data(), gap.size());
}

const char* FixedNumbers::read(const char* p, int count, double* values) const {
  constexpr std::uint64_t kPoints = 0x2e2e2e2e2e2e2e2eU;
  const Bytes behind_point = last_bytes(decimals_);
  Bytes odd_digits{};
  std::uint64_t odd = 0;  // no bit is set while all is as it should be
  for (int i = 0; i < count; ++i) {
    const std::uint64_t word = detail::load_eight(p);
    const std::uint64_t points = zero_bytes(word ^ kPoints);
    const std::int64_t point = std::int64_t{std::countr_zero(points | std::uint64_t{1} << 63)} >> 3;
    const char* const end = p + point + 1 + decimals_;
    const std::uint64_t negative = p[gap_length_] == '-' ? 1 : 0;
    const std::int64_t begin = gap_length_ + static_cast<std::int64_t>(negative);
    const std::int64_t whole_digits = point - begin;
    const bool surplus_zero = (p[begin] == '0') & (whole_digits > 1);
    odd |= ((word ^ gap_word_) & gap_mask_) | (points == 0 ? 1U : 0U) | (surplus_zero ? 1U : 0U) |
           (static_cast<std::uint64_t>(whole_digits - 1) & ~std::uint64_t{7});
    // The digits behind the point, and shifted over it those before.
    const Bytes fraction = load_bytes(end - 16);
    const Bytes whole = load_bytes(end - 17);
    const Bytes text = ((fraction ^ whole) & behind_point) ^ whole;
    const Bytes digits = (text - '0') & last_bytes(whole_digits + decimals_);
    odd_digits |= (digits + 0x76) | digits;
    values[i] = with_sign(number_of(digits), negative);
    p = end;
  }
  for (int i = 0; i < count; ++i) values[i] /= scale_;
  const Halves bits = reinterpret_cast<Halves>(odd_digits) & 0x8080808080808080U;
  return (odd | bits[0] | bits[1]) == 0 && is_blank(*p) ? p : nullptr;
}

}  // namespace marey
