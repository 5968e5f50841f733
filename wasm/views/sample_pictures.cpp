#include "wasm/views/sample_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

namespace marey::app {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

// A chain of links in a square of side 1, y downwards; angles from straight down, counter-clockwise.
struct Chain {
  ImVec2 start;
  std::vector<ImVec2> joints;

  explicit Chain(ImVec2 from) : start(from), joints{from} {}

  Chain& link(double length, double angle_rad) {
    const ImVec2 last = joints.back();
    joints.emplace_back(last.x + static_cast<float>(length * std::sin(angle_rad)),
                        last.y + static_cast<float>(length * std::cos(angle_rad)));
    return *this;
  }
};

enum class Side { Middle, Left, Right };

struct Limb {
  Chain chain;
  Side side = Side::Middle;
};

struct Figure {
  std::vector<Limb> limbs;
  float head_radius = 0.0f;  ///< at the end of the first limb; 0 for none
};

double wave(double phase) { return std::sin(kTurn * phase); }

Figure giant_swing_at(double phase) {
  const double swing = -kTurn * phase;
  const double arch = 0.35 * std::sin(kTurn * phase + 0.6);
  Chain body(ImVec2(0.5f, 0.5f));
  body.link(0.12, swing).link(0.15, swing + arch).link(0.19, swing + 2.2 * arch);
  return {{{body, Side::Middle}}, 0.0f};
}

Limb leg_at(ImVec2 hip, double phase, Side side) {
  const double thigh = 0.42 * wave(phase) + 0.06;
  const double knee = 0.12 + 0.85 * std::pow(std::max(0.0, std::sin(kTurn * phase - 4.9)), 2.0);
  Chain chain(hip);
  chain.link(0.21, thigh).link(0.21, thigh - knee).link(0.06, thigh - knee + 1.45);
  return {chain, side};
}

Limb arm_at(ImVec2 shoulder, double phase, Side side) {
  const double upper = 0.4 * wave(phase);
  Chain chain(shoulder);
  chain.link(0.15, upper).link(0.14, upper + 0.35);
  return {chain, side};
}

Figure walk_at(double phase) {
  const auto bob = static_cast<float>(0.012 * std::cos(2.0 * kTurn * phase));
  const ImVec2 hip(0.5f, 0.5f + bob);
  Chain trunk(hip);
  trunk.link(0.25, std::numbers::pi + 0.06).link(0.1, std::numbers::pi + 0.1);
  const ImVec2 shoulder = trunk.joints[1];
  return {{{trunk, Side::Middle},
           leg_at(hip, phase, Side::Left),
           leg_at(hip, phase + 0.5, Side::Right),
           arm_at(shoulder, phase + 0.5, Side::Left),
           arm_at(shoulder, phase, Side::Right)},
          0.055f};
}

Figure pendulum_at(double phase) {
  Chain rod(ImVec2(0.5f, 0.2f));
  rod.link(0.58, 1.1 * std::cos(kTurn * phase));
  return {{{rod, Side::Right}}, 0.05f};
}

Figure double_pendulum_at(double phase) {
  Chain rods(ImVec2(0.5f, 0.28f));
  rods.link(0.28, 1.3 * std::cos(kTurn * phase)).link(0.28, 2.1 * std::cos(2.0 * kTurn * phase + 0.7));
  return {{{rods, Side::Left}}, 0.035f};
}

Figure robot_arm_at(double phase) {
  const double reach = 0.5 - 0.5 * std::cos(kTurn * phase);
  const double shoulder = std::numbers::pi + 0.5 - 0.9 * reach;
  const double elbow = shoulder - 1.1 - 0.5 * reach;
  const double wrist = elbow - 0.8 + 0.5 * reach;
  Chain arm(ImVec2(0.34f, 0.85f));
  arm.link(0.16, std::numbers::pi).link(0.32, shoulder).link(0.28, elbow).link(0.12, wrist);
  return {{{arm, Side::Middle}}, 0.0f};
}

Figure figure_at(std::string_view sample_id, double phase) {
  if (sample_id == "giant-swing") return giant_swing_at(phase);
  if (sample_id == "walk") return walk_at(phase);
  if (sample_id == "pendulum") return pendulum_at(phase);
  if (sample_id == "double-pendulum") return double_pendulum_at(phase);
  return robot_arm_at(phase);
}

ImU32 side_color(const Theme& theme, Side side) {
  return side == Side::Left ? theme.left : side == Side::Right ? theme.right : theme.middle;
}

struct Plate {
  ImVec2 corner;
  float side = 0.0f;
  [[nodiscard]] ImVec2 at(ImVec2 point) const { return {corner.x + point.x * side, corner.y + point.y * side}; }
};

void draw_figure(ImDrawList& draw_list, const Theme& theme, const Plate& plate, const Figure& figure, float strength) {
  const float width = plate.side * 0.026f;
  for (const Limb& limb : figure.limbs) {
    const ImU32 color = with_alpha(side_color(theme, limb.side), strength);
    std::vector<ImVec2> points;
    for (const ImVec2 joint : limb.chain.joints) points.push_back(plate.at(joint));
    draw_list.AddPolyline(points.data(), static_cast<int>(points.size()), color, 0, width);
    if (strength < 1.0f) continue;
    for (const ImVec2 point : points) draw_list.AddCircleFilled(point, width * 0.9f, color);
  }
  if (figure.head_radius > 0.0f) {
    const Limb& first = figure.limbs.front();
    draw_list.AddCircleFilled(plate.at(first.chain.joints.back()), figure.head_radius * plate.side,
                              with_alpha(side_color(theme, first.side), strength));
  }
}

}  // namespace

void draw_sample_picture(ImDrawList& draw_list, const Theme& theme, std::string_view sample_id, ImVec2 min, ImVec2 max,
                         double phase) {
  const float side = std::min(max.x - min.x, max.y - min.y);
  const ImVec2 corner((min.x + max.x - side) * 0.5f, (min.y + max.y - side) * 0.5f);
  draw_list.PushClipRect(min, max, true);
  // A walk leaves its earlier positions behind; the others turn about a fixed point.
  const bool moves_on = sample_id == "walk";
  constexpr int kGhosts = 5;
  for (int ghost = kGhosts; ghost >= 0; --ghost) {
    const float age = static_cast<float>(ghost) / static_cast<float>(kGhosts);
    const double earlier = phase - (moves_on ? 0.14 : 0.075) * ghost;
    const float behind = moves_on ? side * (0.26f - 0.17f * static_cast<float>(ghost)) : 0.0f;
    const Plate plate{ImVec2(corner.x + behind, corner.y), side};
    draw_figure(draw_list, theme, plate, figure_at(sample_id, earlier), ghost == 0 ? 1.0f : 0.42f * (1.0f - age) + 0.06f);
  }
  draw_list.PopClipRect();
}

}  // namespace marey::app
