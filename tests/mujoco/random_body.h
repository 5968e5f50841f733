#pragma once

#include "core/biomechanics/body_model.h"
#include "core/motion/clip.h"
#include "tests/support/random.h"

namespace marey::test {

/// A figure with masses, in motion, and the gravity it is in.
struct RandomBody {
  Clip clip;  ///< kRandomFrames frames at 60 ... 240 Hz, in some unit of length
  BodyModel model;
  glm::dvec3 gravity_mps2{0.0};
};

inline constexpr int kRandomFrames = 5;
inline constexpr FrameIndex kMiddleFrame = kRandomFrames / 2;

/// 1 ... 20 joints that branch at random, now and then below several roots. A root is free (three positions) or pinned, another
/// joint may slide in its parent; rotation channels: 0 (not at a root) ... 3 in any order. Offsets up to 0.5 m a coordinate,
/// angles and positions that are sums of sines of 0.3 ... 3 Hz, gravity of 9.81 m/s2 in any direction.
/// A joint carries one segment, two or three, or, if it has children, none. Masses of 0.1 ... 20 kg about centres up to 0.3 m a
/// coordinate off the joint, with tensors of radii of gyration of 0.03 ... 0.3 m about axes of any direction.
[[nodiscard]] RandomBody make_random_body(Random& random);

/// Gives a segment to each joint that can turn and has none, so that nothing moves without mass.
void fill_turning_joints(Random& random, RandomBody& body);

/// The body of case 0, 1, ... and how many cases are wanted: MAREY_BODY_CASES, or 1000.
[[nodiscard]] RandomBody body_of_case(int which_case);
[[nodiscard]] int body_cases();

}  // namespace marey::test
