// Properties of reading and writing over generated figures and motions.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/skeleton/skeleton_builder.h"
#include "tests/core/bvh/bvh_texts.h"
#include "tests/support/random_clip.h"

namespace marey {
namespace {

using namespace test;

NumberFormat random_format(Random& random) {
  NumberFormat format;
  format.form = random.one_in(2) ? NumberFormat::Form::Fixed : NumberFormat::Form::Shortest;
  format.decimals = static_cast<std::uint8_t>(random.below(9));
  format.exponent_digits = static_cast<std::uint8_t>(1 + random.below(3));
  return format;
}

BvhStyle random_style(Random& random, int channel_count) {
  BvhStyle style;
  const std::string line_end = random.one_in(3) ? "\r\n" : random.one_in(5) ? "\r" : "\n";
  style.header.line_end = line_end;
  style.header.indent = random.one_in(2) ? "\t" : "   ";
  style.header.offset_format = random_format(random);
  style.motion.tail = random.one_in(4) ? "" : line_end;
  if (random.one_in(4)) return style;
  style.motion.columns.resize(static_cast<std::size_t>(channel_count));
  for (ColumnStyle& column : style.motion.columns) {
    column.gap = random.one_in(2) ? " " : "\t";
    column.format = random_format(random);
  }
  if (channel_count > 0) style.motion.columns[0].gap = (random.one_in(2) ? " " : "") + line_end;
  return style;
}

TEST(RoundTrip, GivesBackTheSameBitsForGeneratedClipsInAnyStyle) {
  Random random(21);
  for (int i = 0; i < 400; ++i) {
    const Skeleton skeleton = random_skeleton(random, 12);
    const Motion motion = random_motion(random, skeleton.channel_count(), random.below(40));
    expect_round_trip(skeleton, motion, random_style(random, skeleton.channel_count()));
    if (HasFailure()) return;
  }
}

TEST(RoundTrip, GivesBackTheSameBitsAfterEditsOfAFile) {
  Random random(22);
  for (int i = 0; i < 400; ++i) {
    const Skeleton original = random_skeleton(random, 8);
    const Motion motion = random_motion(random, original.channel_count(), 1 + random.below(20));
    BvhClip clip = read_or_fail(write_bvh(original, motion, random_style(random, original.channel_count())));
    for (int edit = random.below(6); edit > 0; --edit) {
      const NodeIndex node = random.below(clip.skeleton.node_count());
      clip.skeleton.set_offset(node, {random_sample(random), random_sample(random), random_sample(random)});
      if (clip.skeleton.channel_count() == 0) continue;
      const int channel = random.below(clip.skeleton.channel_count());
      clip.motion.channel_samples(channel)[static_cast<std::size_t>(random.below(motion.frame_count()))] = random_sample(random);
      if (random.one_in(3)) clip.motion.set_frame_time_s(random.between(0.001, 0.1));
    }
    expect_round_trip(clip.skeleton, clip.motion, clip.style);
    if (HasFailure()) return;
  }
}

TEST(RoundTrip, GivesBackTheSameBitsWithMoreAndFewerFrames) {
  Random random(23);
  for (int i = 0; i < 200; ++i) {
    const Skeleton skeleton = random_skeleton(random, 6);
    const Motion motion = random_motion(random, skeleton.channel_count(), random.below(20));
    const BvhClip clip = read_or_fail(write_bvh(skeleton, motion, random_style(random, skeleton.channel_count())));
    const Motion other = random_motion(random, skeleton.channel_count(), random.below(30));
    expect_round_trip(skeleton, other, clip.style);
    if (HasFailure()) return;
  }
}

TEST(RoundTrip, GivesBackAnotherTreeThanTheOneThatWasRead) {
  Random random(24);
  const BvhClip clip = read_or_fail(one_joint_file("2", "1 2 3\n4 5 6\n"));
  for (int i = 0; i < 100; ++i) {
    const Skeleton skeleton = random_skeleton(random, 6);
    expect_round_trip(skeleton, random_motion(random, skeleton.channel_count(), 3), clip.style);
    if (HasFailure()) return;
  }
}

TEST(RoundTrip, GivesBackTheSameBytesForUniformStyles) {
  Random random(25);
  for (int i = 0; i < 200; ++i) {
    const Skeleton skeleton = random_skeleton(random, 6);
    const Motion motion = random_motion(random, skeleton.channel_count(), 1 + random.below(10));
    const std::string text = write_bvh(skeleton, motion, random_style(random, skeleton.channel_count()));
    ASSERT_EQ(written(read_or_fail(text)), text);
  }
}

TEST(RoundTrip, NamesThatCannotBeWrittenAreMadeReadable) {
  SkeletonBuilder builder;
  builder.open_joint(" a{b}\n c ", {0, 0, 0});
  builder.add_channel(ChannelKind::Other, "two words");
  builder.add_channel(ChannelKind::Other, "");
  builder.open_joint("", {0, 1, 0});
  builder.close_joint();
  builder.close_joint();
  const Skeleton skeleton = *builder.build();
  const BvhClip clip = read_or_fail(write_bvh(skeleton, Motion(2, 1, 0.1), {}));
  EXPECT_EQ(clip.skeleton.name(0), "a_b__ c");
  EXPECT_EQ(clip.skeleton.name(1), "");
  EXPECT_EQ(clip.skeleton.channel(0).other_name, "two_words");
  EXPECT_EQ(clip.skeleton.channel_count(), 2);
}

TEST(Style, EditedNumbersLeaveTheRestOfTheFileAsItWas) {
  const std::string text = one_joint_file("3", "1.50 2.25 3.00\r\n 4.50  5.25 6\n7.50 8.25 9.00\n");
  BvhClip clip = read_or_fail(text);
  clip.motion.channel_samples(1)[1] = -0.5;
  EXPECT_EQ(written(clip), one_joint_file("3", "1.50 2.25 3.00\r\n 4.50  -0.50 6\n7.50 8.25 9.00\n"));
  clip.skeleton.set_offset(1, {0.0, 12.125, 0.0});
  std::string expected = written(clip);
  EXPECT_NE(expected.find("    OFFSET 0.0 12.125 0.0\n"), std::string::npos) << expected;
  EXPECT_NE(expected.find("Frame Time: 0.033333\n1.50 2.25 3.00\r\n"), std::string::npos) << expected;
}

TEST(Style, CanonicalFormIsPlain) {
  SkeletonBuilder builder;
  builder.open_joint("Hips", {0, 0, 0});
  builder.add_channel(ChannelKind::Yposition);
  builder.add_channel(ChannelKind::Zrotation);
  builder.add_end_site({0, 10, 0.1 + 0.2});
  builder.close_joint();
  Motion motion(2, 2, 1.0 / 30.0);
  motion.channel_samples(1)[1] = -2.5;
  EXPECT_EQ(write_bvh(*builder.build(), motion, {}),
            "HIERARCHY\nROOT Hips\n{\n  OFFSET 0.0 0.0 0.0\n  CHANNELS 2 Yposition Zrotation\n  End Site\n  {\n"
            "    OFFSET 0.0 10.0 0.30000000000000004\n  }\n}\nMOTION\nFrames: 2\nFrame Time: 0.03333333333333333\n"
            "0.0 0.0\n0.0 -2.5\n");
}

}  // namespace
}  // namespace marey
