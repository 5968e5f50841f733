// Mechanics against an engine that knows nothing of it: MuJoCo, by random figures with random masses in random motion.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iostream>

#include "tests/mujoco/inverse_comparison.h"
#include "tests/mujoco/mujoco_state.h"

namespace marey::test {
namespace {

BodyMotion motion_of(const RandomBody& body) {
  return find_body_motion(body.clip, {}, body.clip.motion.frame_time_s(), body.clip.settings.metres_per_unit).value();
}

std::vector<JointTrack> tracks_of(const RandomBody& body) {
  return find_joint_tracks(body.clip, {}, body.clip.motion.frame_time_s(), body.clip.settings.metres_per_unit).value();
}

void report(std::string_view state, const InverseDeviations& deviations) {
  report(fmt::format("{}, movement", state), deviations.movement);
  report(fmt::format("{}, the body as a whole", state), deviations.whole);
  report(fmt::format("{}, loads", state), deviations.loads);
}

void expect_at_most(const InverseDeviations& deviations, double most) {
  for (const Deviations* group : {&deviations.movement, &deviations.whole, &deviations.loads}) expect_at_most(*group, most);
}

// From the same state nothing but rounding differs. From the same samples each makes its own rotations and differences of them,
// and the differences divide the rounding by the square of the frame time.
TEST(Mujoco, FindsTheSame) {
  InverseDeviations of_state;
  InverseDeviations of_samples;
  int joints = 0;
  const int cases = body_cases();
  for (int i = 0; i < cases; ++i) {
    const RandomBody body = body_of_case(i);
    const BodyMotion motion = motion_of(body);
    const MujocoFigure figure(body.clip, body.model, body.gravity_mps2);
    find_inverse(figure, state_of_tracks(figure, body.clip, tracks_of(body), kMiddleFrame));
    compare_inverse(body, motion, figure, i, of_state);
    find_inverse(figure, state_of_samples(figure, body.clip, kMiddleFrame));
    compare_inverse(body, motion, figure, i, of_samples);
    joints += motion.joint_count;
  }
  expect_at_most(of_state, 1e-11);
  expect_at_most(of_samples, 1e-9);
  std::cout << fmt::format("{} bodies of {} joints compared with MuJoCo {}\n", cases, joints, mj_versionString());
  report("same state", of_state);
  report("same samples", of_samples);
}

// A joint with one rotation channel turns about its axis and no other, however it is differentiated.
TEST(Mujoco, HingesKeepTheirAxis) {
  Spread off;
  int hinges = 0;
  for (int i = 0; i < 200; ++i) {
    const RandomBody body = body_of_case(i);
    const std::vector<JointTrack> tracks = tracks_of(body);
    for (const Freedom& freedom : find_freedoms(body.clip.skeleton)) {
      if (freedom.kind != FreedomKind::Hinge) continue;
      ++hinges;
      const JointTrack& track = tracks[idx(freedom.joint)];
      for (const glm::dvec3& found : {track.angular_velocities[kMiddleFrame], track.angular_accelerations[kMiddleFrame]}) {
        glm::dvec3 along(0.0);
        along[static_cast<int>(freedom.axis)] = found[static_cast<int>(freedom.axis)];
        off.add(found, along);
      }
    }
  }
  EXPECT_GT(hinges, 200);
  EXPECT_EQ(off.relative(), 0.0);
}

// The comparison is worth something only if it sees what is small: a millionth more mass, or another tensor.
TEST(Mujoco, SeesAMillionth) {
  for (int i = 0; i < 50; ++i) {
    RandomBody body = body_of_case(i);
    const BodyMotion motion = motion_of(body);
    const MujocoFigure figure(body.clip, body.model, body.gravity_mps2);
    find_inverse(figure, state_of_tracks(figure, body.clip, tracks_of(body), kMiddleFrame));
    Segment& segment = body.model.segments.back();
    segment.inertia_kgm2 *= 1.000001;
    InverseDeviations deviations;
    compare_inverse(body, motion, figure, i, deviations);
    EXPECT_GT(deviations.whole.largest("kinetic energy"), 1e-12) << i;
    segment.mass_kg *= 1.000001;
    compare_inverse(body, motion, figure, i, deviations);
    EXPECT_GT(deviations.loads.largest("force"), 1e-10) << i;
  }
}

TEST(RandomBodies, AreOfAllKinds) {
  std::array<int, 4> freedoms{};
  int welded = 0;
  int without_mass = 0;
  int with_several = 0;
  int forked = 0;
  int several_roots = 0;
  for (int i = 0; i < 200; ++i) {
    const RandomBody body = body_of_case(i);
    const Skeleton& skeleton = body.clip.skeleton;
    EXPECT_TRUE(check_body_model(body.model, skeleton));
    for (const Freedom& freedom : find_freedoms(skeleton)) ++freedoms[static_cast<std::size_t>(freedom.kind)];
    const auto parents = skeleton.parents();
    several_roots += std::count(parents.begin(), parents.end(), kNoParent) > 1 ? 1 : 0;
    for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
      const auto segments = std::count_if(body.model.segments.begin(), body.model.segments.end(),
                                          [&](const Segment& segment) { return segment.joint == joint; });
      welded += skeleton.channel_count(joint) == 0 ? 1 : 0;
      without_mass += segments == 0 ? 1 : 0;
      with_several += segments > 1 ? 1 : 0;
      forked += std::count(parents.begin(), parents.end(), joint) > 1 ? 1 : 0;
    }
  }
  for (const int count : freedoms) EXPECT_GT(count, 50);
  for (const int count : {welded, without_mass, with_several, forked}) EXPECT_GT(count, 50);
  EXPECT_GT(several_roots, 10);
}

}  // namespace
}  // namespace marey::test
