#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <string>

#include "core/kinematics/forward_kinematics.h"
#include "tests/core/kinematics/figures.h"

namespace marey {
namespace {

using figures::channels;
using figures::positions_of;

// Two arms below a root, in every order; the oracle table of the theory sheet, section 1.5.
Skeleton make_orders_skeleton() {
  return figures::make_skeleton({{"Root", kNoParent, {1.0, 2.0, 3.0}, channels("xyzZYX"), {}},
                                 {"A", 0, {10.0, 0.0, 0.0}, channels("XYZ"), {}},
                                 {"B", 1, {0.0, 5.0, 0.0}, channels("xyzYZX"), {}},
                                 {"C", 2, {0.0, 0.0, 4.0}, channels("ZXY"), {{1.0, 2.0, 3.0}}},
                                 {"D", 0, {-10.0, 0.0, 0.0}, channels("XZY"), {}},
                                 {"E", 4, {0.0, -5.0, 0.0}, channels("YXZ"), {{1.0, 2.0, 3.0}}}});
}

Motion make_orders_motion() {
  return figures::make_motion({{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0},
                               {1.5, 2.5, 3.5, 30, 20, 10, 30, 20, 10, 0.5, 5.25, -0.75,
                                30,  20,  10,  30, 20, 10, 30, 20, 10, 30,  20,   10}},
                              0.04);
}

// Closed form of a chain in the plane: S = 10 u(a), H = S + 12 u(a + b), F = H + 16 u(a + b + c), u(t) = (-sin t, cos t).
TEST(KnownPositions, OfTheGiantSwingIsItsClosedForm) {
  const Motion swing = figures::make_giant_swing();
  const auto found = positions_of(figures::make_gymnast(), swing, PositionRule::Replace);
  for (FrameIndex frame = 0; frame < swing.frame_count(); ++frame) {
    double angle = 0.0;
    glm::dvec3 end(0.0);
    const double lengths[3] = {10.0, 12.0, 16.0};
    for (int link = 0; link < 3; ++link) {
      angle += glm::radians(swing.sample(3 + 3 * link, frame));
      end += lengths[link] * glm::dvec3(-std::sin(angle), std::cos(angle), 0.0);
      EXPECT_LT(glm::distance(found[idx(frame)][idx(link + 1)], end), 1e-13) << "frame " << frame << ", link " << link;
    }
  }
}

// Origin: theory sheet, section 7.2; equal in PyKDL, three.js, assimp and Blender.
TEST(KnownPositions, OfTheGiantSwingHasTheWorkedNumbers) {
  struct Row {
    FrameIndex frame;
    glm::dvec3 shoulder, hip, feet;
  };
  const Row rows[] = {
      {0, {-2.856884, 9.583226, 0.0}, {-7.661072, 20.579578, 0.0}, {-13.368880, 35.526850, 0.0}},
      {11, {4.305111, -9.025853, 0.0}, {11.576972, -18.571535, 0.0}, {18.641065, -32.927669, 0.0}},
      {22, {-0.575640, 9.983418, 0.0}, {-2.121187, 21.883472, 0.0}, {-4.706849, 37.673164, 0.0}},
  };
  const auto found = positions_of(figures::make_gymnast(), figures::make_giant_swing(), PositionRule::Replace);
  for (const Row& row : rows) {
    EXPECT_LT(glm::distance(found[idx(row.frame)][1], row.shoulder), 1e-6);
    EXPECT_LT(glm::distance(found[idx(row.frame)][2], row.hip), 1e-6);
    EXPECT_LT(glm::distance(found[idx(row.frame)][3], row.feet), 1e-6);
  }
}

TEST(KnownPositions, OfTheGiantSwingMatchTheOracleFile) {
  std::ifstream file(std::string(MAREY_SHARED_DIR) + "/oracle/gymnast_fk.csv");
  if (!file) GTEST_SKIP() << "no oracle/gymnast_fk.csv";
  const auto found = positions_of(figures::make_gymnast(), figures::make_giant_swing(), PositionRule::Replace);
  std::string line;
  std::getline(file, line);
  int rows = 0;
  while (std::getline(file, line)) {
    int frame = 0;
    glm::dvec3 points[3] = {};
    ASSERT_EQ(std::sscanf(line.c_str(), "%d,%lf,%lf,%lf,%lf,%lf,%lf", &frame, &points[0].x, &points[0].y, &points[1].x,
                          &points[1].y, &points[2].x, &points[2].y),
              7);
    for (int i = 0; i < 3; ++i) EXPECT_LT(glm::distance(found[idx(frame - 1)][idx(i + 1)], points[i]), 1e-6) << line;
    ++rows;
  }
  EXPECT_EQ(rows, 23);
}

// Origin: theory sheet, section 1.5; REPLACE equals Blender and assimp, ADD equals three.js.
TEST(KnownPositions, OfAllOrdersHasTheWorkedNumbers) {
  const std::vector<glm::dvec3> replaced = {
      {1.5, 2.5, 3.5},                     {9.637977, 7.198463, 0.079799},     {7.788150, 11.197282, 3.073557},
      {11.754105, 11.528656, 3.475289},    {14.797887, 13.177007, 4.895970},   {-6.637977, -2.198463, 6.920201},
      {-4.341237, -5.028474, 3.497334},    {-1.590870, -3.496355, 5.519237}};
  const std::vector<glm::dvec3> added = {
      {2.5, 4.5, 6.5},                     {10.637977, 9.198463, 3.079799},    {7.338492, 16.495481, 9.540598},
      {11.304448, 16.826855, 9.942331},    {14.348229, 18.475206, 11.363011},  {-5.637977, -0.198463, 9.920201},
      {-3.341237, -3.028474, 6.497334},    {-0.590870, -1.496355, 8.519237}};
  const Skeleton skeleton = make_orders_skeleton();
  const Motion motion = make_orders_motion();
  const auto found_replaced = positions_of(skeleton, motion, PositionRule::Replace)[1];
  const auto found_added = positions_of(skeleton, motion, PositionRule::Add)[1];
  ASSERT_EQ(found_added.size(), added.size());
  for (std::size_t i = 0; i < added.size(); ++i) {
    EXPECT_LT(glm::distance(found_replaced[i], replaced[i]), 2e-6) << i;
    EXPECT_LT(glm::distance(found_added[i], added[i]), 2e-6) << i;
  }
}

TEST(KnownPositions, PositionRuleHoldsPerAxis) {
  const Skeleton skeleton = figures::make_skeleton({{"slider", kNoParent, {1.0, 2.0, 3.0}, channels("y"), {}}});
  const Motion motion = figures::make_motion({{10.0}}, 0.1);
  EXPECT_EQ(positions_of(skeleton, motion, PositionRule::Replace)[0][0], glm::dvec3(1.0, 10.0, 3.0));
  EXPECT_EQ(positions_of(skeleton, motion, PositionRule::Add)[0][0], glm::dvec3(1.0, 12.0, 3.0));
}

TEST(KnownPositions, LastOfRepeatedPositionsReplacesAllAreAdded) {
  const Skeleton skeleton = figures::make_skeleton({{"slider", kNoParent, {1.0, 0.0, 0.0}, channels("xx"), {}}});
  const Motion motion = figures::make_motion({{10.0, 20.0}}, 0.1);
  EXPECT_EQ(positions_of(skeleton, motion, PositionRule::Replace)[0][0].x, 20.0);
  EXPECT_EQ(positions_of(skeleton, motion, PositionRule::Add)[0][0].x, 31.0);
}

TEST(KnownPositions, TakesAnglesOfAnySize) {
  const Skeleton skeleton = figures::make_skeleton({{"hinge", kNoParent, {}, channels("Z"), {{1.0, 0.0, 0.0}}}});
  const Motion motion = figures::make_motion({{2535.0}, {3.6e15}, {-3.6e300}, {HUGE_VAL}}, 0.1);
  const auto found = positions_of(skeleton, motion, PositionRule::Replace);
  EXPECT_LT(glm::distance(found[0][1], glm::dvec3(std::cos(glm::radians(15.0)), std::sin(glm::radians(15.0)), 0.0)), 1e-15);
  EXPECT_EQ(found[1][1], glm::dvec3(1.0, 0.0, 0.0));
  EXPECT_NEAR(glm::length(found[2][1]), 1.0, 1e-15);
  EXPECT_EQ(found[3][0], glm::dvec3(0.0));
  EXPECT_TRUE(std::isnan(found[3][1].x));
}

TEST(KnownPositions, ReachesTheEndOfALongChain) {
  std::vector<figures::JointPlan> chain;
  for (int i = 0; i < 2000; ++i) chain.push_back({"link", i - 1, {1.0, 0.0, 0.0}, channels("Z"), {}});
  const Skeleton skeleton = figures::make_skeleton(chain);
  Motion motion(2000, 70, 0.1);
  for (double& sample : motion.channel_samples(0)) sample = 90.0;
  const auto found = positions_of(skeleton, motion, PositionRule::Replace);
  EXPECT_LT(glm::distance(found[69][1999], glm::dvec3(1.0, 1999.0, 0.0)), 1e-9);
}

}  // namespace
}  // namespace marey
