#include "wasm/app/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

namespace marey::app {
namespace {

constexpr double kPi = std::numbers::pi;
const glm::dvec2 kSize(800.0, 600.0);

const Box kRoom{glm::dvec3(-100.0), glm::dvec3(100.0)};

CameraPose pose_with(double yaw_rad, double pitch_rad, double perspective = 1.0) {
  return {{3.0, 5.0, -2.0}, 20.0, yaw_rad, pitch_rad, perspective};
}

std::vector<CameraPose> poses() {
  std::vector<CameraPose> all;
  for (const double yaw : {0.0, 0.7, 2.0, -1.6}) {
    for (const double pitch : {-0.5 * kPi, -0.3, 0.0, 0.4, 0.5 * kPi}) {
      for (const double perspective : {0.0, 1.0}) all.push_back(pose_with(yaw, pitch, perspective));
    }
  }
  return all;
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double tolerance) {
  EXPECT_LE(glm::distance(a, b), tolerance) << a.x << ' ' << a.y << ' ' << a.z << " / " << b.x << ' ' << b.y << ' ' << b.z;
}

TEST(CameraView, FrontSeesWhatAFigureFaces) {
  for (const Axis up : {Axis::X, Axis::Y, Axis::Z}) {
    const ViewAxes axes = front_axes(up);
    expect_near(glm::cross(axes.right, axes.up), axes.back, 1e-12);
    EXPECT_EQ(axes.up[static_cast<int>(up)], 1.0);
  }
  const CameraView view({}, Axis::Y, kSize, kRoom);
  EXPECT_GT(view.eye().z, 0.0);
  const CameraView blender_view({}, Axis::Z, kSize, kRoom);
  EXPECT_LT(blender_view.eye().y, 0.0);
}

TEST(CameraView, TargetIsInTheMiddleAndHalfHeightReachesTheEdge) {
  for (const CameraPose& pose : poses()) {
    const CameraView view(pose, Axis::Y, kSize, kRoom);
    const auto middle = view.project(pose.target);
    ASSERT_TRUE(middle);
    EXPECT_LE(glm::distance(*middle, 0.5 * kSize), 1e-9);
    const auto edge = view.project(pose.target + view.axes().up * pose.half_height);
    ASSERT_TRUE(edge);
    EXPECT_NEAR(edge->y, 0.0, 1e-9);
  }
}

// The renderer's matrices and the overlay's projection put a point into the same place.
TEST(CameraView, MatricesAgreeWithProjection) {
  for (const CameraPose& pose : poses()) {
    for (const Axis up : {Axis::Y, Axis::Z}) {
      const CameraView view(pose, up, kSize, kRoom);
      const glm::dvec3 world = pose.target + glm::dvec3(4.0, -7.0, 6.0);
      const glm::dvec4 clip = view.projection() * view.view() * glm::dvec4(world, 1.0);
      const glm::dvec2 by_matrix((0.5 + 0.5 * clip.x / clip.w) * kSize.x, (0.5 - 0.5 * clip.y / clip.w) * kSize.y);
      const auto projected = view.project(world);
      ASSERT_TRUE(projected);
      EXPECT_LE(glm::distance(by_matrix, *projected), 1e-6);
      EXPECT_LT(std::abs(clip.z), clip.w) << "between the near and the far plane";
    }
  }
}

TEST(CameraView, RaysGoThroughWhatTheyPointAt) {
  for (const CameraPose& pose : poses()) {
    const CameraView view(pose, Axis::Z, kSize, kRoom);
    const glm::dvec3 world = pose.target + glm::dvec3(4.0, -7.0, 6.0);
    const CameraView::Ray ray = view.ray(*view.project(world));
    const glm::dvec3 offset = world - ray.origin;
    EXPECT_NEAR(glm::length(ray.direction), 1.0, 1e-12);
    EXPECT_LE(glm::length(offset - ray.direction * glm::dot(offset, ray.direction)), 1e-9);
    EXPECT_GT(glm::dot(offset, ray.direction), 0.0);
  }
}

TEST(CameraView, NothingBehindTheEyeIsProjected) {
  const CameraView view(pose_with(0.3, 0.2), Axis::Y, kSize, kRoom);
  EXPECT_FALSE(view.project(view.eye() + view.axes().back));
  EXPECT_TRUE(view.project(view.eye() - view.axes().back));
}

TEST(Framing, ShowsEveryPointAndFillsTheView) {
  const std::vector<glm::dvec3> points{{-30, 0, 4}, {25, 0, -9}, {0, 170, 12}, {3, 60, -20}};
  for (const CameraPose& pose : poses()) {
    for (const double aspect : {0.5, 1.0, 2.4}) {
      const CameraPose result = framed(pose, Axis::Y, aspect, points, 1.1, 0.1);
      const glm::dvec2 size(600.0 * aspect, 600.0);
      const CameraView view(result, Axis::Y, size, kRoom);
      double closest_to_edge = 1.0;
      for (const glm::dvec3& point : points) {
        const auto place = view.project(point);
        ASSERT_TRUE(place);
        const glm::dvec2 from_edge = glm::min(*place, size - *place) / size;
        EXPECT_GT(std::min(from_edge.x, from_edge.y), 0.0);
        closest_to_edge = std::min({closest_to_edge, from_edge.x, from_edge.y});
      }
      EXPECT_LT(closest_to_edge, 0.2);
    }
  }
}

TEST(Framing, KeepsADistanceFromASinglePoint) {
  const std::vector<glm::dvec3> points{{1, 2, 3}};
  const CameraPose pose = framed({}, Axis::Y, 1.0, points, 1.1, 8.0);
  EXPECT_EQ(pose.half_height, 8.0);
  expect_near(pose.target, points[0], 0.0);
  EXPECT_EQ(framed({}, Axis::Y, 1.0, {}, 1.1, 8.0), CameraPose{});
}

TEST(Camera, ZoomKeepsWhatIsUnderThePointer) {
  Camera camera;
  camera.set_zoom_range(0.1, 1e4);
  for (const double perspective : {0.0, 1.0}) {
    camera.jump_to(pose_with(0.4, 0.3, perspective));
    const glm::dvec2 pointer(620.0, 140.0);
    const CameraView before(camera.pose(), Axis::Y, kSize, kRoom);
    const CameraView::Ray ray = before.ray(pointer);
    // Where the ray meets the plane of the target.
    const double share = glm::dot(camera.pose().target - ray.origin, before.axes().back) /
                         glm::dot(ray.direction, before.axes().back);
    const glm::dvec3 point = ray.origin + ray.direction * share;
    camera.zoom(0.5, pointer, kSize);
    EXPECT_EQ(camera.pose().half_height, 10.0);
    const CameraView after(camera.pose(), Axis::Y, kSize, kRoom);
    EXPECT_LE(glm::distance(*after.project(point), pointer), 1e-6);
  }
}

TEST(Camera, ZoomStaysWithinItsRange) {
  Camera camera;
  camera.set_zoom_range(2.0, 50.0);
  camera.jump_to(pose_with(0, 0));
  for (int i = 0; i < 100; ++i) camera.zoom(0.5, {10, 10}, kSize);
  EXPECT_EQ(camera.pose().half_height, 2.0);
  for (int i = 0; i < 100; ++i) camera.zoom(2.0, {10, 10}, kSize);
  EXPECT_EQ(camera.pose().half_height, 50.0);
}

TEST(Camera, PanMovesTheSceneWithThePointer) {
  Camera camera;
  camera.jump_to(pose_with(0.4, 0.3));
  const glm::dvec3 point = camera.pose().target;
  camera.pan({30.0, -12.0}, kSize);
  const CameraView view(camera.pose(), Axis::Y, kSize, kRoom);
  EXPECT_LE(glm::distance(*view.project(point), 0.5 * kSize + glm::dvec2(30.0, -12.0)), 1e-9);
}

TEST(Camera, OrbitTurnsAboutTheTargetAndStopsAtThePoles) {
  Camera camera;
  camera.jump_to(pose_with(0, 0));
  camera.orbit({50.0, 20.0});
  EXPECT_EQ(camera.pose().target, pose_with(0, 0).target);
  EXPECT_LT(camera.pose().yaw_rad, 0.0) << "dragging to the right shows the other flank, as if the figure were turned";
  EXPECT_GT(camera.pose().pitch_rad, 0.0);
  camera.orbit({0.0, 1e5});
  EXPECT_EQ(camera.pose().pitch_rad, 0.5 * kPi);
}

TEST(Camera, TransitionsTakeTheShortWayAndArriveExactly) {
  Camera camera;
  camera.jump_to(pose_with(3.0, 0.0));
  const CameraPose goal = pose_with(-3.0, 0.5, 0.0);
  camera.move_to(goal, 10.0, true);
  EXPECT_EQ(camera.goal(), goal);
  EXPECT_TRUE(camera.advance(10.06));
  EXPECT_GT(std::abs(std::remainder(camera.pose().yaw_rad, 2.0 * kPi)), 2.9) << "through pi, not through 0";
  EXPECT_GT(camera.pose().pitch_rad, 0.25) << "ease out: past the half after half of the time";
  EXPECT_FALSE(camera.advance(10.13));
  EXPECT_EQ(camera.pose(), goal);
  EXPECT_FALSE(camera.advance(11.0));
}

TEST(Camera, WithoutAnimationItJumps) {
  Camera camera;
  const CameraPose goal = pose_with(1.0, 0.5);
  camera.move_to(goal, 10.0, false);
  EXPECT_EQ(camera.pose(), goal);
  EXPECT_FALSE(camera.advance(10.01));
}

TEST(Camera, FollowingKeepsATransitionGoing) {
  Camera camera;
  camera.jump_to(pose_with(0, 0));
  camera.move_to(pose_with(1, 0), 0.0, true);
  camera.shift({7, 0, 0});
  EXPECT_TRUE(camera.advance(0.05));
  EXPECT_FALSE(camera.advance(1.0));
  expect_near(camera.pose().target, pose_with(1, 0).target + glm::dvec3(7, 0, 0), 1e-12);
}

}  // namespace
}  // namespace marey::app
