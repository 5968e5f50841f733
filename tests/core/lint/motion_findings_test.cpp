#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/math/euler.h"
#include "tests/core/lint/lint_clips.h"
#include "tests/support/random.h"

namespace marey {
namespace {

using namespace test;
using Kind = FindingKind;

constexpr int kFrames = 300;

TEST(CurveFindings, NothingAboutAnEvenMovement) { EXPECT_EQ(kinds_of(lint_clip(make_moving_walker(kFrames))), ""); }

TEST(CurveFindings, AJumpIsFoundBetweenItsFrames) {
  Clip clip = make_moving_walker(kFrames);
  const auto chest = samples_of(clip, "Chest Xrotation");
  for (FrameIndex frame = 100; frame < kFrames; ++frame) chest[idx(frame)] += 40.0;
  const LintReport report = lint_clip(clip);
  EXPECT_EQ(kinds_of(report), "jump");
  EXPECT_EQ(report.findings[0].channel, find_channel(clip, "Chest Xrotation"));
  EXPECT_EQ(report.findings[0].joint, 3);
  EXPECT_EQ(report.findings[0].frames, (FrameRange{99, 2}));
  EXPECT_NE(report.findings[0].message.find("between frames 100 and 101."), std::string::npos) << report.findings[0].message;
}

TEST(CurveFindings, AJumpOfTheRootIsMeasuredInStatures) {
  Clip clip = make_moving_walker(kFrames);
  const auto place = samples_of(clip, "Hips Xposition");
  for (FrameIndex frame = 50; frame < kFrames; ++frame) place[idx(frame)] += 20.0;
  EXPECT_EQ(the_finding(lint_clip(clip), Kind::Jump).channel, find_channel(clip, "Hips Xposition"));
  const std::string metres = the_finding(lint_clip(clip, {.metres_per_unit = 0.01}), Kind::Jump).message;
  EXPECT_NE(metres.find("20 units (0.2 m)"), std::string::npos) << metres;
}

TEST(CurveFindings, ChannelsThatJumpTogetherAreOneFinding) {
  Clip clip = make_moving_walker(kFrames);
  for (const char* label : {"Knee Xrotation", "Foot Xrotation", "Chest Yrotation"}) {
    const auto samples = samples_of(clip, label);
    for (FrameIndex frame = 100; frame < kFrames; ++frame) samples[idx(frame)] += 40.0;
  }
  EXPECT_EQ(the_finding(lint_clip(clip), Kind::Jump).count, 3);
}

TEST(CurveFindings, ASpikeIsNoJump) {
  Clip clip = make_moving_walker(kFrames);
  samples_of(clip, "Foot Zrotation")[200] += 30.0;
  const LintReport report = lint_clip(clip);
  EXPECT_EQ(kinds_of(report), "spike");
  EXPECT_EQ(report.findings[0].frames, (FrameRange{200, 1}));
}

TEST(CurveFindings, AQuickMovementIsNeither) {
  Clip clip = make_moving_walker(kFrames);
  const auto chest = samples_of(clip, "Chest Xrotation");
  for (FrameIndex frame = 0; frame < kFrames; ++frame) chest[idx(frame)] += 60.0 * std::tanh((frame - 150) / 2.0);
  EXPECT_EQ(kinds_of(lint_clip(clip)), "");
}

TEST(CurveFindings, NoiseIsNeither) {
  Clip clip = make_moving_walker(kFrames);
  Random random(7);
  for (double& angle : samples_of(clip, "Knee Xrotation")) angle += 10.0 * random.between(-1.0, 1.0);
  EXPECT_EQ(kinds_of(lint_clip(clip)), "");
}

TEST(CurveFindings, AListOfPosesHasNoSteps) {
  Clip clip = make_moving_walker(kFrames);
  clip.motion.set_frame_time_s(1.0);
  samples_of(clip, "Foot Zrotation")[200] += 30.0;
  EXPECT_EQ(kinds_of(lint_clip(clip)), "");
}

TEST(CurveFindings, TheWorstAreKeptAndTheRestCounted) {
  Clip clip = make_moving_walker(2000);
  for (int i = 1; i <= 40; ++i) samples_of(clip, "Foot Zrotation")[idx(i * 45)] += 20.0 + i;
  const LintReport report = lint_clip(clip, {.most_per_kind = 5, .metres_per_unit = std::nullopt});
  ASSERT_EQ(report.findings.size(), 5U);
  EXPECT_EQ(report.left_out[static_cast<std::size_t>(Kind::Spike)], 35);
  EXPECT_EQ(report.findings[0].frames, (FrameRange{36 * 45, 1}));
  EXPECT_EQ(report.findings[4].frames, (FrameRange{40 * 45, 1}));
}

TEST(TurnFindings, AWholeTurnIsAWrap) {
  Clip clip = make_moving_walker(kFrames);
  const auto heading = samples_of(clip, "Hips Yrotation");
  for (FrameIndex frame = 0; frame < kFrames; ++frame) heading[idx(frame)] = std::remainder(2.0 * frame + 0.5, 360.0);
  const LintReport report = lint_clip(clip);
  EXPECT_EQ(kinds_of(report), "angle_wrap");
  EXPECT_EQ(report.findings[0].count, 2);
  EXPECT_EQ(report.findings[0].frames, (FrameRange{89, 182}));
}

TEST(TurnFindings, TheOtherNameOfARotationIsAFlip) {
  Clip clip = make_moving_walker(kFrames);
  const EulerOrder order{Axis::Z, Axis::X, Axis::Y};
  const auto z = samples_of(clip, "Knee Zrotation");
  const auto x = samples_of(clip, "Knee Xrotation");
  const auto y = samples_of(clip, "Knee Yrotation");
  for (std::size_t frame = 0; frame < idx(kFrames); ++frame) x[frame] = 60.0 + 0.2 * static_cast<double>(frame);
  for (std::size_t frame = 0; frame < idx(kFrames); ++frame) {
    const glm::dquat rotation = rotation_from_euler(order, {z[frame] + 20.0, x[frame], y[frame] + 30.0});
    const glm::dvec3 angles = euler_from_rotation(order, glm::mat3_cast(rotation));
    z[frame] = angles.x;
    x[frame] = angles.y;
    y[frame] = angles.z;
  }
  const LintReport report = lint_clip(clip);
  EXPECT_EQ(kinds_of(report), "gimbal_flip");
  EXPECT_EQ(report.findings[0].joint, 1);
}

TEST(TurnFindings, AnAngleThatGoesOnBeyondATurnIsNoWrap) {
  Clip clip = make_moving_walker(kFrames);
  const auto heading = samples_of(clip, "Hips Yrotation");
  for (FrameIndex frame = 0; frame < kFrames; ++frame) heading[idx(frame)] = 5.0 * frame;
  EXPECT_EQ(kinds_of(lint_clip(clip)), "");
}

TEST(FreezeFindings, AFigureThatStandsStillIsOneFinding) {
  Clip clip = make_moving_walker(kFrames);
  for (ChannelIndex channel = 0; channel < clip.skeleton.channel_count(); ++channel) {
    const auto samples = clip.motion.channel_samples(channel);
    for (std::size_t frame = 101; frame < 150; ++frame) samples[frame] = samples[100];
  }
  const Finding finding = the_finding(lint_clip(clip), Kind::FrozenFigure);
  EXPECT_EQ(finding.frames, (FrameRange{100, 50}));
  EXPECT_EQ(finding.message, "Nothing moves in frames 101-150, 0.817 s.");
}

TEST(FreezeFindings, ChannelsThatFreezeTogetherAreOneFinding) {
  Clip clip = make_moving_walker(kFrames);
  for (const char* label : {"Foot Xrotation", "Foot Yrotation"}) {
    const auto samples = samples_of(clip, label);
    for (std::size_t frame = 101; frame < 150; ++frame) samples[frame] = samples[100];
  }
  const LintReport report = lint_clip(clip);
  EXPECT_EQ(kinds_of(report), "frozen_channel");
  EXPECT_EQ(report.findings[0].count, 2);
  EXPECT_EQ(report.findings[0].frames, (FrameRange{100, 50}));
}

TEST(FreezeFindings, ARestThatIsEnteredSlowlyIsMeant) {
  Clip clip = make_moving_walker(kFrames);
  const auto foot = samples_of(clip, "Foot Xrotation");
  for (FrameIndex frame = 0; frame < kFrames; ++frame) {
    const double away = std::max(0.0, std::abs(frame - 150.0) - 40.0) / 110.0;
    foot[idx(frame)] = 30.0 * away * away * away;
  }
  EXPECT_EQ(kinds_of(lint_clip(clip)), "");
}

TEST(FreezeFindings, ShortOnesAndConstantChannelsAreNone) {
  Clip clip = make_moving_walker(kFrames);
  const auto foot = samples_of(clip, "Foot Xrotation");
  for (std::size_t frame = 101; frame < 125; ++frame) foot[frame] = foot[100];
  for (double& angle : samples_of(clip, "Knee Yrotation")) angle = 3.0;
  EXPECT_EQ(kinds_of(lint_clip(clip)), "");
}

TEST(FloorFindings, AFootThatSinksIsMeasured) {
  Clip clip = make_moving_walker(kFrames);
  const auto height = samples_of(clip, "Hips Yposition");
  for (FrameIndex frame = 0; frame < kFrames; ++frame) height[idx(frame)] -= 20.0 * std::exp(-std::pow((frame - 150) / 20.0, 2));
  const LintReport report = lint_clip(clip, {.metres_per_unit = 0.01});
  EXPECT_EQ(kinds_of(report), "below_floor");
  const Finding& finding = report.findings[0];
  EXPECT_EQ(finding.joint, 2);
  EXPECT_TRUE(finding.frames->contains(150));
  EXPECT_LT(finding.frames->count, 60);
  EXPECT_NE(finding.message.find(" m), "), std::string::npos) << finding.message;
}

TEST(FloorFindings, WhatHangsOrFliesHasNoFloor) {
  Clip swing;
  swing.skeleton = figures::make_gymnast();
  swing.motion = figures::make_giant_swing();
  EXPECT_EQ(kinds_of(lint_clip(swing)), "");
  Clip flight = make_moving_walker(kFrames);
  const auto height = samples_of(flight, "Hips Yposition");
  for (FrameIndex frame = 0; frame < kFrames; ++frame) height[idx(frame)] += 60.0 * std::sin(frame * 0.05);
  EXPECT_EQ(kinds_of(lint_clip(flight)), "");
}

TEST(ReferencePose, IsFoundInTheFirstFrameAndTakenOutOfTheOthers) {
  Clip clip = make_moving_walker(kFrames);
  for (ChannelIndex channel = 0; channel < clip.skeleton.channel_count(); ++channel) {
    const bool turns = is_rotation(clip.skeleton.channel(channel).kind);
    for (double& sample : clip.motion.channel_samples(channel)) sample += turns ? 25.0 : 0.0;
    clip.motion.channel_samples(channel)[0] = 0.0;
  }
  const LintReport report = lint_clip(clip);
  EXPECT_EQ(kinds_of(report), "reference_pose");
  EXPECT_EQ(report.findings[0].frames, (FrameRange{0, 1}));
  EXPECT_NE(report.findings[0].message.find("with all angles 0"), std::string::npos);
}

TEST(Lint, TakesClipsOfAnyLengthAndSamplesThatAreNotFinite) {
  for (const int frames : {0, 1, 2, 3, 4, 7, 8, 9}) EXPECT_EQ(kinds_of(lint_clip(make_moving_walker(frames))), "") << frames;
  Clip clip = make_moving_walker(kFrames);
  samples_of(clip, "Knee Xrotation")[50] = std::numeric_limits<double>::quiet_NaN();
  samples_of(clip, "Hips Yposition")[90] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(kinds_of(lint_clip(clip)), "");
}

TEST(Lint, GivesTheSameReportAgain) {
  const Skeleton skeleton = figures::make_random_skeleton(40, 5);
  const Clip clip{skeleton, figures::make_random_motion(skeleton, 200, 180.0, 6), {}};
  const LintReport first = lint_clip(clip);
  const LintReport second = lint_clip(clip);
  ASSERT_EQ(kinds_of(first), kinds_of(second));
  for (std::size_t i = 0; i < first.findings.size(); ++i) EXPECT_EQ(first.findings[i].message, second.findings[i].message);
}

}  // namespace
}  // namespace marey
