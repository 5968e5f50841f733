#include "core/biomechanics/joint_tracks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>

#include "core/biomechanics/body_motion.h"
#include "core/math/angle.h"
#include "tests/core/biomechanics/body_fixtures.h"

namespace marey::test {
namespace {

Skeleton one_joint(const std::string& letters) {
  return figures::make_skeleton({{"Body", kNoParent, glm::dvec3(0.0), figures::channels(letters), {glm::dvec3(0, 1, 0)}}});
}

BodyMotion motion_of(const Clip& clip, std::string_view method) {
  const Result<BodyMotion> body = find_body_motion(clip, *parse_derivation(method), clip.motion.frame_time_s(), 1.0);
  EXPECT_TRUE(body) << (body ? "" : body.error().message);
  return body ? *body : BodyMotion{};
}

/// R = Rz(2t) Rx(0.5) Rz(5t), and its angular velocity and acceleration (shared theory, section 4).
Clip make_spinning(double rate_hz) {
  return make_moving(one_joint("ZXZ"), static_cast<int>(rate_hz), rate_hz, [&](FrameIndex frame, ChannelIndex channel) {
    const double t = frame / rate_hz;
    return to_degrees(channel == 0 ? 2.0 * t : channel == 1 ? 0.5 : 5.0 * t);
  });
}
glm::dvec3 spinning_velocity(double t) {
  return glm::dvec3(0, 0, 2) + 5.0 * glm::dvec3(std::sin(2 * t) * std::sin(0.5), -std::cos(2 * t) * std::sin(0.5), std::cos(0.5));
}
glm::dvec3 spinning_acceleration(double t) { return 10.0 * std::sin(0.5) * glm::dvec3(std::cos(2 * t), std::sin(2 * t), 0); }

double largest_difference(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 difference = glm::abs(a - b);
  return std::max({difference.x, difference.y, difference.z});
}

TEST(JointTracks, RotationsAreDifferentiatedToSecondOrder) {
  EXPECT_NEAR(glm::distance(spinning_velocity(0.1), {0.47623575, -2.34934473, 6.38791281}), 0.0, 1e-8);
  const std::vector<std::array<double, 3>> kErrors = {
      {30, 1.07e-3, 3.9e-3}, {60, 2.66e-4, 9.6e-4}, {120, 6.65e-5, 2.4e-4}, {240, 1.66e-5, 6.1e-5}};
  for (const auto& [rate_hz, velocity_error, acceleration_error] : kErrors) {
    const BodyMotion body = motion_of(make_spinning(rate_hz), "central");
    double velocity = 0.0;
    double acceleration = 0.0;
    for (FrameIndex frame = 1; frame + 1 < body.frame_count; ++frame) {
      const double t = frame / rate_hz;
      velocity = std::max(velocity, largest_difference(body.state(frame, 0).angular_velocity, spinning_velocity(t)));
      acceleration = std::max(acceleration, largest_difference(body.state(frame, 0).angular_acceleration, spinning_acceleration(t)));
    }
    EXPECT_NEAR(velocity, velocity_error, 0.02 * velocity_error) << rate_hz;
    EXPECT_NEAR(acceleration, acceleration_error, 0.03 * acceleration_error) << rate_hz;
  }
}

TEST(JointTracks, FittedRotationsAreMoreExact) {
  for (const auto& [method, most] : {std::pair("savgol:9,6", 1e-5), std::pair("gcv", 1e-6)}) {
    const BodyMotion body = motion_of(make_spinning(120.0), method);
    for (FrameIndex frame = 12; frame + 12 < body.frame_count; ++frame) {
      EXPECT_LT(glm::distance(body.state(frame, 0).angular_velocity, spinning_velocity(frame / 120.0)), most) << method;
    }
  }
}

TEST(JointTracks, AnglesMayWrap) {
  const auto spin = [](bool wraps) {
    return make_moving(one_joint("Z"), 60, 30.0, [wraps](FrameIndex frame, ChannelIndex) {
      const double angle = 25.0 * frame;
      return wraps ? std::remainder(angle, 360.0) : angle;
    });
  };
  for (const char* method : {"central", "butterworth:6", "savgol:7,3", "gcv"}) {
    const BodyMotion wrapped = motion_of(spin(true), method);
    const BodyMotion whole = motion_of(spin(false), method);
    for (FrameIndex frame = 0; frame < 60; ++frame) {
      EXPECT_NEAR(glm::distance(wrapped.state(frame, 0).angular_velocity, whole.state(frame, 0).angular_velocity), 0.0, 1e-6) << method;
    }
    for (FrameIndex frame = 4; frame < 56; ++frame) {
      EXPECT_NEAR(whole.state(frame, 0).angular_velocity.z, to_radians(750.0), 0.05) << method << " " << frame;
    }
  }
}

// The signal of the accuracy table of the shared theory, section 4, as the angle of a hinge.
constexpr double kRate_hz = 100.0;
constexpr double kTurn = 2.0 * std::numbers::pi;
double angle_at(double t) { return std::sin(kTurn * t) + 0.3 * std::sin(3 * kTurn * t + 0.5); }
double velocity_at(double t) { return kTurn * std::cos(kTurn * t) + 0.9 * kTurn * std::cos(3 * kTurn * t + 0.5); }
double acceleration_at(double t) { return -kTurn * kTurn * (std::sin(kTurn * t) + 2.7 * std::sin(3 * kTurn * t + 0.5)); }

Clip make_noisy_hinge(double noise) {
  std::vector<double> samples;
  std::uint32_t state = 12345;
  for (int i = 0; i < 200; ++i) {
    state = 1664525u * state + 1013904223u;
    samples.push_back(to_degrees(angle_at(i / kRate_hz) + noise * std::sqrt(3.0) * (2.0 * (state / 4294967296.0) - 1.0)));
  }
  return make_moving(one_joint("Z"), 200, kRate_hz, [&](FrameIndex frame, ChannelIndex) { return samples[idx(frame)]; });
}

double rms_over_middle(const std::function<double(FrameIndex)>& error) {
  double sum = 0.0;
  for (FrameIndex frame = 10; frame < 190; ++frame) sum += error(frame) * error(frame);
  return std::sqrt(sum / 180.0);
}

TEST(JointTracks, HaveTheErrorsOfTheAccuracyTable) {
  struct Expected {
    const char* method;
    double noise, velocity, acceleration, part;
  };
  for (const Expected& expected : {Expected{"central", 0.0, 0.02365, 0.2213, 0.001}, Expected{"central", 0.005, 0.3636, 123.05, 0.001},
                                   Expected{"savgol:15,4", 0.005, 0.0663, 4.610, 0.002}, Expected{"savgol:21,4", 0.005, 0.1112, 2.284, 0.002},
                                   Expected{"savgol:25,5", 0.005, 0.0475, 2.685, 0.002},
                                   // The table filters angles; here quaternions are, which is the same for small turns only.
                                   Expected{"butterworth:6", 0.005, 0.1261, 2.492, 0.25}, Expected{"butterworth:7", 0.005, 0.0871, 2.443, 0.25},
                                   Expected{"gcv", 0.005, 0.0471, 2.097, 0.25},
                                   // Not of the table: told the noise, the spline is as good as by cross-validation.
                                   Expected{"spline:0.286479,1", 0.005, 0.0471, 2.097, 0.25}}) {
    const BodyMotion body = motion_of(make_noisy_hinge(expected.noise), expected.method);
    const double velocity = rms_over_middle([&](FrameIndex f) { return body.state(f, 0).angular_velocity.z - velocity_at(f / kRate_hz); });
    const double acceleration =
        rms_over_middle([&](FrameIndex f) { return body.state(f, 0).angular_acceleration.z - acceleration_at(f / kRate_hz); });
    EXPECT_NEAR(velocity, expected.velocity, expected.part * expected.velocity) << expected.method;
    EXPECT_NEAR(acceleration, expected.acceleration, expected.part * expected.acceleration) << expected.method;
  }
}

// Joints that slide along their parents have Coriolis terms: the world positions, differentiated, say the same.
TEST(BodyMotion, IsTheDerivativeOfTheWorldPositions) {
  constexpr double kRate = 2000.0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Skeleton skeleton = figures::make_random_skeleton(6, seed);
    const Clip clip = make_moving(skeleton, 12, kRate, [&](FrameIndex frame, ChannelIndex channel) {
      const double phase = 1.7 * channel + 0.3 * seed;
      return 30.0 * std::sin(2.0 * frame / kRate + phase);
    });
    const BodyMotion body = motion_of(clip, "central");
    for (FrameIndex frame = 2; frame < 10; ++frame) {
      for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
        const auto at = [&](int step) { return body.state(frame + step, joint).position; };
        const glm::dvec3 velocity = (at(1) - at(-1)) * (0.5 * kRate);
        const glm::dvec3 acceleration = (at(1) - 2.0 * at(0) + at(-1)) * (kRate * kRate);
        EXPECT_NEAR(glm::distance(velocity, body.state(frame, joint).velocity), 0.0, 1e-3) << seed;
        EXPECT_NEAR(glm::distance(acceleration, body.state(frame, joint).acceleration), 0.0, 2e-2) << seed;
      }
    }
  }
}

TEST(Derivation, KnowsHowFarEndsReach) {
  const auto reach = [](std::string_view text) { return uncertain_end_frames(*parse_derivation(text), 60.0); };
  EXPECT_EQ(reach("central"), 1);
  EXPECT_EQ(reach("butterworth:6"), 10);
  EXPECT_EQ(reach("savgol:7,3"), 3);
  EXPECT_EQ(reach("gcv"), 6);
}

TEST(JointTracks, RefuseGaps) {
  Clip clip = make_spinning(30.0);
  clip.motion.channel_samples(0)[4] = std::nan("");
  const auto tracks = find_joint_tracks(clip, {}, 1.0 / 30.0, 1.0);
  ASSERT_FALSE(tracks);
  EXPECT_EQ(tracks.error().code, DiagnosticCode::NotFinite);
}

}  // namespace
}  // namespace marey::test
