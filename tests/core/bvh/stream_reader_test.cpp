// Reading by pieces gives what reading the whole text gives: clip, findings, excerpts and the text when saved.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <string>

#include "core/bvh/stream_reader.h"
#include "tests/core/bvh/bvh_texts.h"
#include "tests/support/files.h"
#include "tests/support/random.h"
#include "tests/support/random_clip.h"
#include "tests/support/streamed.h"

namespace marey {
namespace {

using namespace test;

std::string number_row(Random& random) {
  std::string row;
  for (int i = 0; i < 3; ++i) {
    row += random.one_in(4) ? std::to_string(random.below(100)) : std::to_string(random.between(-180, 180));
    row += i < 2 ? " " : "";
  }
  return row;
}

std::string regular_rows(Random& random, int count) {
  std::string rows;
  for (int i = 0; i < count; ++i) rows += number_row(random) + "\n";
  return rows;
}

/// Lines that are no row like the others.
constexpr std::string_view kIrregular[] = {
    "1 2\n",         "1 2 3 4\n",          "1 2 3 4 5 6\n",    "# a comment\n",     "// wait, what\n",  "\n\n\n",
    "1 nan 3\n",     "a line of text\n",   "1\n2\n3\n",        "1 2\n3\n",          "  7\t8  9 \n",     "1 2-3\n",
    "1e400 2 3\n",   "1 2 3 # behind\n",   "\xe4\xbd\xa0\xe5\xa5\xbd\n", "1\xc2\xa0" "2 3\n", "1,5 2,5 3\n", "1, 2, 3\n",
    "MOTION\n",      "Frames: 3\n",        "/* a block */ 1 2 3\n", "1 2 3\r\n4 5 6\r", "+1 .5 5.\n", "x 2 3\n",
    "HIERARCHY\n",   "1 2 3;\n",           "word 1 2 3\n",     "0x10 2 3\n",        "/*\n1 2 3\n*/\n",  std::string_view("1 2 3\0\n", 7)};

std::string irregular_file(Random& random) {
  std::string rows = regular_rows(random, 33 + random.below(40));
  const int oddities = random.below(5);
  for (int i = 0; i < oddities; ++i) {
    rows += kIrregular[random.below(static_cast<int>(std::size(kIrregular)))];
    rows += regular_rows(random, random.one_in(3) ? 60 : random.below(20));
  }
  if (random.one_in(6)) rows.append(static_cast<std::size_t>(random.below(9)), '\0');
  if (random.one_in(6)) rows.resize(rows.size() - 1 - static_cast<std::size_t>(random.below(8)));
  const auto lines = static_cast<int>(std::count(rows.begin(), rows.end(), '\n'));
  const std::string declared = random.one_in(3) ? std::to_string(random.below(2 * lines)) : std::to_string(lines);
  std::string text = one_joint_file(declared, rows);
  if (random.one_in(5)) text = replaced(text, "\n", "\r\n");
  if (random.one_in(9)) text = replaced(text, "\n", "\r");
  if (random.one_in(9)) text = replaced(text, "Frames: " + declared + "\n", "");
  return text;
}

TEST(StreamReader, GivesWhatTheWholeTextGives) {
  Random random(401);
  int streamed = 0;
  for (int i = 0; i < 1500; ++i) {
    const std::string text = irregular_file(random);
    StreamOptions options;
    options.step_bytes = static_cast<std::size_t>(1 + random.below(300));
    options.expected_bytes = random.one_in(2) ? static_cast<std::int64_t>(text.size()) : 0;
    const int largest = 1 + random.below(200);
    bool was_streamed = false;
    const NextPiece next_piece = [&] { return static_cast<std::size_t>(1 + random.below(largest)); };
    ASSERT_EQ(difference_when_streamed(text, options, next_piece, &was_streamed), "") << text;
    streamed += was_streamed ? 1 : 0;
  }
  EXPECT_GT(streamed, 900);
}

TEST(StreamReader, GivesWhatTheWholeTextGivesForAnyFigure) {
  Random random(402);
  for (int i = 0; i < 200; ++i) {
    const Skeleton skeleton = random_skeleton(random, 12);
    const std::string text = write_bvh(skeleton, random_motion(random, skeleton.channel_count(), random.below(120)), {});
    StreamOptions options;
    options.step_bytes = static_cast<std::size_t>(1 + random.below(3000));
    options.expected_bytes = static_cast<std::int64_t>(text.size());
    const NextPiece next_piece = [&] { return static_cast<std::size_t>(1 + random.below(5000)); };
    ASSERT_EQ(difference_when_streamed(text, options, next_piece), "") << text;
  }
}

TEST(StreamReader, GivesWhatTheWholeTextGivesForRecordedFiles) {
  const std::vector<std::string> paths = recorded_bvh_files();
  if (paths.empty()) GTEST_SKIP() << "no recorded files at " << shared_dir();
  int streamed = 0;
  for (const std::string& path : paths) {
    const std::optional<std::string> text = read_shared_file(path);
    ASSERT_TRUE(text) << path;
    bool was_streamed = false;
    const StreamOptions options{static_cast<std::int64_t>(text->size()), 1 << 14};
    EXPECT_EQ(difference_when_streamed(*text, options, [] { return std::size_t{10'007}; }, &was_streamed), "") << path;
    streamed += was_streamed ? 1 : 0;
  }
  std::cout << paths.size() << " recorded files read by pieces, " << streamed << " of them before their end\n";
}

TEST(StreamReader, ReadsFramesWhileTheyCome) {
  Random random(403);
  const std::string text = one_joint_file("2000", regular_rows(random, 2000));
  StreamReader reader({}, {static_cast<std::int64_t>(text.size()), 256});
  EXPECT_FALSE(reader.clip_so_far(1000));
  int before = 0;
  for (std::size_t at = 0; at < text.size(); at += 1000) {
    ASSERT_TRUE(reader.feed(std::string_view(text).substr(at, 1000)));
    EXPECT_GE(reader.frame_count(), before);
    before = reader.frame_count();
  }
  EXPECT_GT(before, 1900);
  const std::optional<BvhClip> so_far = reader.clip_so_far(300);
  ASSERT_TRUE(so_far);
  EXPECT_EQ(so_far->motion.frame_count(), 100);
  EXPECT_EQ(so_far->skeleton.name(0), "Hips");
  const Result<BvhClip> clip = reader.finish();
  ASSERT_TRUE(clip);
  for (FrameIndex frame = 0; frame < 100; ++frame) EXPECT_EQ(so_far->motion.sample(1, frame), clip->motion.sample(1, frame));
}

TEST(StreamReader, DoesNotHoldTheText) {
  Random random(404);
  const std::string text = one_joint_file("20000", regular_rows(random, 20'000));
  StreamReader reader({}, {static_cast<std::int64_t>(text.size()), 4096});
  std::int64_t most = 0;
  for (std::size_t at = 0; at < text.size(); at += 1000) {
    ASSERT_TRUE(reader.feed(std::string_view(text).substr(at, 1000)));
    most = std::max(most, reader.held_bytes());
  }
  const std::int64_t samples = 20'000 * 3 * 8;
  EXPECT_LT(most, samples + samples / 20 + 64 * 1024);
}

TEST(StreamReader, RefusesWithinTheLimitsOfMemory) {
  Random random(405);
  const std::string text = one_joint_file("20000", regular_rows(random, 20'000));
  ReadOptions options;
  options.limits.max_sample_bytes = 10'000 * 3 * 8;
  StreamReader reader(options, {static_cast<std::int64_t>(text.size()), 4096});
  std::size_t fed = 0;
  while (fed < text.size() && reader.feed(std::string_view(text).substr(fed, 1000))) fed += 1000;
  EXPECT_LT(fed, 20'000U);  // told by the size of the file, before the samples have come
  const Result<BvhClip> clip = reader.finish();
  ASSERT_FALSE(clip);
  EXPECT_EQ(clip.error().code, DiagnosticCode::LimitMemory);
}

TEST(StreamReader, TakesALongerFileThanItExpected) {
  Random random(406);
  const std::string text = one_joint_file("5000", regular_rows(random, 5000));
  for (const std::int64_t expected : {std::int64_t{0}, std::int64_t{1}, std::int64_t{20'000}, std::int64_t{1'000'000}}) {
    EXPECT_EQ(difference_when_streamed(text, {expected, 512}, [] { return std::size_t{700}; }), "") << expected;
  }
}

}  // namespace
}  // namespace marey
