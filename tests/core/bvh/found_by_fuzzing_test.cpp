// Defects that tests/fuzz found, each as small as it gets.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "core/bvh/save_options.h"
#include "core/table/csv_reader.h"
#include "core/text/utf8.h"
#include "tests/core/bvh/bvh_texts.h"

namespace marey {
namespace {

using namespace test;
using Code = DiagnosticCode;

TEST(FoundByFuzzing, ACommentAmidARowDoesNotEndIt) {
  for (const std::string rows : {"1 2 3\n4 /* e */ 5 6\n7 8 9\n", "1 2 3\n4 5 6\n7 /* 0 */ 8 /*e*/ 9\n", "/* a */ 1 2 3\n4 5 6\n7 8 9\n"}) {
    const std::string text = one_joint_file("3", rows);
    const BvhClip clip = read_or_fail(text);
    EXPECT_EQ(rows_of(clip), three_rows()) << rows;
    EXPECT_EQ(written(clip), text);
    expect_no_warnings(clip);
  }
}

TEST(FoundByFuzzing, WordsBehindTheLastRowAreNotReadAsItsValuesWhenSavedTwice) {
  const BvhClip clip = read_or_fail(with_motion("MOTION\nFrames:\nFrame Time: 0.1 1.0\n x 3 notes\n"));
  EXPECT_EQ(rows_of(clip), (Rows{{1, 0, 3}}));
  const std::string once = written(clip);
  EXPECT_EQ(written(read_or_fail(once)), once);
}

TEST(FoundByFuzzing, TextBetweenRowsIsAsLongWithCrLfAsWithLf) {
  const std::string text = one_joint_file("3", "1 2 3\nthese\nare\nnotes\nof\nmine\n4 5 6\n7 8 9\n");
  EXPECT_EQ(rows_of(read_or_fail(text)), three_rows());
  EXPECT_EQ(rows_of(read_or_fail(replaced(text, "\n", "\r\n"))), three_rows());
}

TEST(FoundByFuzzing, ADeepTreeIsNotIndentedByTheSquareOfItsDepth) {
  constexpr int kDepth = 1'900;
  std::string text = "HIERARCHY\nROOT a\n{\n" + std::string(100, ' ') + "OFFSET 0 0 0\nCHANNELS 0\n";
  for (int i = 1; i < kDepth; ++i) text += "JOINT b{";
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(clip.skeleton.joint_count(), kDepth);
  EXPECT_LT(written(clip).size(), 200 * text.size());
  EXPECT_LT(write_bvh(clip.skeleton, clip.motion, {}).size(), 200 * text.size());
}

TEST(FoundByFuzzing, AChannelCalledLikeAKeywordOrACommentIsPrintedAsAName) {
  for (const std::string name : {"\"End\"", "\"JOINT\"", "\"#1\"", "\"/*x\""}) {
    SCOPED_TRACE(name);
    const std::string text = file_with_lines("  JOINT b { OFFSET 0 1 0 CHANNELS 2 " + name + " Grip\n }\n {\n }\n", 8);
    const BvhClip clip = read_or_fail(text);
    ASSERT_EQ(clip.skeleton.channel_count(), 8);
    const BvhClip plain = read_or_fail(write_bvh(clip.skeleton, clip.motion, {}));
    EXPECT_TRUE(same_numbers(clip.skeleton, clip.motion, plain.skeleton, plain.motion));
    const BvhClip again = read_or_fail(written(clip));
    EXPECT_TRUE(same_numbers(clip.skeleton, clip.motion, again.skeleton, again.motion)) << written(clip);
  }
}

TEST(FoundByFuzzing, EditedRowsAreSavedWithoutCommasWhereTheseWouldBeTakenForBlanks) {
  std::string rows;
  for (int i = 0; i < 20; ++i) rows += i % 3 == 0 ? "0\t0\t0\n" : "1,5;2,5;3,5\n";
  BvhClip clip = read_or_fail(one_joint_file("20", rows));
  ASSERT_EQ(clip.motion.sample(0, 1), 1.5);
  for (FrameIndex frame = 0; frame < 20; frame += 3) clip.motion.channel_samples(0)[static_cast<std::size_t>(frame)] = 0.25;
  const BvhClip again = read_or_fail(written(clip));
  EXPECT_TRUE(same_numbers(clip.skeleton, clip.motion, again.skeleton, again.motion)) << written(clip);
}

TEST(FoundByFuzzing, RefusalsOfTablesAreUtf8) {
  const Result<BvhClip> clip = read_points_table("time,a.x\n\xff\xfe,1\n");
  ASSERT_FALSE(clip);
  EXPECT_EQ(clip.error().code, Code::BadNumber);
  EXPECT_TRUE(is_utf8(clip.error().message)) << clip.error().message;
  EXPECT_TRUE(is_utf8(clip.error().found));
}

TEST(FoundByFuzzing, AsManyBlanksBetweenNumbersAsAWordHasBytes) {
  const std::string blanks(8, ' ');
  std::string rows;
  for (int i = 0; i < 3; ++i) rows += "1.5" + blanks + "-2.5" + blanks + "3.5\n";
  const BvhClip clip = read_or_fail(one_joint_file("3", rows));
  EXPECT_EQ(rows_of(clip), Rows(3, {1.5, -2.5, 3.5}));
}

TEST(FoundByFuzzing, TextBehindAHeaderWithoutChannelsStaysWhatItIs) {
  const BvhClip clip = read_or_fail("HIERARCHY\nROOT a\n{\n OFFSET 0 0 0\n CHANNELS 0\n}\nMOTION\nFrames: 0\nFrame Time: 0.1\nsome words 1 2\n0.0 1.0\nmore\n");
  EXPECT_THAT(written(clip), testing::EndsWith("Frame Time: 0.1\nsome words 1 2\n0.0 1.0\nmore\n"));
}

// The count that is written, 6, would fit only if the semicolon were part of a word.
TEST(FoundByFuzzing, SemicolonsFoundWithoutACountAreNotWrittenWithOne) {
  const BvhClip clip = read_or_fail(
      "HIERARCHY\nROOT a\n{\n OFFSET 0 0 0\n CHANNELS 1 Zrotation\n}\nMOTION\nFram.s: 4\nFrame.0166\n95\n89.9;528593\n.741013\n89.4\n");
  ASSERT_EQ(rows_of(clip).size(), 6u);
  EXPECT_EQ(rows_of(read_or_fail(written(clip))), rows_of(clip)) << written(clip);
}

// Rows were made in memory for numbers of 96 bytes.
TEST(FoundByFuzzing, DecimalsOfNumbersWithAHundredDigitsFitTheirRows) {
  std::string text = "HIERARCHY\nROOT a\n{\n OFFSET 0 0 0\n CHANNELS 1 Zrotation\n}\nMOTION\nFrames: 4\nFrame Time: 0.1\n";
  for (int i = 0; i < 4; ++i) text += "7.7e+120\n";
  const BvhClip clip = read_or_fail(text);
  SaveOptions options;
  options.decimals = 3;
  const std::string saved = write_bvh(clip.skeleton, clip.motion, clip.style, options);
  EXPECT_EQ(rows_of(read_or_fail(saved)), rows_of(clip)) << saved;
}

}  // namespace
}  // namespace marey
