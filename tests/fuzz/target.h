#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace marey::test {

/// What is wrong with how the core dealt with some bytes, for people; nothing if all is as it should be.
using Harm = std::optional<std::string>;

/// Something that the core does with bytes that may be anything, and what has to hold then.
struct FuzzTarget {
  std::string_view name;  ///< its corpus is tests/fuzz/corpus/NAME
  Harm (*find_harm)(std::string_view input);
};

/// Byte 1: reading, see reading.h. Then a text: it is read or refused, and what comes out is sound.
[[nodiscard]] Harm find_harm_in_reading(std::string_view input);
/// Bytes 1 to 3: how to save. Then a text: read, written in each way and read again it says the same.
[[nodiscard]] Harm find_harm_in_round_trip(std::string_view input);
/// A script of edits up to "HIERARCHY", and the clip that they are made to; without a clip, one of our own.
[[nodiscard]] Harm find_harm_in_edits(std::string_view input);
/// Byte 1: the figure, and whether to be strict. Then a table.
[[nodiscard]] Harm find_harm_in_table(std::string_view input);
/// Bytes 1 and 2: steps and pieces. Then a text: read by pieces it is what it is as a whole.
[[nodiscard]] Harm find_harm_in_streaming(std::string_view input);

inline constexpr std::array kFuzzTargets = {FuzzTarget{"read", find_harm_in_reading},
                                            FuzzTarget{"round_trip", find_harm_in_round_trip},
                                            FuzzTarget{"edits", find_harm_in_edits},
                                            FuzzTarget{"table", find_harm_in_table},
                                            FuzzTarget{"stream", find_harm_in_streaming}};

}  // namespace marey::test
