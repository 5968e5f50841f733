#include "core/biomechanics/motion_events.h"

#include <gtest/gtest.h>

#include "tests/core/kinematics/figures.h"

namespace marey::test {
namespace {

using Kind = MotionEvent::Kind;

TEST(MotionEvents, AreTheChangesOfContacts) {
  Contacts contacts;
  contacts.points = {{0, glm::dvec3(0.0), 1}, {0, glm::dvec3(0.0), 2}};
  contacts.down = {1, 0, 1, 1, 0, 1, 0, 0, 0, 0, 0, 1};
  const std::vector<MotionEvent> expected = {{1, Kind::Touches, 2},         {2, Kind::Leaves, 1},  {3, Kind::Leaves, 2},
                                             {3, Kind::FlightBegins, kNoParent}, {5, Kind::Touches, 2}, {5, Kind::FlightEnds, kNoParent}};
  EXPECT_EQ(find_events(contacts), expected);
  EXPECT_TRUE(find_events({}).empty());
}

TEST(MotionEvents, HaveWords) {
  const Skeleton skeleton = figures::make_skeleton({{"Hips", kNoParent, glm::dvec3(0.0), figures::channels("ZXY"), {glm::dvec3(0, -1, 0)}}});
  EXPECT_EQ(describe({3, Kind::Touches, 1}, skeleton), "Hips_end touches");
  EXPECT_EQ(describe({3, Kind::Leaves, 1}, skeleton), "Hips_end leaves the ground");
  EXPECT_EQ(describe({3, Kind::FlightBegins, kNoParent}, skeleton), "flight begins");
  EXPECT_EQ(describe({3, Kind::FlightEnds, kNoParent}, skeleton), "flight ends");
}

}  // namespace
}  // namespace marey::test
