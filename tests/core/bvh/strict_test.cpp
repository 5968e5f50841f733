// The strict reading: every repair becomes a refusal with the same place and reason.
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "tests/core/bvh/bvh_texts.h"

namespace marey {
namespace {

using namespace test;
using Code = DiagnosticCode;

constexpr ReadOptions kStrict{.strict = true, .limits = {}};

std::string joint_file(std::string_view lines) { return file_with_lines(lines, 6); }

struct Offence {
  Code code;
  std::string text;
};

std::vector<Offence> hierarchy_offences() {
  const std::string tip = "  End Site\n  {\n    OFFSET 0 1 0\n  }\n";
  const std::string leaf = "  JOINT b\n  {\n    OFFSET 0 1 0\n    CHANNELS 0\n" + tip + "  }\n";
  return {
      {Code::UnexpectedToken, joint_file("  q\n" + tip)},
      {Code::UnexpectedEnd, "HIERARCHY\nROOT a\n{\n  OFFSET 0 0 0\n  CHANNELS 0\n" + tip},
      {Code::ByteOrderMark, "\xef\xbb\xbf" + joint_file(tip)},
      {Code::WideBlank, joint_file("  End\u00a0Site\n  {\n    OFFSET 0 1 0\n  }\n")},
      {Code::TextAfterHierarchyEnd, joint_file(tip + "}\nq\nROOT c\n{\n  OFFSET 0 0 0\n  CHANNELS 0\n" + tip)},
      {Code::MissingHierarchyKeyword, joint_file(tip).substr(10)},
      {Code::JointOutsideRoot, joint_file(tip + "}\nJOINT c\n{\n  OFFSET 0 0 0\n  CHANNELS 0\n" + tip)},
      {Code::MissingOpeningBrace, joint_file("  JOINT b\n    OFFSET 0 1 0\n    CHANNELS 0\n" + tip + "  }\n")},
      {Code::MissingClosingBrace, joint_file("  JOINT b\n  {\n    OFFSET 0 1 0\n    CHANNELS 0\n" + tip)},
      {Code::SurplusClosingBrace, joint_file(tip + "}\n")},
      {Code::JoinedTree, joint_file("  JOINT b\n  {\n    OFFSET 0 1 0\n    CHANNELS 0\n  }\n" + tip + "  }\n")},
      {Code::JointWithoutBlock, joint_file("  JOINT b\n")},
      {Code::MissingName, joint_file("  JOINT\n  {\n    OFFSET 0 1 0\n    CHANNELS 0\n" + tip + "  }\n")},
      {Code::KeywordCase, joint_file("  end site\n  {\n    OFFSET 0 1 0\n  }\n")},
      {Code::ChannelCase, file_with_lines("  JOINT b\n  {\n    OFFSET 0 1 0\n    CHANNELS 1 ZRotation\n" + tip + "  }\n", 7)},
      {Code::UnknownChannel, file_with_lines("  JOINT b\n  {\n    OFFSET 0 1 0\n    CHANNELS 1 Grip\n" + tip + "  }\n", 7)},
      {Code::ChannelCountMismatch, joint_file("  JOINT b\n  {\n    OFFSET 0 1 0\n    CHANNELS 2\n" + tip + "  }\n")},
      {Code::RepeatedChannelsLine, joint_file("  CHANNELS 0\n" + leaf)},
      {Code::RepeatedOffset, joint_file("  OFFSET 0 0 0\n" + leaf)},
      {Code::MissingOffset, joint_file("  JOINT b\n  {\n    CHANNELS 0\n" + tip + "  }\n")},
      {Code::MissingChannels, joint_file("  JOINT b\n  {\n    OFFSET 0 1 0\n" + tip + "  }\n")},
      {Code::OffsetValueCount, joint_file("  End Site\n  {\n    OFFSET 0 0 0.0 1.0\n  }\n")},
      {Code::OffsetBracketed, joint_file("  End Site\n  {\n    OFFSET [0 1 0]\n  }\n")},
      {Code::LeafWithoutEndSite, joint_file("  JOINT b\n  {\n    OFFSET 0 1 0\n    CHANNELS 0\n  }\n")},
      {Code::EndSiteBesideChildren, joint_file(leaf + tip)},
      {Code::EndSiteWithChannels,
       file_with_lines("  End Site\n  {\n    OFFSET 0 1 0\n    CHANNELS 1 Zrotation\n  }\n", 7)},
      {Code::SeveralEndSites, joint_file(tip + tip)},
      {Code::NamedEndSite, joint_file("  End Site tip\n  {\n    OFFSET 0 1 0\n  }\n")},
      {Code::BadNumber, joint_file("  End Site\n  {\n    OFFSET 0 x 0\n  }\n")},
      {Code::NotFinite, joint_file("  End Site\n  {\n    OFFSET 0 nan 0\n  }\n")},
      {Code::NumbersRunTogether, joint_file("  End Site\n  {\n    OFFSET 0.5-1 0\n  }\n")},
      {Code::DecimalComma, joint_file("  End Site\n  {\n    OFFSET 0,5 1,0 0,0\n  }\n")},
      {Code::Comment, "# made by hand\n" + joint_file(tip)},
  };
}

std::vector<Offence> motion_offences() {
  const std::string hierarchy(kOneJoint);
  return {
      {Code::MissingMotion, hierarchy},
      {Code::MissingFrameCount, hierarchy + "MOTION\nFrame Time: 0.1\n1 2 3\n"},
      {Code::MissingFrameTime, hierarchy + "MOTION\nFrames: 1\n1 2 3\n"},
      {Code::RepeatedFrameCount, hierarchy + "MOTION\nFrames: 1\nFrames: 1\nFrame Time: 0.1\n1 2 3\n"},
      {Code::RepeatedFrameTime, hierarchy + "MOTION\nFrames: 1\nFrame Time: 0.1\nFrame Time: 0.2\n1 2 3\n"},
      {Code::FrameTimeNotPositive, hierarchy + "MOTION\nFrames: 1\nFrame Time: 0\n1 2 3\n"},
      {Code::FrameCountMismatch, one_joint_file("3", "1 2 3\n")},
      {Code::PartialFrame, one_joint_file("1", "1 2 3\n4 5")},
      {Code::RowLength, one_joint_file("3", "1 2 3\n4 5\n7 8 9\n")},
      {Code::SurplusValues, one_joint_file("2", "1 2 3 4\n1 2 3 4\n")},
      {Code::BadNumber, one_joint_file("1", "1 x 3\n")},
      {Code::NumbersRunTogether, one_joint_file("1", "1 2-3\n")},
      {Code::DecimalComma, one_joint_file("1", "1,5 2,5 3,5\n")},
      {Code::CommaBetweenNumbers, one_joint_file("1", "1.5, 2.5, 3.5\n")},
      {Code::NotFinite, one_joint_file("1", "1 nan 3\n")},
      {Code::NumberRange, one_joint_file("1", "1 1e999 3\n")},
      {Code::Comment, one_joint_file("1", "# first\n1 2 3\n")},
      {Code::TextAfterMotion, one_joint_file("1", "1 2 3\nend\n")},
      {Code::TrailingNul, one_joint_file("1", "1 2 3\n") + std::string(3, '\0')},
  };
}

void expect_refused_as_reported(const Offence& offence) {
  const BvhClip clip = read_or_fail(offence.text);
  const Diagnostic* finding = clip.diagnostics.find(offence.code);
  ASSERT_NE(finding, nullptr) << diagnostic_id(offence.code) << " is missing in\n" << listing(clip) << offence.text;
  const Error error = refusal_of(offence.text, kStrict);
  EXPECT_EQ(error.code, offence.code) << error.message << "\n" << offence.text;
  EXPECT_EQ(error.place, finding->place);
  EXPECT_EQ(error.message, finding->message);
  EXPECT_EQ(error.expected, finding->expected);
  EXPECT_EQ(error.found, finding->found);
}

TEST(StrictReading, RefusesRepairsOfTheHierarchyWithTheirPlaceAndReason) {
  for (const Offence& offence : hierarchy_offences()) expect_refused_as_reported(offence);
}

TEST(StrictReading, RefusesRepairsOfTheMotionWithTheirPlaceAndReason) {
  for (const Offence& offence : motion_offences()) expect_refused_as_reported(offence);
}

TEST(StrictReading, AcceptsWhatTheFormatAllows) {
  const std::string tip = "  End Site\n  {\n    OFFSET 0 1 0\n  }\n";
  const std::vector<std::string> texts = {
      one_joint_file("2", "1 2 3\n4 5 6\n"), one_joint_file("0", ""), one_joint_file("2", "\t1 2 3 \r\n\r\n4 5 6"),
      file_with_lines(tip + "}\nROOT b\n{\n  OFFSET 1 2 3\n  CHANNELS 0\n" + tip, 6),
      file_with_lines("  JOINT Hips\n  {\n    OFFSET 0 0 0\n    CHANNELS 2 Zrotation Zrotation\n" + tip + "  }\n", 8)};
  for (const std::string& text : texts) {
    const Result<BvhClip> clip = read_bvh(text, kStrict);
    EXPECT_TRUE(clip) << (clip ? "" : clip.error().message) << "\n" << text;
  }
}

TEST(StrictReading, HasATestForEveryRepair) {
  // Refusals of any reading, Utf16Text, which has its own test, and what is found in tables.
  const std::set<Code> elsewhere = {Code::NotBvh, Code::EmptyFile, Code::UnsupportedEncoding, Code::Utf16Text,
                                    Code::MissingRoot, Code::LimitJoints, Code::LimitDepth, Code::LimitFrames,
                                    Code::LimitMemory, Code::LimitChannels, Code::OutOfMemory, Code::InvalidSkeleton,
                                    Code::InvalidArgument, Code::Cancelled,
                                    Code::TableHeader, Code::TableKind, Code::TableUnit, Code::TableColumnMissing,
                                    Code::TableColumnUnknown, Code::TableGap, Code::TableTimeUneven};
  std::set<Code> tested = elsewhere;
  for (const Offence& offence : hierarchy_offences()) tested.insert(offence.code);
  for (const Offence& offence : motion_offences()) tested.insert(offence.code);
  for (int i = 0; i < kDiagnosticCodeCount; ++i) {
    const auto code = static_cast<Code>(i);
    EXPECT_TRUE(!traits_of(code).refused_when_strict || tested.contains(code)) << diagnostic_id(code);
  }
}

}  // namespace
}  // namespace marey
