#include "wasm/views/curves/curves_overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "wasm/app/widgets.h"
#include "wasm/views/curves/curves_drawing.h"
#include "wasm/views/graph/ticks.h"

namespace marey::app {
namespace {

constexpr float kLabelHeight = 16.0f;
constexpr float kLabelPadding = 5.0f;
constexpr std::size_t kMostCurveLabels = 12;

ImDrawList& draw_list() { return *ImGui::GetWindowDrawList(); }

SmallText value_text(const Channel& channel, double value) {
  const bool angle = is_rotation(channel.kind);
  return SmallText("{}{}{}", tick_label(value, angle ? 2 : 3), angle ? "" : " ", unit_of(channel.kind));
}

float text_width(const Fonts& fonts, const SmallText& text) {
  return fonts.mono->CalcTextSizeA(Fonts::kSmallSize, FLT_MAX, 0.0f, text.c_str()).x;
}

// Raised chip with text, kept within the area.
void draw_chip(ViewContext& context, const GraphArea& area, ImVec2 place, const SmallText& text, ImU32 color) {
  const float width = text_width(context.fonts, text) + 2.0f * kLabelPadding;
  const float x = std::clamp(place.x, area.min.x, std::max(area.min.x, area.max.x - width));
  const float y = std::clamp(place.y, area.min.y, std::max(area.min.y, area.max.y - kLabelHeight));
  const ImVec2 min{std::round(x), std::round(y)};
  const ImVec2 max{min.x + width, min.y + kLabelHeight};
  draw_list().AddRectFilled(min, max, with_alpha(context.theme.raised, 0.94f), 4.0f);
  draw_list().AddRect(min, max, context.theme.line, 4.0f);
  draw_list().AddText(context.fonts.mono, Fonts::kSmallSize, {min.x + kLabelPadding, min.y + 2.0f}, color, text.c_str());
}

/// A text beside a curve.
struct CurveLabel {
  float y = 0.0f;
  ChannelIndex channel = 0;
};

/// Of the active joint's curves, as many as find room.
struct CurveLabels {
  std::array<CurveLabel, kMostCurveLabels> labels;
  std::size_t count = 0;

  void add(CurveLabel label) {
    if (count < labels.size()) labels[count++] = label;
  }
  [[nodiscard]] std::span<CurveLabel> list() { return std::span(labels).first(count); }
};

// Pushes labels down until none covers another, then up again from the lower edge.
void declutter(std::span<CurveLabel> labels, const GraphArea& area) {
  constexpr float kGap = kLabelHeight + 2.0f;
  std::sort(labels.begin(), labels.end(), [](const CurveLabel& a, const CurveLabel& b) { return a.y < b.y; });
  float lowest = area.min.y;
  for (CurveLabel& label : labels) {
    label.y = std::max(label.y, lowest);
    lowest = label.y + kGap;
  }
  float highest = area.max.y - kLabelHeight;
  for (auto label = labels.rbegin(); label != labels.rend(); ++label) {
    label->y = std::min(label->y, highest);
    highest = label->y - kGap;
  }
}

CurveLabels cursor_labels(ViewContext& context, const CurvesState& state, FrameIndex frame) {
  CurveLabels labels;
  const Document& document = context.session.document;
  const JointIndex active = context.session.selection.active_joint();
  for (const ChannelIndex channel : state.shown) {
    const Channel& described = document.skeleton().channel(channel);
    if (described.joint != active) continue;
    const double value = document.motion().sample(channel, frame);
    const float y = state.axis_of(document.skeleton(), channel).y_of(value);
    labels.add({std::isfinite(value) ? y - 0.5f * kLabelHeight : state.area.min.y, channel});
  }
  declutter(labels.list(), state.area);
  return labels;
}

// The name of a curve, above its last visible sample: the axes take the room beside it.
void draw_end_letter(ViewContext& context, const CurveLabel& label, float right) {
  const Channel& channel = context.session.document.skeleton().channel(label.channel);
  const char* name = short_name_of(channel);
  const float width = context.fonts.semibold->CalcTextSizeA(Fonts::kSmallSize, 1e6f, 0.0f, name).x;
  draw_list().AddText(context.fonts.semibold, Fonts::kSmallSize, {std::round(right - width), std::round(label.y)},
                      channel_color(context.theme, channel), name);
}

FrameRange falloff_hull(const Session& session, ChannelIndex channel) {
  FrameRange hull{0, 0};
  for (const SampleRun& run : session.selection.samples().runs()) {
    if (run.channel != channel) continue;
    const FrameIndex first = hull.count == 0 ? run.frames.first : std::min(hull.first, run.frames.first);
    hull = {first, std::max(hull.count == 0 ? 0 : hull.end(), run.frames.end()) - first};
  }
  return hull;
}

}  // namespace

void draw_range_shade(ViewContext& context, const CurvesState& state) {
  const FrameRange range = context.session.playback.range();
  const ImU32 shade = with_alpha(context.theme.panel, 0.7f);
  const float left = context.time_window.x_of(range.first);
  const float right = context.time_window.x_of(range.end() - 1);
  if (left > state.area.min.x) draw_list().AddRectFilled(state.area.min, {left, state.area.max.y}, shade);
  if (right < state.area.max.x) draw_list().AddRectFilled({right, state.area.min.y}, state.area.max, shade);
}

void draw_falloff_band(ViewContext& context, const CurvesState& state) {
  if (state.drag.kind != CurveDragKind::Move || !state.drag.moved) return;
  const double radius = static_cast<double>(context.options.falloff_radius_frames);
  const FrameRange hull = falloff_hull(context.session, state.drag.grabbed.channel);
  if (hull.count == 0) return;
  const float left = context.time_window.x_of(hull.first - radius);
  const float right = context.time_window.x_of(hull.end() - 1 + radius);
  draw_list().AddRectFilled({left, state.area.min.y}, {right, state.area.max.y},
                            with_alpha(context.theme.selection, 0.10f));
  draw_list().AddLine({left, state.area.min.y}, {left, state.area.max.y}, with_alpha(context.theme.selection, 0.5f));
  draw_list().AddLine({right, state.area.min.y}, {right, state.area.max.y}, with_alpha(context.theme.selection, 0.5f));
  draw_chip(context, state.area, {left, state.area.max.y - kLabelHeight - 4.0f},
            SmallText("Falloff {:.0f} frames", radius), context.theme.selection);
}

void draw_box(ViewContext& context, const CurvesState& state) {
  if (state.drag.kind != CurveDragKind::Box || !state.drag.moved) return;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const ImVec2 min{std::min(mouse.x, state.drag.start.x), std::min(mouse.y, state.drag.start.y)};
  const ImVec2 max{std::max(mouse.x, state.drag.start.x), std::max(mouse.y, state.drag.start.y)};
  draw_list().AddRectFilled(min, max, with_alpha(context.theme.accent, 0.15f));
  draw_list().AddRect(min, max, context.theme.accent);
}

void draw_cursor(ViewContext& context, const CurvesState& state) {
  const Playback& playback = context.session.playback;
  const float x = std::round(context.time_window.x_of(playback.position()));
  draw_list().AddLine({x, state.area.min.y}, {x, state.area.max.y}, context.theme.cursor, 1.5f);
  if (context.session.document.motion().frame_count() == 0) return;
  const Document& document = context.session.document;
  CurveLabels labels = cursor_labels(context, state, playback.frame());
  for (const CurveLabel& label : labels.list()) {
    const Channel& channel = document.skeleton().channel(label.channel);
    const SmallText value = value_text(channel, document.motion().sample(label.channel, playback.frame()));
    const SmallText text("{} {}", short_name_of(channel), value.view());
    const float width = text_width(context.fonts, text) + 2.0f * kLabelPadding;
    const bool fits_right = x + 8.0f + width <= state.area.max.x;
    draw_chip(context, state.area, {fits_right ? x + 8.0f : x - 8.0f - width, label.y}, text, channel_color(context.theme, channel));
  }
}

void draw_end_letters(ViewContext& context, const CurvesState& state) {
  const Document& document = context.session.document;
  const int last_frame = document.motion().frame_count() - 1;
  const int frame = std::clamp(static_cast<int>(std::floor(context.time_window.last)), 0, last_frame);
  CurveLabels letters;
  for (const ChannelIndex channel : state.shown) {
    const Channel& described = document.skeleton().channel(channel);
    const double value = document.motion().sample(channel, frame);
    const float y = state.axis_of(document.skeleton(), channel).y_of(value);
    if (!std::isfinite(value) || y < state.area.min.y || y > state.area.max.y) continue;
    if (described.joint != context.session.selection.active_joint()) continue;
    letters.add({y - kLabelHeight, channel});
  }
  declutter(letters.list(), state.area);
  const float right = std::min(context.time_window.x_of(frame), state.area.max.x - 4.0f);
  for (const CurveLabel& letter : letters.list()) draw_end_letter(context, letter, right);
}

void draw_hit_label(ViewContext& context, const CurvesState& state) {
  const bool dragging = state.drag.kind == CurveDragKind::Move && state.drag.moved;
  const CurveHit& hit = dragging ? state.drag.grabbed : state.hit;
  const Document& document = context.session.document;
  if (!hit || hit.frame < 0 || hit.frame >= document.motion().frame_count()) return;
  const Channel& channel = document.skeleton().channel(hit.channel);
  const double value = document.motion().sample(hit.channel, hit.frame);
  const ImVec2 place{context.time_window.x_of(hit.frame) + 10.0f,
                     state.axis_of(document.skeleton(), hit.channel).y_of(value) - kLabelHeight - 8.0f};
  draw_chip(context, state.area, place,
            SmallText("{} {}  frame {}  {}", document.skeleton().name(channel.joint), short_name_of(channel), hit.frame + 1,
                      value_text(channel, value).view()),
            context.theme.text);
}

}  // namespace marey::app
