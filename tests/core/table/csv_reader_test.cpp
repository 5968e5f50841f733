#include "core/table/csv_reader.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "core/bvh/reader.h"
#include "tests/core/bvh/bvh_texts.h"
#include "tests/core/kinematics/figures.h"

namespace marey {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::HasSubstr;
using Code = DiagnosticCode;

BvhClip figure() {
  BvhClip clip;
  clip.skeleton = figures::make_skeleton({{"Hips", kNoParent, {}, figures::channels("xyZ"), {}},
                                          {"Knee", 0, {0.0, -4.0, 0.0}, figures::channels("X"), {{0.0, -4.0, 0.0}}}});
  clip.motion = figures::make_motion({{1, 2, 3, 4}, {5, 6, 7, 8}}, 0.25);
  return clip;
}

BvhClip channels_of(std::string_view text, const TableOptions& options = {}) {
  const Result<BvhClip> clip = read_channel_table(text, figure(), options);
  EXPECT_TRUE(clip) << clip.error().message;
  return clip ? *clip : BvhClip();
}

Error channels_refused(std::string_view text, const TableOptions& options = {}) {
  const Result<BvhClip> clip = read_channel_table(text, figure(), options);
  EXPECT_FALSE(clip) << text;
  return clip ? Error() : clip.error();
}

Error points_refused(std::string_view text, const TableOptions& options = {}) {
  const Result<BvhClip> clip = read_points_table(text, options);
  EXPECT_FALSE(clip) << text;
  return clip ? Error() : clip.error();
}

constexpr std::string_view kPlain =
    "frame,time,Hips.Xposition,Hips.Yposition,Hips.Zrotation,Knee.Xrotation\n1,0,10,20,30,40\n2,0.5,11,21,31,41\n";

TEST(ChannelTable, TakesItsSamplesAndTheFiguresTree) {
  const BvhClip clip = channels_of(kPlain);
  EXPECT_EQ(clip.skeleton, figure().skeleton);
  EXPECT_THAT(clip.motion.samples(), ElementsAre(10, 11, 20, 21, 30, 31, 40, 41));
  EXPECT_EQ(clip.motion.frame_time_s(), 0.5);
  EXPECT_TRUE(clip.diagnostics.empty());
}

TEST(ChannelTable, ReadsTheSameWhateverTheSpelling) {
  const std::vector<std::string> spellings = {
      "time,Knee.Xrotation,Hips.Zrotation,Hips.Yposition,Hips.Xposition\r\n0,40,30,20,10\r\n0.5,41,31,21,11",
      "\xef\xbb\xbf# made by hand\n\nFrame;Time [s];Hips.Xposition [cm];Hips.Yposition[cm];Hips.Zrotation[deg];Knee.Xrotation[DEG]\n"
      "1;0;10,0;20;30;40\n;;;;;\n2;0,5;11;21;31;41\n\n",
      "sep=;\nframe;time;Hips.Xposition;Hips.Yposition;Hips.Zrotation;Knee.Xrotation\n1;0;10;20;30;40\n2;0.5;11;21;31;41\n",
      "frame\ttime\tHips.Xposition\tHips.Yposition\tHips.Zrotation\tKnee.Xrotation\r1\t0\t10\t20\t30\t40\r2\t0,5\t11\t21\t31\t41\r",
      "\"time\", \"Hips.Xposition\" ,Hips.Yposition,Hips.Zrotation,Knee.Xrotation,,\n0,\"10\", 20 ,30.0,+40,,\n.5,1.1e1,21,31,41\n"};
  for (const std::string& text : spellings) {
    const BvhClip clip = channels_of(text);
    EXPECT_THAT(clip.motion.samples(), ElementsAre(10, 11, 20, 21, 30, 31, 40, 41)) << text;
    EXPECT_EQ(clip.motion.frame_time_s(), 0.5) << text;
    EXPECT_TRUE(clip.diagnostics.empty()) << text << "\n" << listing(clip);
  }
}

TEST(ChannelTable, MissingColumnsKeepTheFirstFrameAndUnknownOnesAreLeftOut) {
  const BvhClip clip = channels_of("time,Knee.Xrotation,Ankle.Xrotation,Note\n0,7,8,9\n0.1,8,9,text\n");
  EXPECT_THAT(clip.motion.samples(), ElementsAre(1, 1, 2, 2, 3, 3, 7, 8));
  ASSERT_NE(clip.diagnostics.find(Code::TableColumnMissing), nullptr);
  EXPECT_THAT(clip.diagnostics.find(Code::TableColumnMissing)->message, HasSubstr("3 channels have no column, 'Hips.Xposition' first"));
  ASSERT_NE(clip.diagnostics.find(Code::TableColumnUnknown), nullptr);
  EXPECT_EQ(clip.diagnostics.find(Code::TableColumnUnknown)->count, 2);
  EXPECT_EQ(clip.diagnostics.find(Code::TableColumnUnknown)->place, (TextPlace{1, 21}));
}

TEST(ChannelTable, RepeatedNamesAreTakenInTheirOrder) {
  BvhClip twins;
  twins.skeleton = figures::make_skeleton({{"A", kNoParent, {}, figures::channels("X"), {}}, {"A", 0, {}, figures::channels("X"), {}}});
  twins.motion = Motion(2, 0, 0.1);
  const Result<BvhClip> clip = read_channel_table("time,A.Xrotation,A.Xrotation\n0,1,2\n0.1,3,4\n", twins);
  ASSERT_TRUE(clip);
  EXPECT_THAT(clip->motion.samples(), ElementsAre(1, 3, 2, 4));
}

TEST(ChannelTable, GapsTakeTheValueBefore) {
  const BvhClip clip = channels_of("time,Hips.Xposition,Hips.Yposition,Hips.Zrotation,Knee.Xrotation\n0,,9,9,9\n1,5,,nan,9\n2,,9,9,1e999\n");
  EXPECT_THAT(clip.motion.samples(), ElementsAre(1, 5, 5, 9, 9, 9, 9, 9, 9, 9, 9, 9));
  EXPECT_EQ(clip.diagnostics.find(Code::TableGap)->count, 3);
  EXPECT_EQ(clip.diagnostics.find(Code::TableGap)->place, (TextPlace{2, 3}));
  EXPECT_NE(clip.diagnostics.find(Code::NotFinite), nullptr);
  EXPECT_NE(clip.diagnostics.find(Code::NumberRange), nullptr);
}

TEST(ChannelTable, WhatCannotBeUsedIsRefusedWithItsPlace) {
  const auto row = [](std::string_view text) { return std::string(kPlain) + std::string(text); };
  EXPECT_EQ(channels_refused(row("3,1,1,2,x,4\n")).place, (TextPlace{4, 9}));
  EXPECT_EQ(channels_refused(row("3,1,1,2,x,4\n")).code, Code::BadNumber);
  EXPECT_EQ(channels_refused(row("3,1,1,2,3\n")).code, Code::RowLength);
  EXPECT_EQ(channels_refused(row("3,1,1,2,3,4,5\n")).place, (TextPlace{4, 1}));
  EXPECT_EQ(channels_refused(row("3,7,1,2,3,4\n")).code, Code::TableTimeUneven);
  EXPECT_EQ(channels_refused(row("3,0,1,2,3,4\n")).code, Code::TableTimeUneven);
  EXPECT_EQ(channels_refused("").code, Code::TableHeader);
  EXPECT_EQ(channels_refused("\n\n").code, Code::TableHeader);
  EXPECT_EQ(channels_refused("1,0,10,20,30,40\n").code, Code::TableHeader);
  EXPECT_EQ(channels_refused("a,b\n1,2\n").code, Code::TableColumnMissing);
  EXPECT_EQ(channels_refused("time,Knee.Xrotation[rad]\n0,1\n").code, Code::TableUnit);
  EXPECT_EQ(channels_refused("time [ms],Knee.Xrotation\n0,1\n").place, (TextPlace{1, 1}));
  EXPECT_EQ(channels_refused(std::string("t\0i\0m\0e\0", 8)).code, Code::UnsupportedEncoding);
  EXPECT_EQ(channels_refused("time;Knee.Xrotation\n0;1,5\n1;1.5\n").code, Code::BadNumber) << "two decimal signs";
  EXPECT_EQ(channels_refused("time;Knee.Xrotation\n0;1\n1;1.234,5\n").code, Code::BadNumber);
}

TEST(ChannelTable, ALastRowThatWasCutOffIsLeftOut) {
  const BvhClip clip = channels_of(std::string(kPlain) + "3,1,1,2");
  EXPECT_EQ(clip.motion.frame_count(), 2);
  EXPECT_NE(clip.diagnostics.find(Code::PartialFrame), nullptr);
}

TEST(ChannelTable, StrictReadingRefusesRepairs) {
  const TableOptions strict{.strict = true, .limits = {}};
  EXPECT_EQ(channels_refused("time,Knee.Xrotation\n0,1\n1,2\n", strict).code, Code::TableColumnMissing);
  EXPECT_EQ(channels_refused(std::string(kPlain) + "3,1,1,2", strict).code, Code::PartialFrame);
  EXPECT_EQ(channels_refused(std::string(kPlain) + "3,1,1,,2,4\n", strict).code, Code::TableGap);
  EXPECT_EQ(channels_refused(std::string(kPlain) + "3,1,1,nan,2,4\n", strict).code, Code::NotFinite);
  EXPECT_EQ(points_refused("A.x,Note\n1,2\n", strict).code, Code::TableColumnUnknown);
  EXPECT_TRUE(read_channel_table(kPlain, figure(), strict));
}

TEST(TableTimes, ComeBackBitForBitOrAsTheirMean) {
  const auto table = [](const std::vector<std::string>& times) {
    std::string text = "time,P.x\n";
    for (const std::string& time : times) text += time + ",0\n";
    return text;
  };
  const auto step_of = [&](const std::vector<std::string>& times) { return read_points_table(table(times))->motion.frame_time_s(); };
  EXPECT_EQ(step_of({"0", "0.008333299999999999", "0.016666599999999998"}), 0.008333299999999999);
  EXPECT_DOUBLE_EQ(step_of({"0.000", "0.033", "0.067", "0.100"}), 0.1 / 3.0);
  EXPECT_DOUBLE_EQ(step_of({"5", "5.25", "5.5"}), 0.25);
  EXPECT_EQ(step_of({"7"}), 1.0 / 30.0);
  EXPECT_EQ(points_refused(table({"0", "0.1", "0.3"})).code, Code::TableTimeUneven);
  EXPECT_THAT(points_refused(table({"0", "0.1", "0.3"})).message, HasSubstr("row 2"));
  EXPECT_EQ(points_refused(table({"0", "0", "0"})).code, Code::TableTimeUneven);
  EXPECT_EQ(points_refused(table({"0", "10", "20"})).code, Code::FrameTimeLooksLikeRate);
  EXPECT_NE(read_points_table(table({"0.000", "0.033", "0.067", "0.100"}))->diagnostics.find(Code::TableTimeRounded), nullptr);
  EXPECT_NE(read_points_table("P.x\n1\n2\n")->diagnostics.find(Code::TableTimeMissing), nullptr);
}

TEST(PointsTable, EachPointIsARoot) {
  const Result<BvhClip> clip = read_points_table("frame,time,A.x,A.y,A.z,B b.y,B b.X\n1,0,1,2,3,4,5\n2,1,6,7,8,9,10\n");
  ASSERT_TRUE(clip) << clip.error().message;
  ASSERT_EQ(clip->skeleton.joint_count(), 2);
  EXPECT_EQ(clip->skeleton.name(1), "B b");
  EXPECT_EQ(clip->skeleton.parent(1), kNoParent);
  EXPECT_EQ(clip->skeleton.channel_count(0), 3);
  EXPECT_EQ(clip->skeleton.channel(3).kind, ChannelKind::Yposition);
  EXPECT_EQ(clip->position_rule, PositionRule::Replace);
  const auto points = figures::positions_of(clip->skeleton, clip->motion, clip->position_rule);
  EXPECT_EQ(points[1][0], glm::dvec3(6.0, 7.0, 8.0));
  EXPECT_EQ(points[1][1], glm::dvec3(10.0, 9.0, 0.0));
}

TEST(PointsTable, RepeatedNamesArePointsOfTheirOwn) {
  const Result<BvhClip> clip = read_points_table("A.x,A.y,A.x,A.y\n1,2,3,4\n");
  ASSERT_TRUE(clip);
  EXPECT_EQ(clip->skeleton.joint_count(), 2);
  EXPECT_THAT(clip->motion.samples(), ElementsAre(1, 2, 3, 4));
}

TEST(PointsTable, ATableOfChannelsNeedsItsFigure) {
  EXPECT_EQ(points_refused(kPlain).code, Code::TableKind);
  EXPECT_THAT(points_refused(kPlain).message, HasSubstr("figure"));
  EXPECT_EQ(points_refused("a,b\n1,2\n").code, Code::TableKind);
}

TEST(PointsTable, KeepsToItsLimits) {
  TableOptions few;
  few.limits.max_frames = 1;
  EXPECT_EQ(points_refused("A.x\n1\n2\n", few).code, Code::LimitFrames);
  EXPECT_EQ(points_refused("A.x" + std::string(500'000, ';') + "B.x\n1;2\n").code, Code::LimitChannels);
  EXPECT_EQ(points_refused("A.x;B.x\n1;2" + std::string(500'000, ';') + "3\n").code, Code::RowLength);
  TableOptions small;
  small.limits.max_sample_bytes = 40;
  EXPECT_EQ(points_refused("A.x,A.y\n1,2\n3,4\n", small).code, Code::LimitMemory);
  TableOptions lonely;
  lonely.limits.max_joints = 1;
  EXPECT_EQ(points_refused("A.x,B.x\n1,2\n", lonely).code, Code::LimitJoints);
}

}  // namespace
}  // namespace marey
