#include "wasm/app/picking.h"

#include <gtest/gtest.h>

#include <vector>

namespace marey::app {
namespace {

const glm::dvec2 kSize(800.0, 600.0);
const glm::dvec2 kMiddle = 0.5 * kSize;
const Box kRoom{glm::dvec3(-50.0), glm::dvec3(50.0)};

// Looks at the origin from +Z, 30 file units above and below it, so that one file unit there is 10 pixels.
CameraView front_view(double perspective) {
  return CameraView({{0, 0, 0}, 30.0, 0.0, 0.0, perspective}, Axis::Y, kSize, kRoom);
}

class Picking : public testing::TestWithParam<double> {
 protected:
  CameraView view_ = front_view(GetParam());
};

TEST_P(Picking, FindsBonesAndBalls) {
  const std::vector<PickSolid> solids{{{-10, 0, 0}, {10, 0, 0}, 1.0, 3}, {{0, 20, 0}, {0, 20, 0}, 2.0, 5}};
  EXPECT_EQ(pick_joint(solids, view_, kMiddle, 0.0), 3);
  EXPECT_EQ(pick_joint(solids, view_, kMiddle + glm::dvec2(95, 9), 0.0), 3);
  EXPECT_EQ(pick_joint(solids, view_, kMiddle + glm::dvec2(0, -185), 0.0), 5);
  EXPECT_EQ(pick_joint(solids, view_, kMiddle + glm::dvec2(0, 100), 0.0), kNoParent);
  EXPECT_EQ(pick_joint({}, view_, kMiddle, 100.0), kNoParent);
}

TEST_P(Picking, TakesTheNearestToTheEye) {
  const std::vector<PickSolid> solids{{{-10, 0, -5}, {10, 0, -5}, 1.0, 1}, {{-10, 0, 5}, {10, 0, 5}, 1.0, 2}};
  EXPECT_EQ(pick_joint(solids, view_, kMiddle, 0.0), 2);
}

TEST_P(Picking, ABallBeforeTheBoneThatEndsInIt) {
  const std::vector<PickSolid> solids{{{-10, 0, 0}, {0, 0, 0}, 1.0, 1}, {{0, 0, 0}, {0, 0, 0}, 1.5, 2}};
  EXPECT_EQ(pick_joint(solids, view_, kMiddle, 0.0), 2);
}

TEST_P(Picking, ToleranceIsInPixelsAndTakesTheClosest) {
  const std::vector<PickSolid> solids{{{-10, 3, 0}, {10, 3, 0}, 1.0, 1}, {{-10, -4, 0}, {10, -4, 0}, 1.0, 2}};
  EXPECT_EQ(pick_joint(solids, view_, kMiddle, 15.0), kNoParent);
  EXPECT_EQ(pick_joint(solids, view_, kMiddle, 21.0), 1);
  EXPECT_EQ(pick_joint(solids, view_, kMiddle, 50.0), 1);
}

TEST_P(Picking, AHitBeatsANearMiss) {
  const std::vector<PickSolid> solids{{{-10, 3, 20}, {10, 3, 20}, 1.0, 1}, {{-10, 0, 0}, {10, 0, 0}, 1.0, 2}};
  EXPECT_EQ(pick_joint(solids, view_, kMiddle, 200.0), 2);
}

TEST_P(Picking, ABoneTowardsTheEyeIsHitAtItsNearEnd) {
  const std::vector<PickSolid> solids{{{0, 0, -10}, {0, 0, 10}, 1.0, 1}, {{-9, 0, 8}, {9, 0, 8}, 1.0, 2}};
  EXPECT_EQ(pick_joint(solids, view_, kMiddle, 0.0), 1);
}

INSTANTIATE_TEST_SUITE_P(Views, Picking, testing::Values(0.0, 1.0));

TEST(PickingBehindTheEye, FindsNothing) {
  const CameraView view = front_view(1.0);
  const glm::dvec3 behind = view.eye() + view.axes().back * 10.0;
  const std::vector<PickSolid> solids{{behind, behind, 5.0, 1}};
  EXPECT_EQ(pick_joint(solids, view, kMiddle, 1000.0), kNoParent);
}

}  // namespace
}  // namespace marey::app
