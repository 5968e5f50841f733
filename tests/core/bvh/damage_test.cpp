// Damaged files: whatever the bytes are, the reader ends, stays within its limits, and what it gives can be written and
// read again. Run under AddressSanitizer this is the reader's proof against bad memory accesses.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/core/bvh/bvh_texts.h"
#include "tests/support/files.h"
#include "tests/support/random.h"

namespace marey {
namespace {

using namespace test;

std::vector<std::string> fixtures() {
  return {read_repository_file("tests/core/bvh/data/gymnast_as_printed.bvh"),
          read_repository_file("tests/core/bvh/data/spine_figures_1_and_2.bvh"),
          one_joint_file("4", "1 2 3\n4.5e-3 5 6 # x\n7 8-9\n1\n2 3\nnan 1,5 +7\nend\n"),
          file_with_lines("  JOINT b { OFFSET [0, 1, 0] CHANNELS 2 Xscale Grip\n  End Site4 { OFFSET 0 0 1.0 2.0 } }\n", 8)};
}

/// Reads what may be anything; checks what comes out.
void expect_no_harm(std::string_view text) {
  for (const bool strict : {false, true}) {
    const Result<BvhClip> clip = read_bvh(text, {.strict = strict, .limits = {}});
    if (!clip) {
      ASSERT_FALSE(clip.error().message.empty());
      continue;
    }
    ASSERT_EQ(clip->motion.channel_count(), clip->skeleton.channel_count());
    const auto samples = clip->motion.samples();
    ASSERT_TRUE(std::all_of(samples.begin(), samples.end(), [](double v) { return std::isfinite(v); })) << text;
    ASSERT_GT(clip->motion.frame_time_s(), 0.0);
    const Result<BvhClip> again = read_bvh(written(*clip));
    ASSERT_TRUE(again) << again.error().message << "\n" << text << "\n---\n" << written(*clip);
    ASSERT_TRUE(same_numbers(clip->skeleton, clip->motion, again->skeleton, again->motion))
        << text << "\n---\n" << written(*clip);
  }
}

TEST(DamagedFiles, CutAtEveryByte) {
  for (const std::string& text : fixtures()) {
    for (std::size_t size = 0; size < text.size(); ++size) {
      expect_no_harm(std::string_view(text).substr(0, size));
      if (HasFailure()) return;
    }
  }
}

TEST(DamagedFiles, OneByteExchanged) {
  constexpr std::string_view kBytes = "{}\n\r 0-.,#xE[\0\xff";
  Random random(41);
  for (const std::string& text : fixtures()) {
    for (std::size_t at = 0; at < text.size(); ++at) {
      std::string damaged = text;
      damaged[at] = kBytes[static_cast<std::size_t>(random.below(static_cast<int>(kBytes.size())))];
      expect_no_harm(damaged);
      if (HasFailure()) return;
    }
  }
}

TEST(DamagedFiles, PiecesLostDoubledAndMoved) {
  Random random(42);
  for (int i = 0; i < 4'000; ++i) {
    const std::vector<std::string> texts = fixtures();
    std::string text = texts[static_cast<std::size_t>(random.below(static_cast<int>(texts.size())))];
    for (int edit = 1 + random.below(4); edit > 0; --edit) {
      const auto from = static_cast<std::size_t>(random.below(static_cast<int>(text.size()) + 1));
      const std::string piece = text.substr(from, static_cast<std::size_t>(random.below(60)));
      if (random.one_in(2)) text.erase(from, piece.size());
      if (random.one_in(2)) text.insert(static_cast<std::size_t>(random.below(static_cast<int>(text.size()) + 1)), piece);
    }
    expect_no_harm(text);
    if (HasFailure()) return;
  }
}

TEST(DamagedFiles, RandomWords) {
  const std::vector<std::string> words = {"HIERARCHY", "ROOT",   "JOINT a", "End Site", "{",   "}",   "OFFSET", "CHANNELS",
                                          "3",         "0 0 0",  "MOTION",  "Frames:",  "2",   "\n",  "Frame Time:", "0.1",
                                          "Zrotation", "1.5e-7", "-",       "#",        "nan", "1,5", "Xposition",   "\r\n"};
  Random random(43);
  for (int i = 0; i < 20'000; ++i) {
    std::string text = random.one_in(2) ? "HIERARCHY ROOT a { OFFSET 0 0 0 CHANNELS 2 Zrotation Xrotation } " : "";
    for (int word = random.below(40); word > 0; --word) {
      text += words[static_cast<std::size_t>(random.below(static_cast<int>(words.size())))];
      if (!random.one_in(6)) text += ' ';
    }
    expect_no_harm(text);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace marey
