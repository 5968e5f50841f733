// Tables and clips, there and back; and tables that are cut or damaged anywhere.
#include <gtest/gtest.h>

#include <iostream>

#include "core/base/bits.h"
#include "core/bvh/reader.h"
#include "core/table/csv_reader.h"
#include "tests/core/bvh/bvh_texts.h"
#include "tests/core/table/tables.h"
#include "tests/support/files.h"
#include "tests/support/random.h"
#include "tests/support/random_clip.h"

namespace marey {
namespace {

using namespace test;

BvhClip random_clip(Random& random, int least_frames) {
  BvhClip clip;
  clip.skeleton = random_skeleton(random, 12);
  clip.motion = random_motion(random, clip.skeleton.channel_count(), least_frames + random.below(8));
  clip.motion.set_frame_time_s(random.between(1e-4, 0.2));
  return clip;
}

void expect_channels_come_back(const BvhClip& clip, const std::string& what, const std::string& unit = {}) {
  const std::string table = channel_table(clip, unit);
  const Result<BvhClip> again = read_channel_table(table, clip, {.strict = true, .limits = {}});
  ASSERT_TRUE(again) << what << ": " << again.error().message;
  EXPECT_TRUE(same_numbers(clip.skeleton, clip.motion, again->skeleton, again->motion)) << what;
  EXPECT_EQ(channel_table(*again, unit) == table, true) << what;
}

TEST(TableRoundTrip, RandomClipsGiveBackTheirBits) {
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    const BvhClip clip = random_clip(random, 2);
    if (clip.skeleton.channel_count() == 0) continue;
    expect_channels_come_back(clip, std::to_string(i), i % 2 == 0 ? "" : "cm");
  }
}

TEST(TableRoundTrip, AnyFrameTimeComesBackExactly) {
  Random random(6);
  BvhClip clip;
  clip.skeleton = read_or_fail(one_joint_file("0", "")).skeleton;
  for (int i = 0; i < 2000; ++i) {
    clip.motion = Motion(3, 2 + random.below(60), random.between(1e-5, 1.0));
    const Result<BvhClip> again = read_channel_table(channel_table(clip), clip);
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_TRUE(same_bits(again->motion.frame_time_s(), clip.motion.frame_time_s()));
    EXPECT_TRUE(again->diagnostics.empty());
  }
}

TEST(TableRoundTrip, PointsComeOutByteForByte) {
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    BvhClip clip = random_clip(random, 2);
    for (ChannelIndex channel = 0; channel < clip.motion.channel_count(); ++channel) {
      for (double& sample : clip.motion.channel_samples(channel)) sample = random.between(-500.0, 500.0);
    }
    for (NodeIndex node = 0; node < clip.skeleton.node_count(); ++node) clip.skeleton.set_offset(node, {random.between(-9.0, 9.0), 1.0, 0.5});
    const std::string table = position_table(clip, "m");
    const Result<BvhClip> points = read_points_table(table, {.strict = true, .limits = {}});
    ASSERT_TRUE(points) << points.error().message;
    EXPECT_EQ(position_table(*points, "m"), table);
    expect_channels_come_back(*points, "points");
  }
}

TEST(TableRoundTrip, RecordedFilesGiveBackTheirBits) {
  if (recorded_bvh_files().empty()) GTEST_SKIP() << "no recorded files at " << shared_dir();
  int files = 0;
  std::int64_t samples = 0;
  for (const std::string& path : recorded_bvh_files()) {
    const Result<BvhClip> clip = read_bvh(read_shared_file(path).value_or(""));
    if (!clip || clip->motion.frame_count() < 2) continue;
    expect_channels_come_back(*clip, path);
    ++files;
    samples += static_cast<std::int64_t>(clip->motion.samples().size());
  }
  std::cout << files << " files with " << samples << " samples written as tables and read back\n";
  EXPECT_GE(files, 30);
}

TEST(TableDamage, ATableCutAnywhereIsReadOrRefused) {
  const BvhClip figure = read_or_fail(one_joint_file("3", "1.5 2 -3\n4 5 6\n7 8 9\n"));
  const std::string channels = channel_table(figure, "cm");
  const std::string points = position_table(figure);
  int read = 0;
  for (std::size_t size = 0; size <= std::max(channels.size(), points.size()); ++size) {
    const Result<BvhClip> a = read_channel_table(channels.substr(0, size), figure);
    const Result<BvhClip> b = read_points_table(points.substr(0, size));
    for (const Result<BvhClip>* clip : {&a, &b}) {
      read += *clip ? 1 : 0;
      EXPECT_TRUE(*clip || !clip->error().message.empty());
      EXPECT_TRUE(!*clip || (*clip)->motion.frame_count() <= 3);
      EXPECT_TRUE(!*clip || (*clip)->motion.channel_count() == (*clip)->skeleton.channel_count());
    }
  }
  EXPECT_GT(read, 20);
}

TEST(TableDamage, AnyByteMayBeWrong) {
  const BvhClip figure = read_or_fail(one_joint_file("3", "1.5 2 -3\n4 5 6\n7 8 9\n"));
  const std::string table = "time,\"Hips.Zrotation\",Hips.Xrotation[deg];Hips.x\n0,1,2.5,3\n1,\"4\",5,6\n2,7,8,9\n";
  Random random(11);
  constexpr std::string_view kBytes = ",;\t\"\n\r.x[]#-+e9\0 \xff";
  for (int i = 0; i < 20000; ++i) {
    std::string damaged = table;
    for (int k = random.below(4); k >= 0; --k) {
      const auto at = static_cast<std::size_t>(random.below(static_cast<int>(damaged.size())));
      damaged[at] = kBytes[static_cast<std::size_t>(random.below(static_cast<int>(kBytes.size())))];
    }
    const Result<BvhClip> a = read_channel_table(damaged, figure);
    const Result<BvhClip> b = read_points_table(damaged);
    EXPECT_TRUE(!a || a->motion.channel_count() == figure.skeleton.channel_count());
    EXPECT_TRUE(!b || b->motion.channel_count() == b->skeleton.channel_count());
  }
}

}  // namespace
}  // namespace marey
