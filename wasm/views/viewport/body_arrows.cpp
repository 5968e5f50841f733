#include "wasm/views/viewport/body_arrows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "wasm/views/analysis/plots_view.h"
#include "wasm/views/graph/ticks.h"
#include "wasm/views/viewport/figure_drawing.h"
#include "wasm/views/viewport/stage.h"
#include "wasm/views/viewport/trails.h"

namespace marey::app {
namespace {

constexpr double kLongest = 0.35;       // of the figure's size
constexpr double kUnnoticed = 0.012;    // of the figure's size; shorter ones are dots
constexpr float kShaft = 2.5f;
constexpr float kPathWidth = 2.0f;
constexpr double kHeadShare = 0.28;
constexpr double kLongestHead = 0.05;   // of the figure's size
constexpr float kComRadius = 0.022f;    // of the figure's size
constexpr float kRowHeight = 16.0f;

struct ArrowTraits {
  std::string_view quantity;
  const char* name;
  const char* unit;
};
constexpr std::array<ArrowTraits, kBodyArrowCount> kTraits = {
    ArrowTraits{"velocity", "Velocity", "m/s"},   ArrowTraits{"acceleration", "Acceleration", "m/s²"},
    ArrowTraits{"force", "Joint force", "N"},     ArrowTraits{"torque", "Joint torque", "N·m"},
    ArrowTraits{"angular_momentum", "Angular momentum", "kg·m²/s"}, ArrowTraits{"reaction", "Support reaction", "N"}};

const ArrowTraits& traits_of(BodyArrow kind) { return kTraits[static_cast<std::size_t>(kind)]; }

/// The three columns of a vector.
struct VectorColumns {
  std::array<std::span<const double>, 3> of;

  VectorColumns(const Analysis& analysis, std::string_view quantity, NodeIndex node)
      : of{analysis.column(quantity, node, 'x'), analysis.column(quantity, node, 'y'), analysis.column(quantity, node, 'z')} {}
  [[nodiscard]] bool has(FrameIndex frame) const {
    return idx(frame) < of[0].size() && std::isfinite(of[0][idx(frame)]) && std::isfinite(of[1][idx(frame)]) && std::isfinite(of[2][idx(frame)]);
  }
  [[nodiscard]] glm::dvec3 at(FrameIndex frame) const { return {of[0][idx(frame)], of[1][idx(frame)], of[2][idx(frame)]}; }
};

bool is_of_joints(BodyArrow kind) { return kind < BodyArrow::AngularMomentum; }

double longest_of(const VectorColumns& columns) {
  double longest = 0.0;
  for (FrameIndex frame = 0; frame < size_of(columns.of[0]); ++frame) {
    if (columns.has(frame)) longest = std::max(longest, glm::length(columns.at(frame)));
  }
  return longest;
}

}  // namespace

ImU32 arrow_color(const Theme& theme, BodyArrow kind) {
  switch (kind) {
    case BodyArrow::Velocity: return theme.ok;
    case BodyArrow::Acceleration: return theme.warning;
    case BodyArrow::Force: return theme.accent;
    case BodyArrow::Torque: return theme.error;
    case BodyArrow::AngularMomentum: return theme.axis[0];
    case BodyArrow::Reaction: return theme.selection;
  }
  return theme.accent;
}

void BodyArrows::find_scales(ViewContext& context, double longest) {
  const Analysis& analysis = context.analysis;
  const Skeleton& skeleton = context.session.document.skeleton();
  for (int i = 0; i < kBodyArrowCount; ++i) {
    const BodyArrow kind = static_cast<BodyArrow>(i);
    double value = 0.0;
    for (JointIndex joint = 0; is_of_joints(kind) && joint < skeleton.joint_count(); ++joint) {
      value = std::max(value, longest_of({analysis, traits_of(kind).quantity, skeleton.node_of(joint)}));
    }
    if (!is_of_joints(kind)) value = longest_of({analysis, traits_of(kind).quantity, kNoParent});
    units_per_value_[i] = value > 0.0 ? longest / value : 0.0;
  }
}

void BodyArrows::follow(ViewContext& context, const ViewportState& viewport) {
  const double size = viewport.figure.stage().size;
  if (!known_ || serial_ != context.analysis.serial()) find_scales(context, kLongest * size);
  known_ = true;
  serial_ = context.analysis.serial();
  legends_.clear();
  const double per_pixel = viewport.view.units_per_pixel(viewport.view.depth(glm::dvec3(viewport.camera.pose().target)));
  for (int i = 0; i < kBodyArrowCount; ++i) {
    const double scale = units_per_value_[i];
    if (!context.options.shown_arrows.arrows[i] || !(scale > 0.0)) continue;
    const double value = rounded_down_125(0.5 * kLongest * size / scale);
    legends_.push_back({static_cast<BodyArrow>(i), SmallText("{} {:g} {}", kTraits[idx(i)].name, value, kTraits[idx(i)].unit),
                        static_cast<float>(value * scale / per_pixel)});
  }
}

// A shaft with two strokes for its head, in the plane that faces the camera.
void BodyArrows::add_arrow(const ViewportState& viewport, const glm::dvec3& from, const glm::dvec3& arrow, const glm::vec4& color,
                           Scene& scene) const {
  const double length = glm::length(arrow);
  const double size = viewport.figure.stage().size;
  if (!(length > kUnnoticed * size)) return;
  const glm::dvec3 direction = arrow / length;
  const glm::dvec3 across = glm::cross(direction, glm::dvec3(viewport.view.axes().back));
  const double width = glm::length(across);
  const double head = std::min(kHeadShare * length, kLongestHead * size);
  const glm::dvec3 side = width > 1e-6 ? across / width * 0.5 * head : glm::dvec3(0.0);
  const glm::dvec3 tip = from + arrow;
  const auto add = [&](const glm::dvec3& a, const glm::dvec3& b) {
    scene.lines.push_back({size_of(scene.line_points), 2, kShaft});
    scene.line_points.push_back({glm::vec3(a), color});
    scene.line_points.push_back({glm::vec3(b), color});
  };
  add(from, tip);
  add(tip - direction * head + side, tip);
  add(tip - direction * head - side, tip);
}

void BodyArrows::add_com(ViewContext& context, const ViewportState& viewport, Scene& scene) const {
  const VectorColumns com(context.analysis, "com", kNoParent);
  const Session& session = context.session;
  const FrameIndex frame = session.playback.frame();
  if (!com.has(frame)) return;
  const double units = 1.0 / context.analysis.metres_per_unit();
  const Stage& stage = viewport.figure.stage();
  const glm::vec4 color = scene_color(context.theme.selection);
  const FrameRange shown = find_trail_frames(session.playback.range(), session.document.motion().frame_time_s(), frame);
  scene.lines.push_back({size_of(scene.line_points), 0, kPathWidth});
  for (FrameIndex i = shown.first; i < shown.end(); ++i) {
    if (!com.has(i)) continue;
    scene.line_points.push_back({glm::vec3(com.at(i) * units), scene_color(context.theme.selection, 0.55f)});
    ++scene.lines.back().count;
  }
  const glm::dvec3 here = com.at(frame) * units;
  glm::dvec3 below = here;
  below[static_cast<int>(stage.up)] = stage.ground_height;
  const auto radius = kComRadius * static_cast<float>(stage.size);
  scene.balls.push_back({glm::vec3(here), radius, color});
  scene.lines.push_back({size_of(scene.line_points), 2, 1.0f});
  scene.line_points.push_back({glm::vec3(here), scene_color(context.theme.selection, 0.7f)});
  scene.line_points.push_back({glm::vec3(below), scene_color(context.theme.selection, 0.7f)});
  for (int axis = 0; axis < 3; ++axis) {
    if (axis == static_cast<int>(stage.up)) continue;
    glm::dvec3 reach(0.0);
    reach[axis] = 2.0 * static_cast<double>(radius);
    scene.lines.push_back({size_of(scene.line_points), 2, kPathWidth});
    scene.line_points.push_back({glm::vec3(below - reach), color});
    scene.line_points.push_back({glm::vec3(below + reach), color});
  }
}

void BodyArrows::add_joint_arrows(ViewContext& context, const ViewportState& viewport, BodyArrow kind, Scene& scene) const {
  const Session& session = context.session;
  const Skeleton& skeleton = session.document.skeleton();
  const auto& selected = session.selection.joints();
  const glm::vec4 color = scene_color(arrow_color(context.theme, kind));
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    if (!selected.empty() && std::find(selected.begin(), selected.end(), joint) == selected.end()) continue;
    const NodeIndex node = skeleton.node_of(joint);
    const VectorColumns columns(context.analysis, traits_of(kind).quantity, node);
    if (!columns.has(session.playback.frame())) continue;
    const glm::dvec3 from(viewport.figure.pose().world_positions[idx(node)]);
    add_arrow(viewport, from, columns.at(session.playback.frame()) * units_per_value_[static_cast<int>(kind)], color, scene);
  }
}

void BodyArrows::add_body_arrows(ViewContext& context, const ViewportState& viewport, Scene& scene) const {
  const FrameIndex frame = context.session.playback.frame();
  const double units = 1.0 / context.analysis.metres_per_unit();
  const auto add = [&](BodyArrow kind, std::string_view origin) {
    if (!context.options.shown_arrows.shows(kind)) return;
    const VectorColumns values(context.analysis, traits_of(kind).quantity, kNoParent);
    const VectorColumns places(context.analysis, origin, kNoParent);
    if (!values.has(frame)) return;
    // A bar's reaction has no place on the ground: it acts on the root.
    const glm::dvec3 root(viewport.figure.pose().world_positions[0]);
    add_arrow(viewport, places.has(frame) ? places.at(frame) * units : root, values.at(frame) * units_per_value_[static_cast<int>(kind)],
              scene_color(arrow_color(context.theme, kind)), scene);
  };
  add(BodyArrow::AngularMomentum, "com");
  add(BodyArrow::Reaction, "cop");
}

void BodyArrows::add(ViewContext& context, const ViewportState& viewport, Scene& scene) {
  legends_.clear();
  if (!context.options.shown_arrows.any() || viewport.figure.empty()) return;
  follow_analysis(context);
  if (!context.analysis.is_of(context.clip_serial) || !context.analysis.problem().empty()) return;
  follow(context, viewport);
  if (context.options.shown_arrows.com) add_com(context, viewport, scene);
  for (const BodyArrow kind : {BodyArrow::Velocity, BodyArrow::Acceleration, BodyArrow::Force, BodyArrow::Torque}) {
    if (context.options.shown_arrows.shows(kind)) add_joint_arrows(context, viewport, kind, scene);
  }
  add_body_arrows(context, viewport, scene);
}

void draw_arrow_legend(ViewContext& context, const BodyArrows& arrows, ImVec2 corner) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  float y = corner.y;
  for (const BodyArrows::Legend& legend : arrows.legends()) {
    const ImU32 color = arrow_color(context.theme, legend.kind);
    list.AddLine({corner.x, y + 0.5f * kRowHeight}, {corner.x + legend.width, y + 0.5f * kRowHeight}, color, 2.5f);
    const ImVec2 at{corner.x + legend.width + 8.0f, y + 1.0f};
    list.AddText(context.fonts.text, Fonts::kSmallSize + 1.0f, at, context.theme.dim_text, legend.text.c_str());
    context.items.add(SmallText("viewport.arrows.{}", static_cast<int>(legend.kind)), legend.text, {corner.x, y}, {at.x + 100.0f, y + kRowHeight});
    y += kRowHeight;
  }
}

}  // namespace marey::app
