#include "core/table/csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "core/skeleton/skeleton_builder.h"

namespace marey {
namespace {

Skeleton arm_with_names(const std::string& root, const std::string& child) {
  SkeletonBuilder builder;
  builder.open_joint(root);
  builder.add_channel(ChannelKind::Xposition);
  builder.add_channel(ChannelKind::Zrotation);
  builder.open_joint(child, {0.0, 10.0, 0.0});
  builder.add_channel(ChannelKind::Other, "Wobble");
  builder.add_end_site({0.0, 0.0, 2.0});
  builder.close_joint();
  builder.close_joint();
  return builder.build().value();
}

std::string channel_header(const Skeleton& skeleton) {
  std::string out;
  append_channel_header(skeleton, out);
  return out;
}

TEST(Csv, NamesChannelsByJointAndKeyword) {
  EXPECT_EQ(channel_header(arm_with_names("Hips", "Arm")), "frame,time,Hips.Xposition,Hips.Zrotation,Arm.Wobble\n");
}

TEST(Csv, NamesPositionsByNodeAndAxis) {
  std::string out;
  append_position_header(arm_with_names("Hips", "Arm"), out);
  EXPECT_EQ(out, "frame,time,Hips.x,Hips.y,Hips.z,Arm.x,Arm.y,Arm.z,Arm_end.x,Arm_end.y,Arm_end.z\n");
}

TEST(Csv, WritesUnitsOnWish) {
  const Skeleton skeleton = arm_with_names("Hips", "Arm");
  std::string channels;
  append_channel_header(skeleton, channels, "cm");
  EXPECT_EQ(channels, "frame,time[s],Hips.Xposition[cm],Hips.Zrotation[deg],Arm.Wobble\n");
  std::string positions;
  append_position_header(skeleton, positions, "m");
  EXPECT_THAT(positions, testing::StartsWith("frame,time[s],Hips.x[m],Hips.y[m],"));
}

TEST(Csv, QuotesNamesThatWouldBreakTheTable) {
  EXPECT_EQ(channel_header(arm_with_names("a,b", "say \"hi\"")),
            "frame,time,\"a,b.Xposition\",\"a,b.Zrotation\",\"say \"\"hi\"\".Wobble\"\n");
}

TEST(Csv, WritesTheFewestDigitsThatReadBackTheSame) {
  const Motion motion(1, 4, 0.5, {93.042686, 1.0, 1.0 / 3.0, -1e-7});
  std::string out;
  append_channel_rows(motion, {0, 4}, out);
  EXPECT_EQ(out, "1,0,93.042686\n2,0.5,1\n3,1,0.3333333333333333\n4,1.5,-1e-07\n");
}

TEST(Csv, KeepsFrameNumbersAndTimesWhenWrittenPieceByPiece) {
  const Motion motion(2, 7, 0.033333, std::vector<double>{1, 2, 3, 4, 5, 6, 7, 10, 20, 30, 40, 50, 60, 70});
  std::string whole;
  append_channel_rows(motion, {0, 7}, whole);
  std::string pieces;
  append_channel_rows(motion, {0, 3}, pieces);
  append_channel_rows(motion, {3, 4}, pieces);
  EXPECT_EQ(pieces, whole);
  EXPECT_THAT(whole, testing::StartsWith("1,0,1,10\n2,0.033333,2,20\n"));
}

TEST(Csv, PositionsAreThoseOfTheWorld) {
  const Skeleton skeleton = arm_with_names("Hips", "Arm");
  const Motion motion(3, 2, 1.0, {0.0, 5.0, 0.0, 180.0, 0.0, 0.0});
  std::string out;
  append_position_rows(skeleton, motion, {0, 1}, PositionRule::Replace, out);
  EXPECT_EQ(out, "1,0,0,0,0,0,10,0,0,10,2\n");
  out.clear();
  append_position_rows(skeleton, motion, {1, 1}, PositionRule::Replace, out);
  EXPECT_EQ(out, "2,1,5,0,0,5,-10,0,5,-10,2\n");
}

}  // namespace
}  // namespace marey
