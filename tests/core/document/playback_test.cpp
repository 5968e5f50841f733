#include "core/document/playback.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace marey::test {
namespace {

using testing::Each;
using testing::SizeIs;

constexpr double kFrameTimeS = 1.0 / 30.0;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Playback make_playing(int frame_count, double speed = 1.0) {
  Playback playback(frame_count, kFrameTimeS);
  playback.set_speed(speed);
  playback.set_playing(true);
  return playback;
}

TEST(Playback, ShowsEveryFrameOnceInOrderPerLoopWhateverTheTick) {
  constexpr int kLoops = 50;
  for (const int frame_count : {2, 3, 7, 30, 101}) {
    for (const double tick_s : {kFrameTimeS, kFrameTimeS / 2, 1.0 / 60, 1.0 / 144, 0.0333, 0.0007, 1.0 / 59.94}) {
      Playback playback = make_playing(frame_count);
      std::vector<FrameIndex> shown = {playback.frame()};
      while (size_of(shown) <= frame_count * kLoops) {
        ASSERT_TRUE(playback.advance(tick_s));
        ASSERT_EQ(playback.position(), std::floor(playback.position()));
        if (playback.frame() != shown.back()) shown.push_back(playback.frame());
      }
      for (int i = 0; i < size_of(shown); ++i) ASSERT_EQ(shown[idx(i)], i % frame_count) << tick_s;
    }
  }
}

TEST(Playback, HalfATickPerFrameShowsEachFrameForTwoTicks) {
  Playback playback = make_playing(100);
  std::map<FrameIndex, int> ticks;
  for (int tick = 0; tick < 200 * 50; ++tick, playback.advance(1.0 / 60)) ++ticks[playback.frame()];
  EXPECT_THAT(ticks, SizeIs(100));
  for (const auto& [frame, count] : ticks) EXPECT_EQ(count, 100) << frame;
}

TEST(Playback, DoesNotDrift) {
  for (const double speed : {0.1, 0.25, 1.0, 3.0}) {
    Playback playback = make_playing(1000, speed);
    constexpr int kTicks = 1'000'000;
    constexpr double kTickS = 0.0123;
    for (int tick = 0; tick < kTicks; ++tick) playback.advance(kTickS);
    const double frames = kTicks * kTickS * speed / kFrameTimeS;
    EXPECT_NEAR(playback.position(), std::fmod(frames, 1000.0), speed < 1.0 ? 1e-3 : 1.0);
  }
}

TEST(Playback, FastSpeedsShowWholeFrames) {
  Playback playback = make_playing(1000, 2.5);
  playback.advance(kFrameTimeS);
  EXPECT_EQ(playback.position(), 2.0);
  playback.advance(kFrameTimeS);
  EXPECT_EQ(playback.position(), 5.0);
}

TEST(Playback, SlowSpeedsInterpolateAndHoldTheLastFrameOfALoop) {
  Playback playback = make_playing(3, 0.25);
  playback.advance(kFrameTimeS);
  EXPECT_NEAR(playback.position(), 0.25, 1e-12);
  playback.advance(7 * kFrameTimeS);
  EXPECT_NEAR(playback.position(), 2.0, 1e-12);
  playback.advance(3 * kFrameTimeS);
  EXPECT_EQ(playback.position(), 2.0);
  EXPECT_TRUE(playback.advance(1.5 * kFrameTimeS));
  EXPECT_NEAR(playback.position(), 0.125, 1e-12);
}

TEST(Playback, WithoutLoopStopsOnTheLastFrame) {
  for (const double speed : {0.3, 1.0, 16.0}) {
    Playback playback = make_playing(10, speed);
    playback.set_loops(false);
    int ticks = 0;
    while (playback.advance(kFrameTimeS / 3)) ++ticks;
    EXPECT_EQ(playback.position(), 9.0);
    EXPECT_FALSE(playback.is_playing());
    EXPECT_EQ(ticks + 1, std::ceil(9 * 3 / speed - 1e-9));
    EXPECT_FALSE(playback.advance(1.0));
    EXPECT_EQ(playback.position(), 9.0);
  }
}

TEST(Playback, PlayAtTheEndStartsOver) {
  for (const bool loops : {false, true}) {
    Playback playback(10, kFrameTimeS);
    playback.set_loops(loops);
    playback.set_range({2, 5});
    for (const double position : {6.0, 0.0, 9.0, 6.2}) {
      playback.set_position(position);
      playback.set_playing(true);
      EXPECT_EQ(playback.position(), 2.0);
      playback.advance(kFrameTimeS);
      EXPECT_EQ(playback.position(), 3.0);
      playback.set_playing(false);
    }
    playback.set_position(4.0);
    playback.set_playing(true);
    EXPECT_EQ(playback.position(), 4.0);
  }
}

TEST(Playback, StaysWithinTheRange) {
  Playback playback = make_playing(100);
  playback.set_range({40, 3});
  for (int i = 0; i < 20; ++i) {
    playback.advance(kFrameTimeS);
    EXPECT_EQ(playback.frame(), 40 + i % 3);
  }
  playback.set_position(90);
  playback.advance(kFrameTimeS);
  EXPECT_EQ(playback.frame(), 40);
}

TEST(Playback, ClipsOfNoneOrOneFrameCannotBePlayed) {
  for (const int frame_count : {0, 1}) {
    Playback playback = make_playing(frame_count);
    EXPECT_FALSE(playback.is_playing());
    EXPECT_FALSE(playback.advance(10.0));
    playback.step(1);
    playback.step(-1);
    playback.set_position(5.0);
    playback.set_range({3, 4});
    EXPECT_EQ(playback.position(), 0.0);
    EXPECT_EQ(playback.range(), (FrameRange{0, frame_count}));
  }
  EXPECT_EQ(Playback().frame(), 0);
}

TEST(Playback, StepsPauseAndGoByWholeFrames) {
  Playback playback = make_playing(10);
  playback.set_position(3.5);
  playback.step(1);
  EXPECT_FALSE(playback.is_playing());
  EXPECT_EQ(playback.position(), 4.0);
  playback.set_position(3.5);
  playback.step(-1);
  EXPECT_EQ(playback.position(), 3.0);
  playback.step(4);
  EXPECT_EQ(playback.position(), 7.0);
  playback.step(std::numeric_limits<int>::max());
  EXPECT_EQ(playback.position(), 9.0);
  playback.step(std::numeric_limits<int>::min());
  EXPECT_EQ(playback.position(), 0.0);
  playback.set_range({2, 4});
  playback.step(100);
  EXPECT_EQ(playback.position(), 5.0);
}

TEST(Playback, NumbersOutOfRangeAreClamped) {
  Playback playback(10, kFrameTimeS);
  playback.set_position(99.0);
  EXPECT_EQ(playback.position(), 9.0);
  playback.set_position(-kInfinity);
  EXPECT_EQ(playback.position(), 0.0);
  playback.set_position(4.0);
  playback.set_position(kNan);
  EXPECT_EQ(playback.position(), 4.0);
  playback.set_speed(1000.0);
  EXPECT_EQ(playback.speed(), Playback::kMaxSpeed);
  playback.set_speed(-1.0);
  EXPECT_EQ(playback.speed(), Playback::kMinSpeed);
  playback.set_speed(kNan);
  EXPECT_EQ(playback.speed(), Playback::kMinSpeed);
}

TEST(Playback, RangesAreClampedToTheClip) {
  constexpr int kMax = std::numeric_limits<int>::max();
  Playback playback(10, kFrameTimeS);
  const std::pair<FrameRange, FrameRange> cases[] = {
      {{2, 3}, {2, 3}},       {{-5, 8}, {0, 3}},       {{-5, 2}, {0, 1}},    {{8, 9}, {8, 2}},     {{20, 5}, {9, 1}},
      {{kMax, kMax}, {9, 1}}, {{-kMax, kMax}, {0, 1}}, {{4, -kMax}, {4, 1}}, {{0, kMax}, {0, 10}},
  };
  for (const auto& [given, expected] : cases) {
    playback.set_range(given);
    EXPECT_EQ(playback.range(), expected) << given.first << " " << given.count;
  }
}

TEST(Playback, SurvivesABrokenClock) {
  Playback playback = make_playing(10);
  for (const double elapsed_s : {kNan, -1.0, 0.0}) {
    EXPECT_TRUE(playback.advance(elapsed_s));
    EXPECT_EQ(playback.position(), 0.0);
  }
  for (const double elapsed_s : {1e9, 1e300, kInfinity}) {
    EXPECT_TRUE(playback.advance(elapsed_s));
    EXPECT_GE(playback.position(), 0.0);
    EXPECT_LE(playback.position(), 9.0);
  }
}

TEST(Playback, FollowsTheClip) {
  Playback playback(100, kFrameTimeS);
  playback.set_position(80);
  playback.set_clip(50, kFrameTimeS);
  EXPECT_EQ(playback.position(), 49.0);
  EXPECT_EQ(playback.range(), (FrameRange{0, 50}));
  playback.set_range({10, 30});
  playback.set_clip(20, kFrameTimeS);
  EXPECT_EQ(playback.range(), (FrameRange{10, 10}));
  playback.set_clip(0, kFrameTimeS);
  EXPECT_EQ(playback.range(), (FrameRange{0, 0}));
  playback.set_clip(5, kFrameTimeS);
  EXPECT_EQ(playback.range(), (FrameRange{0, 5}));
}

TEST(Playback, ANewFrameTimeChangesTheRateOnly) {
  Playback playback = make_playing(100);
  playback.advance(1.5 * kFrameTimeS);
  playback.set_clip(100, 2 * kFrameTimeS);
  playback.advance(kFrameTimeS);
  EXPECT_EQ(playback.position(), 2.0);
}

}  // namespace
}  // namespace marey::test
