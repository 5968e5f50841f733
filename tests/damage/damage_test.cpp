// Each of the repository's own texts, cut at each byte and with each byte exchanged: the reader ends, stays within its
// memory, and what it gives can be written and read again. tests/node compares the verdicts native and as WebAssembly.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "tests/damage/fixtures.h"
#include "tests/damage/verdict.h"
#include "tests/support/random.h"

namespace marey::test {
namespace {

/// What takes the place of a byte, in turn: one of those that mean something, another bit, the top bit, anything.
char exchanged(char byte, int turn, Random& random) {
  constexpr std::string_view kTelling = "{}\n\r 0-.,#xE[\0\xff";
  switch (turn % 4) {
    case 0: return kTelling[static_cast<std::size_t>(random.below(static_cast<int>(kTelling.size())))];
    case 1: return static_cast<char>(byte ^ (1 << random.below(7)));
    case 2: return static_cast<char>(byte ^ 0x80);
    default: return static_cast<char>(random.below(256));
  }
}

// AddressSanitizer makes reading some ten times slower: every third byte has to do there.
#if defined(__SANITIZE_ADDRESS__)
constexpr std::size_t kThinning = 3;
#else
constexpr std::size_t kThinning = 1;
#endif

/// Cuts at every `stride`-th byte and exchanges it; of a text over 2 KiB, exchanges only every third of them.
void damage(const Fixture& fixture, std::size_t stride) {
  constexpr std::size_t kLong = 2048;
  Verdict verdict;
  Random random(fixture.text.size());
  std::string text = fixture.text;
  for (std::size_t at = 0; at < text.size(); at += stride) {
    ASSERT_EQ(verdict.take(std::string_view(text).substr(0, at)).value_or(""), "") << fixture.name << " cut at byte " << at;
    const char byte = text[at];
    const bool is_left_out = text.size() > kLong && at / stride % 3 != 0;
    const int turns = is_left_out ? 0 : 2;
    for (int turn = 0; turn < turns; ++turn) {
      text[at] = exchanged(byte, static_cast<int>(at / stride) + turn, random);
      ASSERT_EQ(verdict.take(text).value_or(""), "") << fixture.name << ", byte " << at << " is " << static_cast<int>(text[at]);
    }
    text[at] = byte;
  }
  EXPECT_GT(verdict.refused(), 0);
  EXPECT_LT(verdict.refused(), verdict.texts());
  testing::Test::RecordProperty("verdict", fmt::format("{:016x} of {} texts", verdict.hash(), verdict.texts()));
  std::cout << verdict.texts() << " texts made of " << fixture.name << ", " << verdict.refused() << " refused\n";
}

class Damaged : public testing::TestWithParam<Fixture> {};
class DamagedSample : public testing::TestWithParam<Fixture> {};

const auto kName = [](const auto& fixture) { return fixture.param.name; };

TEST_P(Damaged, AtEachByte) { damage(GetParam(), kThinning); }
INSTANTIATE_TEST_SUITE_P(Fixtures, Damaged, testing::ValuesIn(short_fixtures()), kName);

/// So long a text is damaged at some 60 places only.
TEST_P(DamagedSample, HereAndThere) { damage(GetParam(), GetParam().text.size() / 60); }
INSTANTIATE_TEST_SUITE_P(Fixtures, DamagedSample, testing::ValuesIn(whole_samples()), kName);

}  // namespace
}  // namespace marey::test
