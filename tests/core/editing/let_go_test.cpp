// "Let go": what the operation makes of a passive motion; the mechanics are in tests/core/biomechanics.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/biomechanics/chosen_body.h"
#include "core/biomechanics/mechanics.h"
#include "core/editing/history.h"
#include "core/math/angle.h"
#include "core/motion/sampling.h"
#include "tests/core/editing/operation_clips.h"
#include "tests/core/kinematics/figures.h"

namespace marey::test {
namespace {

double root_choice(std::string_view choice) { return choice_of("let-go", "root", choice); }
double start_choice(std::string_view choice) { return choice_of("let-go", "start", choice); }

Clip make_swing() {
  Clip clip;
  clip.skeleton = figures::make_gymnast();
  clip.motion = figures::make_giant_swing();
  clip.settings.metres_per_unit = 0.055;
  return clip;
}

std::string refusal_of(const Clip& clip, std::initializer_list<Given> given) {
  const Operation& operation = *find_operation("let-go");
  const auto outcome = make_operation_edit(clip, operation, whole_clip(clip), values_of(operation, given));
  return outcome ? "" : outcome.error().message;
}

TEST(LetGo, KeepsTheFramesBefore) {
  const Clip clip = make_swing();
  const Clip passive = after(clip, "let-go", {{"frame", 7}, {"seconds", 2.0}});
  ASSERT_EQ(passive.motion.frame_count(), 8 + 60);
  EXPECT_EQ(passive.motion.frame_time_s(), clip.motion.frame_time_s());
  for (ChannelIndex channel = 0; channel < clip.motion.channel_count(); ++channel) {
    for (FrameIndex frame = 0; frame < 8; ++frame) {
      EXPECT_EQ(passive.motion.sample(channel, frame), clip.motion.sample(channel, frame));
    }
  }
  EXPECT_EQ(passive.file_frames[7], 7);
  EXPECT_EQ(passive.file_frames[8], kNewFrame);
}

// The gymnast is seen from the side and stays in the plane; the angles go on without whole turns between them.
TEST(LetGo, GoesOnAsItMoves) {
  const Clip clip = after(make_swing(), "resample", {{"rate", 300.0}});
  const Clip passive = after(clip, "let-go", {{"frame", 125}, {"seconds", 1.0}});
  for (const ChannelIndex channel : {3, 6, 9}) {
    const auto samples = passive.motion.channel_samples(channel);
    const double speed = 0.5 * (clip.motion.sample(channel, 126) - clip.motion.sample(channel, 124));
    EXPECT_NEAR(samples[126] - samples[125], speed, 0.12) << channel;
    EXPECT_GT(std::abs(speed), 0.3) << channel;
    for (std::size_t i = 126; i < samples.size(); ++i) EXPECT_LT(std::abs(samples[i] - samples[i - 1]), 20.0) << channel;
  }
  for (const ChannelIndex channel : {0, 1, 2, 4, 5, 7, 8, 10, 11}) {
    EXPECT_THAT(passive.motion.channel_samples(channel).subspan(126), testing::Each(0.0)) << channel;
  }
}

// Hinges and joints of two axes; the first turns round and round.
TEST(LetGo, GoesOnWithFewerAxes) {
  const glm::dvec3 down(0.0, -1.0, 0.0);
  Clip clip;
  clip.skeleton = figures::make_skeleton({{"Upper", kNoParent, glm::dvec3(0.0), figures::channels("Z"), {}},
                                          {"Lower", 0, down, figures::channels("ZX"), {down}}});
  clip.settings.metres_per_unit = 1.0;
  clip.motion = figures::make_motion({{0, 10, 30}, {30, 11, 32}, {60, 12, 34}}, 1.0 / 30.0);
  const Clip passive = after(clip, "let-go", {{"frame", 1}, {"seconds", 3.0}});
  const Motion& motion = passive.motion;
  double highest = 0.0;
  for (ChannelIndex channel = 0; channel < 3; ++channel) {
    for (FrameIndex frame = 2; frame < motion.frame_count(); ++frame) {
      EXPECT_LT(std::abs(motion.sample(channel, frame) - motion.sample(channel, frame - 1)), 120.0) << channel << " " << frame;
      highest = std::max(highest, motion.sample(channel, frame));
    }
  }
  EXPECT_GT(highest, 720.0);
  const BodyModel model = find_chosen_body(clip)->body.model;
  const BodyMotion body = *find_body_motion(passive, {}, motion.frame_time_s(), 1.0);
  std::vector<JointLoad> loads(2);
  find_joint_loads(body, passive.skeleton, model, {0.0, -9.81, 0.0}, 20, {}, loads);
  // By differences of frames the torque about the bar is as good as none beside what the bar holds.
  EXPECT_LT(std::abs(loads[0].torque.z), 0.1 * glm::length(loads[0].force));
}

TEST(LetGo, BeginsAtRestWhereThatIsWanted) {
  const Clip passive = after(make_swing(), "let-go", {{"frame", 5}, {"seconds", 0.1}, {"start", start_choice("at-rest")}});
  const auto arms = passive.motion.channel_samples(3);
  // From rest the ways are as the squares of the times.
  EXPECT_NEAR((arms[7] - arms[5]) / (arms[6] - arms[5]), 4.0, 0.1);
  EXPECT_LT(std::abs(arms[6] - arms[5]), 2.0);
}

TEST(LetGo, TellsEnergyBodyAndSupport) {
  const Clip clip = make_swing();
  const auto notes = outcome_of(clip, "let-go", whole_clip(clip)).notes;
  ASSERT_EQ(notes.size(), 2u);
  EXPECT_THAT(notes[0], testing::MatchesRegex("Energy drifts by [0-9]e-[0-9]+ of the largest kinetic energy\\."));
  EXPECT_EQ(notes[1], "73 kg by deleva-male, held at the root.");
  const auto flight = outcome_of(clip, "let-go", whole_clip(clip), {{"root", root_choice("free")}}).notes;
  EXPECT_EQ(flight[1], "73 kg by deleva-male, falling freely.");
}

// The centre of mass of a walker falls by g t^2 / 2, and goes on as it went.
TEST(LetGo, FallsFreely) {
  Clip clip = make_figure(30);
  clip.settings.metres_per_unit = 0.01;
  const Clip passive = after(clip, "let-go", {{"frame", 10}, {"seconds", 1.0}});
  ASSERT_EQ(passive.motion.frame_count(), 11 + 30);
  const BodyModel model = find_chosen_body(clip)->body.model;
  const BodyMotion body = *find_body_motion(passive, {}, passive.motion.frame_time_s(), 0.01);
  const auto com = [&](FrameIndex frame) { return find_body_state(body, model, {0.0, -9.81, 0.0}, frame).com; };
  const double t = passive.motion.frame_time_s();
  for (FrameIndex frame = 11; frame < 40; ++frame) {
    const glm::dvec3 acceleration = (com(frame + 1) - 2.0 * com(frame) + com(frame - 1)) / (t * t);
    EXPECT_NEAR(acceleration.x, 0.0, 1e-4) << frame;
    EXPECT_NEAR(acceleration.y, -9.81, 1e-4) << frame;
    EXPECT_NEAR(acceleration.z, 0.0, 1e-4) << frame;
  }
}

TEST(LetGo, FallsDownTheUpAxisOfTheClip) {
  Clip clip = make_swing();
  clip.settings.up_axis = Axis::X;
  const Clip passive = after(clip, "let-go", {{"root", root_choice("free")}, {"start", start_choice("at-rest")}, {"seconds", 1.0}});
  const FrameIndex last = passive.motion.frame_count() - 1;
  const double time = 0.033333 * last;
  EXPECT_NEAR(passive.motion.sample(0, last), -0.5 * 9.81 * time * time / 0.055, 1e-6);
  EXPECT_NEAR(passive.motion.sample(1, last), 0.0, 1e-9);
}

TEST(LetGo, SaysWhyNot) {
  const Clip clip = make_swing();
  EXPECT_EQ(refusal_of(clip, {{"frame", 23}}), "The clip has 23 frames; there is no frame 24 to let go at.");
  Clip still = make_swing();
  const glm::dvec3 tip(0.0, 1.0, 0.0);
  still.skeleton = figures::make_skeleton({{"Arms", kNoParent, glm::dvec3(0.0), figures::channels("xzZ"), {tip}}});
  still.motion = figures::make_motion({{0, 0, 10}, {0, 0, 20}}, 0.1);
  EXPECT_EQ(refusal_of(still, {{"root", root_choice("free")}}), "'Arms' has no Yposition channel to fall by; hold it by root=held.");
  EXPECT_EQ(refusal_of(still, {}), "");
  still.motion.set_frame_time_s(1e-7);
  EXPECT_EQ(refusal_of(still, {}), "This gives more frames than can be followed; let it go for fewer seconds.");
  still.motion = figures::make_motion({{0, 0, std::nan("")}}, 0.1);
  EXPECT_EQ(refusal_of(still, {}), "Arms Zrotation of frame 1 is not a finite number; let go at another frame, or fill the gaps.");
  EXPECT_NE(refusal_of(make_figure(0), {}), "");
}

}  // namespace
}  // namespace marey::test
