#include "core/biomechanics/plausibility.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>

#include "core/document/document.h"
#include "tests/core/biomechanics/body_fixtures.h"
#include "tests/core/kinematics/figures.h"

namespace marey::test {
namespace {

using testing::HasSubstr;

// A uniform rod of 1 m that swings from the horizontal, by RK4: theta'' = -3 g / 2 L sin(theta).
Clip swinging_rod(double rate_hz, double told_rate_hz) {
  const Skeleton skeleton = figures::make_skeleton({{"Rod", kNoParent, glm::dvec3(0.0), figures::channels("Z"), {glm::dvec3(0, -1, 0)}}});
  std::vector<double> angles;
  double angle = 1.5;
  double speed = 0.0;
  const auto pull = [](double a) { return -1.5 * 9.81 * std::sin(a); };
  const int steps = 20;
  const double h = 1.0 / rate_hz / steps;
  for (int i = 0; i < 200 * steps; ++i) {
    if (i % steps == 0) angles.push_back(angle);
    const double k1 = pull(angle);
    const double k2 = pull(angle + 0.5 * h * speed);
    const double k3 = pull(angle + 0.5 * h * speed + 0.25 * h * h * k1);
    const double k4 = pull(angle + h * speed + 0.5 * h * h * k2);
    angle += h * speed + h * h / 6.0 * (k1 + k2 + k3);
    speed += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
  return make_moving(skeleton, 200, told_rate_hz, [&](FrameIndex frame, ChannelIndex) { return angles[idx(frame)] * 180.0 / 3.14159265358979323846; });
}

BodyModel rod_model() {
  BodyModel model;
  model.segments = {{0, 2.0, glm::dvec3(0, -0.5, 0), symmetric_tensor(std::array{2.0 / 12.0, 0.0, 2.0 / 12.0, 0.0, 0.0, 0.0})}};
  return model;
}

TEST(Plausibility, FindsTheFrameTimeOfAFreeSwing) {
  const auto right = judge(swinging_rod(100.0, 100.0), rod_model(), {});
  ASSERT_TRUE(right);
  EXPECT_NEAR(*right->best_frame_time_s, 0.01, 2e-5);
  EXPECT_LT(right->energy_change, 0.01);
  const auto slow = judge(swinging_rod(100.0, 30.0), rod_model(), {});
  EXPECT_NEAR(*slow->best_frame_time_s, 0.01, 2e-5);
  EXPECT_GT(slow->energy_change, 0.5);
  EXPECT_THAT(describe(*slow, 1.0 / 30.0)[1], HasSubstr("With 0.0100 s a frame instead of 0.0333 s"));
}

// Shared theory, section 7: the printed 0.033333 s is too short for the gymnast.
TEST(Plausibility, FindsThatTheGymnastIsTooFast) {
  const auto found = judge(make_gymnast(), make_gymnast_model(), {});
  ASSERT_TRUE(found && found->best_frame_time_s);
  EXPECT_NEAR(*found->best_frame_time_s, 0.0688, 0.001);
}

// A ball that is thrown: its centre of mass falls as it should with the right unit only.
TEST(Plausibility, KnowsAFall) {
  const Skeleton skeleton = figures::make_skeleton({{"Ball", kNoParent, glm::dvec3(0.0), figures::channels("xyz"), {glm::dvec3(0, -0.1, 0)}}});
  const auto height = [](FrameIndex frame) { return 2.0 + 6.0 * frame / 60.0 - 0.5 * 9.81 * frame / 60.0 * frame / 60.0; };
  Clip clip = make_moving(skeleton, 60, 60.0, [&](FrameIndex frame, ChannelIndex channel) { return channel == 1 ? height(frame) : 0.0; });
  BodyModel model;
  model.segments = {{0, 1.0, glm::dvec3(0.0), symmetric_tensor(std::array{0.1, 0.1, 0.1, 0.0, 0.0, 0.0})}};
  const auto found = judge(clip, model, {});
  ASSERT_TRUE(found && found->fall_mps2);
  EXPECT_NEAR(*found->fall_mps2, 9.81, 0.01);
  clip.settings.metres_per_unit = 0.5;
  EXPECT_NEAR(*judge(clip, model, {})->fall_mps2, 4.905, 0.01);
  EXPECT_THAT(describe(*judge(clip, model, {}), 1.0 / 60.0)[1], HasSubstr("instead of 9.8"));
}

}  // namespace
}  // namespace marey::test
