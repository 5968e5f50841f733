#include "wasm/app/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/geometric.hpp>
#include <numbers>

namespace marey::app {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kOpening_rad = 32.0 * kPi / 180.0;
constexpr double kTransition_s = 0.12;
constexpr double kOrbit_rad_per_unit = 0.0075;
// Below this share of the opening angle the eye would be so far away that the picture is drawn orthographic.
constexpr double kLeastPerspective = 0.02;

ViewAxes turned_axes(Axis up, double yaw_rad, double pitch_rad) {
  const ViewAxes front = front_axes(up);
  const glm::dvec3 level = front.back * std::cos(yaw_rad) + front.right * std::sin(yaw_rad);
  ViewAxes axes;
  axes.right = front.right * std::cos(yaw_rad) - front.back * std::sin(yaw_rad);
  axes.back = level * std::cos(pitch_rad) + front.up * std::sin(pitch_rad);
  axes.up = glm::cross(axes.back, axes.right);
  return axes;
}

double mixed(double from, double to, double share) { return from + (to - from) * share; }

CameraPose mixed(const CameraPose& from, const CameraPose& to, double share) {
  CameraPose pose;
  pose.target = glm::mix(from.target, to.target, share);
  pose.half_height = std::exp(mixed(std::log(from.half_height), std::log(to.half_height), share));
  pose.yaw_rad = from.yaw_rad + std::remainder(to.yaw_rad - from.yaw_rad, 2.0 * kPi) * share;
  pose.pitch_rad = mixed(from.pitch_rad, to.pitch_rad, share);
  pose.perspective = mixed(from.perspective, to.perspective, share);
  return pose;
}

}  // namespace

ViewAxes front_axes(Axis up) {
  switch (up) {
    case Axis::X: return {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}};
    case Axis::Z: return {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
    case Axis::Y: break;
  }
  return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
}

std::array<glm::dvec3, 8> corners(const Box& box) {
  std::array<glm::dvec3, 8> points;
  for (int i = 0; i < 8; ++i) {
    points[idx(i)] = {(i & 1) != 0 ? box.high.x : box.low.x, (i & 2) != 0 ? box.high.y : box.low.y,
                      (i & 4) != 0 ? box.high.z : box.low.z};
  }
  return points;
}

CameraView::CameraView(const CameraPose& pose, Axis up, const glm::dvec2& size, const Box& reach)
    : axes_(turned_axes(up, pose.yaw_rad, pose.pitch_rad)),
      size_(glm::max(size, glm::dvec2(1.0))),
      orthographic_(pose.perspective < kLeastPerspective),
      half_height_(pose.half_height) {
  const double aspect = size_.x / size_.y;
  tan_half_ = orthographic_ ? 0.0 : std::tan(0.5 * kOpening_rad * pose.perspective);
  const double radius = 0.5 * glm::length(reach.size());
  const double distance =
      orthographic_ ? 2.0 * radius + 4.0 * half_height_ + glm::distance(reach.center(), pose.target) : half_height_ / tan_half_;
  eye_ = pose.target + axes_.back * distance;
  view_ = glm::dmat4(glm::transpose(glm::dmat3(axes_.right, axes_.up, axes_.back)));
  view_[3] = glm::dvec4(glm::dmat3(view_) * -eye_, 1.0);

  const double middle = depth(reach.center());
  const double far_plane = std::max(middle + radius, distance) * 1.01;
  // A floor under the near plane: depth is precise only while near and far are not too far apart.
  const double near_plane = std::max(middle - radius, std::max(0.02 * distance, 1e-4 * far_plane)) * 0.99;
  if (orthographic_) {
    projection_ = glm::orthoRH_NO(-half_height_ * aspect, half_height_ * aspect, -half_height_, half_height_, 0.0, far_plane);
  } else {
    projection_ = glm::perspectiveRH_NO(2.0 * std::atan(tan_half_), aspect, near_plane, far_plane);
  }
}

double CameraView::depth(const glm::dvec3& world) const { return glm::dot(eye_ - world, axes_.back); }

double CameraView::units_per_pixel(double depth) const {
  const double half_height = orthographic_ ? half_height_ : std::max(depth, 0.0) * tan_half_;
  return 2.0 * half_height / size_.y;
}

std::optional<glm::dvec2> CameraView::project(const glm::dvec3& world) const {
  const double scale = units_per_pixel(depth(world));
  if (scale <= 0.0) return std::nullopt;
  const glm::dvec3 from_eye = world - eye_;
  return 0.5 * size_ + glm::dvec2(glm::dot(from_eye, axes_.right), -glm::dot(from_eye, axes_.up)) / scale;
}

CameraView::Ray CameraView::ray(const glm::dvec2& screen) const {
  const glm::dvec2 from_middle = (screen - 0.5 * size_) * units_per_pixel(1.0);
  const glm::dvec3 across = axes_.right * from_middle.x - axes_.up * from_middle.y;
  if (orthographic_) return {eye_ + across, -axes_.back};
  return {eye_, glm::normalize(across - axes_.back)};
}

CameraPose framed(const CameraPose& pose, Axis up, double aspect, std::span<const glm::dvec3> points, double margin,
                  double smallest_half_height) {
  if (points.empty()) return pose;
  const ViewAxes axes = turned_axes(up, pose.yaw_rad, pose.pitch_rad);
  const bool flat = pose.perspective < kLeastPerspective;
  const double tan_half = flat ? 0.0 : std::tan(0.5 * kOpening_rad * pose.perspective);
  Box box{points[0], points[0]};
  for (const glm::dvec3& point : points) box = {glm::min(box.low, point), glm::max(box.high, point)};
  CameraPose result = pose;
  result.target = box.center();
  result.half_height = smallest_half_height;
  for (const glm::dvec3& point : points) {
    const glm::dvec3 from_target = point - result.target;
    const double across = std::abs(glm::dot(from_target, axes.right)) / aspect;
    const double along = std::abs(glm::dot(from_target, axes.up));
    // A point nearer to the eye than the target looks larger.
    const double nearness = tan_half * glm::dot(from_target, axes.back);
    result.half_height = std::max(result.half_height, margin * std::max(across, along) + std::max(nearness, 0.0));
  }
  return result;
}

void Camera::set_zoom_range(double smallest, double largest) {
  smallest_ = smallest;
  largest_ = largest;
}

void Camera::jump_to(const CameraPose& pose) {
  pose_ = pose;
  moving_ = false;
}

void Camera::move_to(const CameraPose& pose, double now_s, bool animated) {
  if (!animated) {
    jump_to(pose);
    return;
  }
  start_ = pose_;
  goal_ = pose;
  start_s_ = now_s;
  moving_ = true;
}

bool Camera::advance(double now_s) {
  if (!moving_) return false;
  const double share = (now_s - start_s_) / kTransition_s;
  if (share >= 1.0) {
    jump_to(goal_);
    return false;
  }
  const double left = 1.0 - std::max(share, 0.0);
  pose_ = mixed(start_, goal_, 1.0 - left * left * left);
  return true;
}

void Camera::orbit(const glm::dvec2& drag) {
  moving_ = false;
  pose_.yaw_rad = std::remainder(pose_.yaw_rad - drag.x * kOrbit_rad_per_unit, 2.0 * kPi);
  pose_.pitch_rad = std::clamp(pose_.pitch_rad + drag.y * kOrbit_rad_per_unit, -0.5 * kPi, 0.5 * kPi);
}

void Camera::pan(const glm::dvec2& drag, const glm::dvec2& view_size) {
  moving_ = false;
  const ViewAxes axes = turned_axes(up_, pose_.yaw_rad, pose_.pitch_rad);
  const double units = 2.0 * pose_.half_height / std::max(view_size.y, 1.0);
  pose_.target += (axes.up * drag.y - axes.right * drag.x) * units;
}

void Camera::zoom(double factor, const glm::dvec2& pointer, const glm::dvec2& view_size) {
  moving_ = false;
  const double wanted = std::clamp(pose_.half_height * factor, smallest_, largest_);
  const double change = wanted / pose_.half_height;
  // The point under the pointer, at the target's distance, is drawn (pointer - middle) away from the target.
  pan((0.5 * view_size - pointer) * (1.0 - change), view_size);
  pose_.half_height = wanted;
}

void Camera::shift(const glm::dvec3& by) {
  pose_.target += by;
  start_.target += by;
  goal_.target += by;
}

}  // namespace marey::app
