#pragma once

#include <cstdint>
#include <string>

#include "tests/support/random.h"

namespace marey::test {

/// How many texts and values a run compares: the environment's MAREY_NUMBER_CASES, else `usual`.
[[nodiscard]] std::int64_t number_cases(std::int64_t usual);

/// A number as motion files have it: -180 to 180 or a few hundred, mostly six decimals.
[[nodiscard]] std::string file_like_text(Random& random);
/// The shortest text of random bits.
[[nodiscard]] std::string shortest_text(Random& random);
/// 15 to 25 digits, a point anywhere, zeros at its end, an exponent now and then.
[[nodiscard]] std::string long_text(Random& random);
/// Random digits with an exponent from far below the smallest to far above the largest double.
[[nodiscard]] std::string text_with_exponent(Random& random);
/// Digits of a double close to the smallest or the largest ones.
[[nodiscard]] std::string text_at_the_ends(Random& random);

/// The point halfway between two neighbouring doubles in all its digits, and the same with its last digit one lower and
/// one higher: rounding decides on the last of up to 770 digits.
struct HalfwayTexts {
  std::string below;
  std::string halfway;
  std::string above;
};
[[nodiscard]] HalfwayTexts halfway_texts(Random& random);

}  // namespace marey::test
