#include "core/biomechanics/rate_check.h"

#include <fmt/format.h>

#include <cmath>

#include "core/math/rotation_vector.h"

namespace marey {
namespace {

constexpr double kMostVelocityError = 0.1;
constexpr double kMostAccelerationError = 0.2;
constexpr double kNoiseShare = 0.4;
constexpr int kMostStates = 20'000;  // that are looked at: more would only cost time

/// How a joint turns to the frames `step` before and behind: first and second derivative, in units of frames.
struct Turning {
  glm::dvec3 velocity{0.0};
  glm::dvec3 acceleration{0.0};
};

Turning turning(const BodyMotion& body, FrameIndex frame, JointIndex joint, int step) {
  const glm::dquat back = glm::conjugate(body.state(frame, joint).rotation);
  const glm::dvec3 behind = rotation_vector(body.state(frame + step, joint).rotation * back);
  const glm::dvec3 before = rotation_vector(body.state(frame - step, joint).rotation * back);
  const double frames = step;
  return {(behind - before) / (2.0 * frames), (behind + before) / (frames * frames)};
}

double share(double part, double whole) { return whole > 0.0 ? std::sqrt(part / whole) : 0.0; }

double squared(const glm::dvec3& v) { return glm::dot(v, v); }

}  // namespace

RateCheck check_rate(const BodyMotion& body) {
  double velocity = 0.0;
  double velocity_change = 0.0;
  double acceleration = 0.0;
  double acceleration_change = 0.0;
  double coarse = 0.0;
  const int stride = 1 + size_of(body.states) / kMostStates;
  for (FrameIndex frame = 2; frame + 2 < body.frame_count; frame += stride) {
    for (JointIndex joint = 0; joint < body.joint_count; ++joint) {
      const Turning fine = turning(body, frame, joint, 1);
      const Turning wide = turning(body, frame, joint, 2);
      velocity += squared(fine.velocity);
      velocity_change += squared(wide.velocity - fine.velocity);
      acceleration += squared(fine.acceleration);
      acceleration_change += squared(wide.acceleration - fine.acceleration);
      coarse += squared(wide.acceleration);
    }
  }
  constexpr double kOfTheFiner = 1.0 / 3.0;
  return {kOfTheFiner * share(velocity_change, velocity), kOfTheFiner * share(acceleration_change, acceleration),
          acceleration > 0.0 ? share(coarse, acceleration) : 1.0};
}

std::string describe_rate(const RateCheck& check, double frame_time_s, bool with_accelerations) {
  const double rate_hz = 1.0 / frame_time_s;
  if (with_accelerations && check.acceleration_error > kMostAccelerationError && check.coarse_share < kNoiseShare) {
    return "Most of the accelerations is noise: smooth the motion, by a cut-off or a spline.";
  }
  if (check.velocity_error > kMostVelocityError) {
    return fmt::format("{:.4g} frames a second do not carry the velocities: they are off by about {:.0f} %, accelerations by more.", rate_hz,
                       100.0 * check.velocity_error);
  }
  if (with_accelerations && check.acceleration_error > kMostAccelerationError) {
    return fmt::format("{:.4g} frames a second do not carry the accelerations: they are off by about {:.0f} %.", rate_hz,
                       100.0 * check.acceleration_error);
  }
  return {};
}

}  // namespace marey
