#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/bvh/reader.h"
#include "core/skeleton/skeleton_builder.h"
#include "tests/support/files.h"
#include "wasm/views/viewport/camera_control.h"
#include "wasm/views/viewport/figure_drawing.h"
#include "wasm/views/viewport/stage.h"

namespace marey::app {
namespace {

// A figure as the view holds it.
struct Figure {
  Session session;
  FigureCache cache;

  explicit Figure(Session opened) : session(std::move(opened)) { cache.update(session, 1); }
  [[nodiscard]] const Skeleton& skeleton() const { return session.document.skeleton(); }
};

std::optional<Figure> read_figure(const std::string& text) {
  Result<BvhClip> clip = read_bvh(text);
  if (!clip) return std::nullopt;
  return Figure(Session::open(std::move(*clip), "test.bvh"));
}

constexpr char kBody[] = R"(HIERARCHY
ROOT Hips { OFFSET 0 90 0 CHANNELS 3 Zrotation Xrotation Yrotation
  JOINT LeftUpLeg { OFFSET 9 0 0 CHANNELS 3 Zrotation Xrotation Yrotation
    JOINT LeftLeg { OFFSET 0 -44 0 CHANNELS 3 Zrotation Xrotation Yrotation End Site { OFFSET 0 -44 0 } } }
  JOINT RightUpLeg { OFFSET -9 0 0 CHANNELS 3 Zrotation Xrotation Yrotation
    JOINT RightLeg { OFFSET 0 -44 0 CHANNELS 3 Zrotation Xrotation Yrotation End Site { OFFSET 0 -44 0 } } }
  JOINT Spine { OFFSET 0 0 0 CHANNELS 3 Zrotation Xrotation Yrotation
    JOINT Head { OFFSET 0 60 0 CHANNELS 3 Zrotation Xrotation Yrotation End Site { OFFSET 0 20 0 } }
    JOINT LeftArm { OFFSET 20 50 0 CHANNELS 3 Zrotation Xrotation Yrotation
      JOINT LeftHand { OFFSET 55 0 0 CHANNELS 3 Zrotation Xrotation Yrotation
        JOINT LeftIndex { OFFSET 9 0 0 CHANNELS 3 Zrotation Xrotation Yrotation End Site { OFFSET 3 0 0 } } } } } }
MOTION Frames: 1 Frame Time: 0.1
)";

std::string body_text() {
  std::string text = kBody;
  for (int i = 0; i < 30; ++i) text += "0 ";
  return text;
}

const FigureBone* find_bone(const Figure& figure, std::string_view to) {
  for (const FigureBone& bone : figure.cache.shape().bones) {
    if (figure.skeleton().node(bone.to).name == to) return &bone;
  }
  return nullptr;
}

TEST(FigureShape, LimbsAreThickAndFingersThin) {
  const auto figure = read_figure(body_text());
  ASSERT_TRUE(figure);
  const FigureBone* thigh = find_bone(*figure, "LeftLeg");
  const FigureBone* finger = find_bone(*figure, "LeftIndex");
  ASSERT_NE(thigh, nullptr);
  ASSERT_NE(finger, nullptr);
  EXPECT_GT(thigh->radius, 2.0 * finger->radius);
  EXPECT_LT(thigh->radius, 0.2 * 44.0);
  EXPECT_EQ(thigh->side, BodySide::Left);
  EXPECT_EQ(thigh->joint, 1) << "the upper leg turns it";
}

TEST(FigureShape, BonesWithoutLengthAreLeftOut) {
  const auto figure = read_figure(body_text());
  ASSERT_TRUE(figure);
  EXPECT_EQ(find_bone(*figure, "Spine"), nullptr);
  EXPECT_EQ(size_of(figure->cache.shape().bones), figure->skeleton().node_count() - 2);
}

TEST(FigureShape, JointsInOnePlaceShareABall) {
  const auto figure = read_figure(body_text());
  ASSERT_TRUE(figure);
  const auto& balls = figure->cache.shape().balls;
  const auto& positions = figure->cache.pose().world_positions;
  for (const FigureBall& a : balls) {
    for (const FigureBall& b : balls) {
      if (&a == &b || a.radius != b.radius) continue;
      EXPECT_GT(glm::distance(positions[idx(a.node)], positions[idx(b.node)]), 0.0);
    }
  }
}

TEST(FigureShape, AHeadIsRound) {
  const auto figure = read_figure(body_text());
  ASSERT_TRUE(figure);
  int heads = 0;
  for (const FigureBall& ball : figure->cache.shape().balls) heads += ball.is_head;
  EXPECT_EQ(heads, 1);
}

// A root at the origin of the room with the body below it that has its own position.
TEST(FigureShape, TheWayFromTheOriginIsNoBone) {
  const auto figure = read_figure(R"(HIERARCHY ROOT Reference { OFFSET 0 0 0 CHANNELS 3 Zrotation Xrotation Yrotation
    JOINT Hips { OFFSET 0 0 0 CHANNELS 3 Xposition Yposition Zposition
      JOINT Spine { OFFSET 0 50 0 CHANNELS 3 Zrotation Xrotation Yrotation End Site { OFFSET 0 50 0 } } } }
    MOTION Frames: 1 Frame Time: 0.1
    0 0 0 300 90 0 0 0 0)");
  ASSERT_TRUE(figure);
  EXPECT_EQ(figure->cache.shape().tethers.size(), 1u);
  EXPECT_EQ(figure->cache.shape().bones.size(), 2u);
}

TEST(FigureShape, AFigureWithoutOffsetsTakesItsSizeFromThePose) {
  const auto figure = read_figure(R"(HIERARCHY ROOT A { OFFSET 0 0 0 CHANNELS 3 Xposition Yposition Zposition
    JOINT B { OFFSET 0 0 0 CHANNELS 3 Xposition Yposition Zposition End Site { OFFSET 0 0 0 } } }
    MOTION Frames: 1 Frame Time: 0.1
    0 0 0 0 12 0)");
  ASSERT_TRUE(figure);
  EXPECT_EQ(figure->cache.shape().size, 12.0);
  EXPECT_EQ(figure->cache.shape().bones.size(), 1u);
}

void expect_sound(const FigureCache& cache, const Scene& scene, const std::string& path) {
  for (const FigureBone& bone : cache.shape().bones) {
    EXPECT_GT(bone.radius, 0.0) << path;
    EXPECT_LE(bone.radius, 0.06 * cache.shape().size) << path;
  }
  for (const SceneBone& bone : scene.bones) {
    const glm::vec3 along = bone.to - bone.from;
    EXPECT_GT(glm::length(along), 0.0f) << path;
    EXPECT_NEAR(glm::length(bone.side), 1.0f, 1e-3f) << path;
    EXPECT_LT(std::abs(glm::dot(bone.side, glm::normalize(along))), 1e-3f) << path;
  }
}

TEST(FigureDrawing, RecordedFiguresAreSound) {
  int files = 0;
  for (const std::string& path : test::recorded_bvh_files()) {
    const auto text = test::read_shared_file(path);
    const auto figure = text ? read_figure(*text) : std::nullopt;
    if (!figure) continue;
    Scene scene;
    add_figure(figure->cache.shape(), figure->cache.pose(), figure->session.selection, kNoParent,
               make_theme(ThemeKind::Dark), scene);
    expect_sound(figure->cache, scene, path);
    EXPECT_EQ(scene.bones.size(), figure->cache.shape().bones.size()) << path;
    EXPECT_GT(figure->cache.stage().cell, 0.0) << path;
    ++files;
  }
  if (files == 0) GTEST_SKIP() << "no recorded files here";
  RecordProperty("files", files);
  EXPECT_GT(files, 40);
}

TEST(FigureDrawing, SelectedJointsAreOutlinedAndHoveredOnesLighter) {
  const auto figure = read_figure(body_text());
  ASSERT_TRUE(figure);
  const Theme theme = make_theme(ThemeKind::Dark);
  Selection selection(figure->skeleton());
  Scene plain;
  add_figure(figure->cache.shape(), figure->cache.pose(), selection, kNoParent, theme, plain);
  EXPECT_TRUE(plain.outlined_bones.empty());
  selection.select_only(1);
  Scene selected;
  add_figure(figure->cache.shape(), figure->cache.pose(), selection, 1, theme, selected);
  ASSERT_EQ(selected.outlined_bones.size(), 1u);
  EXPECT_EQ(selected.outlined_bones[0].color, scene_color(theme.selection));
  EXPECT_EQ(selected.outlined_balls.size(), 1u);
  int lighter = 0;
  for (std::size_t i = 0; i < plain.bones.size(); ++i) {
    lighter += glm::length(glm::vec3(selected.bones[i].color)) > glm::length(glm::vec3(plain.bones[i].color));
  }
  EXPECT_EQ(lighter, 1);
}

TEST(FigureDrawing, WhatIsNoNumberIsNotDrawn) {
  auto figure = read_figure(body_text());
  ASSERT_TRUE(figure);
  WorldPose pose = figure->cache.pose();
  pose.world_positions[2].x = std::numeric_limits<double>::quiet_NaN();
  Scene scene;
  add_figure(figure->cache.shape(), pose, figure->session.selection, kNoParent, make_theme(ThemeKind::Dark), scene);
  EXPECT_EQ(scene.bones.size(), figure->cache.shape().bones.size() - 2);
  for (const SceneBall& ball : scene.balls) EXPECT_TRUE(std::isfinite(ball.center.x));
}

TEST(Stage, CellsAreRound) {
  EXPECT_DOUBLE_EQ(rounded_down_125(1.0), 1.0);
  EXPECT_DOUBLE_EQ(rounded_down_125(1.99), 1.0);
  EXPECT_DOUBLE_EQ(rounded_down_125(30.6), 20.0);
  EXPECT_DOUBLE_EQ(rounded_down_125(0.0072), 0.005);
  EXPECT_DOUBLE_EQ(rounded_down_125(1e6), 1e6);
}

// Both clips that the page must show alike: a gymnast of 38 units on a bar, and a walk over many of its own heights.
TEST(OpeningView, ShowsAWholeSwingAcrossItsPlane) {
  const auto figure = read_figure(test::read_shared_file("oracle/gymnast_corrected.bvh").value_or(""));
  if (!figure) GTEST_SKIP() << "no recorded files here";
  EXPECT_FALSE(figure->cache.stage().travels);
  const CameraPose pose = opening_pose(figure->session, figure->cache, 1.4, 1.0);
  EXPECT_LT(std::abs(std::sin(pose.yaw_rad)), 0.5);
  EXPECT_GT(pose.half_height, 36.0);
  EXPECT_LT(pose.half_height, 60.0);
}

TEST(OpeningView, KeepsATravellingFigureLarge) {
  const auto figure = read_figure(test::read_shared_file("bvh/pybvh/cmu_12_01_walk.bvh").value_or(""));
  if (!figure) GTEST_SKIP() << "no recorded files here";
  EXPECT_TRUE(figure->cache.stage().travels);
  const CameraPose pose = opening_pose(figure->session, figure->cache, 1.4, 1.0);
  EXPECT_LT(pose.half_height, figure->cache.stage().size);
}

TEST(FollowedPoint, MovesEvenlyWithAWalk) {
  auto figure = read_figure(R"(HIERARCHY ROOT A { OFFSET 0 0 0 CHANNELS 3 Xposition Yposition Zposition
    End Site { OFFSET 0 10 0 } } MOTION Frames: 5 Frame Time: 0.1
    0 5 0 10 6 0 20 5 0 30 6 0 40 5 0)");
  ASSERT_TRUE(figure);
  for (double position = 0.0; position <= 4.0; position += 0.25) {
    figure->session.playback.set_position(position);
    const glm::dvec3 point = followed_point(figure->session, figure->cache.stage());
    EXPECT_NEAR(point.x, 10.0 * position, 1e-4) << "ends included";
    EXPECT_EQ(point.y, figure->cache.stage().ground_height);
  }
}

}  // namespace
}  // namespace marey::app
