#include "wasm/views/curves/curves_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "wasm/views/curves/curves_overlay.h"

namespace marey::app {
namespace {

// Samples get a dot each once they stand this far apart.
constexpr float kDotSpacing = 6.0f;
constexpr float kDotRadius = 2.25f;
constexpr float kSelectedDotRadius = 3.5f;
constexpr float kRestrained = 0.55f;

bool is_hovered(const ViewContext& context, const CurvesState& state, ChannelIndex channel) {
  return state.hit.channel == channel || context.hover.channel == channel;
}

// Curves of the active joint stand before those of the others.
float emphasis_of(const ViewContext& context, const CurvesState& state, ChannelIndex channel) {
  const JointIndex joint = context.session.document.skeleton().channel(channel).joint;
  const bool first = joint == context.session.selection.active_joint();
  return first || is_hovered(context, state, channel) ? 1.0f : kRestrained;
}

struct VisibleFrames {
  int first = 0;
  int last = -1;
};

VisibleFrames visible_frames(const TimeWindow& time, FrameRange within) {
  return {std::max(within.first, static_cast<int>(std::floor(time.first))),
          std::min(within.end() - 1, static_cast<int>(std::ceil(time.last)))};
}

void draw_dots(ViewContext& context, const CurvesState& state, ChannelIndex channel, ImU32 color) {
  const TimeWindow& time = context.time_window;
  if (time.frames_per_unit() * static_cast<double>(kDotSpacing) > 1.0) return;
  const Motion& motion = context.session.document.motion();
  const ValueAxis& axis = state.axis_of(context.session.document.skeleton(), channel);
  const VisibleFrames frames = visible_frames(time, {0, motion.frame_count()});
  for (int frame = frames.first; frame <= frames.last; ++frame) {
    const double value = motion.sample(channel, frame);
    if (!std::isfinite(value)) continue;
    ImGui::GetWindowDrawList()->AddCircleFilled({time.x_of(frame), axis.y_of(value)}, kDotRadius, color, 10);
  }
}

void draw_selected(ViewContext& context, const CurvesState& state, const SampleRun& run) {
  const TimeWindow& time = context.time_window;
  const ValueAxis& axis = state.axis_of(context.session.document.skeleton(), run.channel);
  const auto samples = context.session.document.motion().channel_samples(run.channel);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const VisibleFrames frames = visible_frames(time, run.frames);
  // Closer than a unit apart, dots would only pile up on the same pixels.
  const int stride = std::max(1, static_cast<int>(time.frames_per_unit() * 2.0));
  for (int frame = frames.first; frame <= frames.last; frame += stride) {
    if (!std::isfinite(samples[idx(frame)])) continue;
    const ImVec2 center{time.x_of(frame), axis.y_of(samples[idx(frame)])};
    list.AddCircleFilled(center, kSelectedDotRadius, context.theme.selection, 14);
    if (stride == 1) list.AddCircle(center, kSelectedDotRadius, context.theme.panel, 14, 1.0f);
  }
}

void draw_selection(ViewContext& context, const CurvesState& state) {
  for (const SampleRun& run : context.session.selection.samples().runs()) {
    if (std::find(state.shown.begin(), state.shown.end(), run.channel) != state.shown.end()) {
      draw_selected(context, state, run);
    }
  }
}

void draw_grids(ViewContext& context, const CurvesState& state) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(state.area.min, state.area.max, with_alpha(context.theme.app, 0.45f));
  draw_frame_grid(list, state.area, context.time_window, context.theme);
  if (state.shows_angles || state.shows_lengths) {
    draw_value_grid(list, state.area, state.shows_angles ? state.angles : state.lengths, context.theme);
  }
}

}  // namespace

ImU32 channel_color(const Theme& theme, const Channel& channel) {
  return channel.kind == ChannelKind::Other ? theme.middle : theme.axis[static_cast<int>(axis_of(channel.kind))];
}

void CurvesDrawing::draw_strips(ImDrawList& list, ImU32 color, float width) {
  for (const CurveShape::Strip& strip : shape_.strips()) {
    const auto points = shape_.points(strip);
    list.AddPolyline(points.data(), strip.count, color, ImDrawFlags_None, width);
  }
}

void CurvesDrawing::draw_ghost(ViewContext& context, const CurvesState& state, ChannelIndex channel) {
  const auto saved = context.session.document.saved_samples(channel);
  if (saved.empty()) return;
  shape_.build(saved, context.time_window, state.axis_of(context.session.document.skeleton(), channel));
  draw_strips(*ImGui::GetWindowDrawList(), with_alpha(context.theme.ghost, 0.8f), 1.25f);
}

void CurvesDrawing::draw_curve(ViewContext& context, const CurvesState& state, ChannelIndex channel) {
  const Document& document = context.session.document;
  const Channel& described = document.skeleton().channel(channel);
  const ImU32 color =
      with_alpha(channel_color(context.theme, described), emphasis_of(context, state, channel));
  const bool strong = is_hovered(context, state, channel);
  shape_.build(document.motion().channel_samples(channel), context.time_window,
               state.axis_of(document.skeleton(), channel));
  // Positions are drawn thinner than rotations: the same axis colour, another quantity.
  const float width = is_rotation(described.kind) ? 1.75f : 1.25f;
  draw_strips(*ImGui::GetWindowDrawList(), color, strong ? width + 1.0f : width);
  draw_dots(context, state, channel, color);
}

void CurvesDrawing::draw(ViewContext& context, const CurvesState& state) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_grids(context, state);
  list.PushClipRect(state.area.min, state.area.max, true);
  draw_range_shade(context, state);
  draw_falloff_band(context, state);
  for (const ChannelIndex channel : state.shown) draw_ghost(context, state, channel);
  for (const ChannelIndex channel : state.shown) draw_curve(context, state, channel);
  draw_selection(context, state);
  draw_end_letters(context, state);
  draw_box(context, state);
  draw_cursor(context, state);
  draw_hit_label(context, state);
  list.PopClipRect();
  const Fonts& fonts = context.fonts;
  if (state.shows_angles) {
    draw_value_labels(list, state.area, state.angles, AxisSide::Left, "°", context.theme, fonts);
  }
  if (state.shows_lengths) {
    const AxisSide side = state.shows_angles ? AxisSide::Right : AxisSide::Left;
    draw_value_labels(list, state.area, state.lengths, side, "units", context.theme, fonts);
  }
}

}  // namespace marey::app
