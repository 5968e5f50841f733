#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/math/euler.h"
#include "wasm/app/view_context.h"

namespace marey::app {

/// The rotation of the active joint as angles in each of the six orders of three axes, with the frames near gimbal lock
/// shaded: where the middle angle is within 15 degrees of a right one, the outer two turn fast and say little.
class OrderView {
 public:
  void draw(ViewContext& context, ImVec2 min, ImVec2 max);

 private:
  struct Order {
    EulerOrder order;
    std::vector<double> angles[3];  // by the axis X, Y, Z
    std::vector<FrameRange> locked;
    int locked_frames = 0;
  };
  void follow(const ViewContext& context, JointIndex joint);
  void draw_order(ViewContext& context, const Order& order, int index, ImVec4 place) const;

  JointIndex joint_ = kNoParent;
  std::uint64_t clip_serial_ = 0;
  std::uint64_t revision_ = 0;
  FrameRange frames_;
  std::vector<double> times_;
  std::array<Order, 6> orders_;
  bool has_rotation_ = false;
};

}  // namespace marey::app
