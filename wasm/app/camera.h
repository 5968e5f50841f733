#pragma once

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "core/kinematics/clip_bounds.h"
#include "core/skeleton/channel.h"

namespace marey::app {

/// Where the camera looks from, as a value. Lengths are file units, angles radians.
struct CameraPose {
  glm::dvec3 target{0.0};    ///< world; in the middle of the view, and what an orbit turns about
  double half_height = 1.0;  ///< what is seen above the target, at its distance; > 0
  double yaw_rad = 0.0;      ///< 0 sees the front, positive goes to the figure's left
  double pitch_rad = 0.0;    ///< -pi/2 from below ... pi/2 from above
  double perspective = 1.0;  ///< 0 orthographic ... 1 the full opening angle
  friend bool operator==(const CameraPose&, const CameraPose&) = default;
};

/// World axes as seen by a camera that looks at the front of a figure.
struct ViewAxes {
  glm::dvec3 right{1.0, 0.0, 0.0};
  glm::dvec3 up{0.0, 1.0, 0.0};
  glm::dvec3 back{0.0, 0.0, 1.0};  ///< towards the viewer
};

/// With Y up the front is seen from +Z, with Z up from -Y: the habits of BVH and of Blender. Right is +X in both.
[[nodiscard]] ViewAxes front_axes(Axis up);

/// A pose made ready for projecting: what a frame is drawn and picked with. Screen positions are ImGui units inside of
/// the view, origin top left, y down.
class CameraView {
 public:
  /// `size`: of the view. `reach`: all that is drawn lies in this box, which sets the near and far plane.
  CameraView(const CameraPose& pose, Axis up, const glm::dvec2& size, const Box& reach);
  CameraView() : CameraView({}, Axis::Y, {1.0, 1.0}, {}) {}

  [[nodiscard]] const glm::dmat4& view() const { return view_; }
  [[nodiscard]] const glm::dmat4& projection() const { return projection_; }
  [[nodiscard]] const glm::dvec3& eye() const { return eye_; }
  [[nodiscard]] const ViewAxes& axes() const { return axes_; }
  [[nodiscard]] bool orthographic() const { return orthographic_; }
  [[nodiscard]] const glm::dvec2& size() const { return size_; }

  /// Screen position of a world point; nothing when it is behind the camera.
  [[nodiscard]] std::optional<glm::dvec2> project(const glm::dvec3& world) const;
  /// Distance from the camera along its line of sight; < 0 behind it. Sorts from near to far.
  [[nodiscard]] double depth(const glm::dvec3& world) const;
  /// File units that one ImGui unit spans at that depth.
  [[nodiscard]] double units_per_pixel(double depth) const;

  struct Ray {
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0, 0.0, -1.0};  ///< unit
  };
  [[nodiscard]] Ray ray(const glm::dvec2& screen) const;

 private:
  ViewAxes axes_;
  glm::dvec2 size_;
  glm::dvec3 eye_;
  bool orthographic_ = false;
  double tan_half_ = 0.0;     // of the opening angle; 0 when orthographic
  double half_height_ = 1.0;  // when orthographic
  glm::dmat4 view_{1.0};
  glm::dmat4 projection_{1.0};
};

/// The pose that shows `points` whole, `pose` giving the direction, with `margin` (1.1: a tenth of air). `pose` itself
/// for no points. The view is never closer than `smallest_half_height`.
[[nodiscard]] CameraPose framed(const CameraPose& pose, Axis up, double aspect, std::span<const glm::dvec3> points,
                                double margin, double smallest_half_height);

/// The eight corners of a box.
[[nodiscard]] std::array<glm::dvec3, 8> corners(const Box& box);

/// The camera as the user moves it. Changes by name go there in 120 ms; drags are immediate.
class Camera {
 public:
  [[nodiscard]] const CameraPose& pose() const { return pose_; }
  /// Where a running transition ends; the pose itself when none runs.
  [[nodiscard]] const CameraPose& goal() const { return moving_ ? goal_ : pose_; }
  [[nodiscard]] Axis up() const { return up_; }
  void set_up(Axis up) { up_ = up; }
  /// Half heights that zooming keeps to, in file units.
  void set_zoom_range(double smallest, double largest);

  void jump_to(const CameraPose& pose);
  void move_to(const CameraPose& pose, double now_s, bool animated);
  /// Goes on with a transition; true while one runs.
  bool advance(double now_s);

  /// Each ends a running transition where it is. Distances in ImGui units, y down.
  void orbit(const glm::dvec2& drag);
  void pan(const glm::dvec2& drag, const glm::dvec2& view_size);
  /// `factor` < 1 comes closer. What is under `pointer` stays there.
  void zoom(double factor, const glm::dvec2& pointer, const glm::dvec2& view_size);
  /// Moves with the figure, keeping a running transition going.
  void shift(const glm::dvec3& by);

 private:
  CameraPose pose_;
  CameraPose start_;
  CameraPose goal_;
  double start_s_ = 0.0;
  bool moving_ = false;
  Axis up_ = Axis::Y;
  double smallest_ = 1e-3;
  double largest_ = 1e6;
};

}  // namespace marey::app
