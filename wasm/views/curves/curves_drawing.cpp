#include "wasm/views/curves/curves_drawing.h"

#include <algorithm>
#include <cmath>

#include "wasm/views/curves/curves_overlay.h"
#include "wasm/views/curves/key_marks.h"

namespace marey::app {
namespace {

// Samples get a dot each once they stand this far apart.
constexpr float kDotSpacing = 6.0f;
constexpr float kDotRadius = 2.25f;
constexpr float kSelectedDotRadius = 3.5f;

struct VisibleFrames {
  int first = 0;
  int last = -1;
};

VisibleFrames visible_frames(const TimeWindow& time, FrameRange within) {
  return {std::max(within.first, static_cast<int>(std::floor(time.first))),
          std::min(within.end() - 1, static_cast<int>(std::ceil(time.last)))};
}

void draw_dots(ViewContext& context, const CurvesState& state, ChannelIndex channel) {
  const TimeWindow& time = context.time_window;
  if (time.frames_per_unit() * static_cast<double>(kDotSpacing) > 1.0) return;
  if (state.shown.size() > kMostCurvesInDetail && !is_curve_hovered(context, state, channel)) return;
  const ImU32 color = curve_color(context, state, channel);
  const Motion& motion = context.session.document.motion();
  const ValueAxis& axis = state.axis_of(context.session.document.skeleton(), channel);
  const VisibleFrames frames = visible_frames(time, {0, motion.frame_count()});
  for (int frame = frames.first; frame <= frames.last; ++frame) {
    const double value = motion.sample(channel, frame);
    if (!std::isfinite(value)) continue;
    ImGui::GetWindowDrawList()->AddCircleFilled({time.x_of(frame), axis.y_of(value)}, kDotRadius, color, 10);
  }
}

// Calls back with the selected frames of a channel that are in sight, none closer than `stride` to the one before.
template <class Visit>
void visit_selected(std::span<const SampleRun> runs, VisibleFrames frames, int stride, const Visit& visit) {
  int frame = frames.first;
  auto run = runs.begin();
  while (frame <= frames.last) {
    run = std::partition_point(run, runs.end(), [frame](const SampleRun& r) { return r.frames.end() <= frame; });
    if (run == runs.end() || run->frames.first > frames.last) return;
    frame = std::max(frame, run->frames.first);
    visit(frame);
    frame += stride;
  }
}

struct SelectedLook {
  bool many = false;
  bool ringed = false;
};

void draw_selected_dot(ImDrawList& list, const Theme& theme, ImVec2 center, SelectedLook look) {
  const ImDrawListFlags flags = list.Flags;
  if (look.many) list.Flags &= ~ImDrawListFlags_AntiAliasedFill;
  list.AddCircleFilled(center, kSelectedDotRadius, theme.selection, look.many ? 6 : 14);
  list.Flags = flags;
  if (look.ringed) list.AddCircle(center, kSelectedDotRadius, theme.panel, 14, 1.0f);
}

void draw_selection(ViewContext& context, const CurvesState& state) {
  const TimeWindow& time = context.time_window;
  const Document& document = context.session.document;
  const SampleSelection& selection = context.session.selection.samples();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  // Closer than two units apart, dots would only pile up on the same pixels.
  const bool many = state.shown.size() > kMostCurvesInDetail;
  const int stride = std::max(1, static_cast<int>(time.frames_per_unit() * (many ? 4.0 : 2.0)));
  for (const ChannelIndex channel : state.shown) {
    const std::span<const SampleRun> runs = selection.runs_of(channel);
    if (runs.empty()) continue;
    const ValueAxis& axis = state.axis_of(document.skeleton(), channel);
    const auto samples = document.motion().channel_samples(channel);
    visit_selected(runs, visible_frames(time, {0, size_of(samples)}), stride, [&](int frame) {
      if (!std::isfinite(samples[idx(frame)])) return;
      const ImVec2 center{time.x_of(frame), axis.y_of(samples[idx(frame)])};
      draw_selected_dot(list, context.theme, center, {many, !many && stride == 1});
    });
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

void CurvesDrawing::draw(ViewContext& context, const CurvesState& state) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_grids(context, state);
  list.PushClipRect(state.area.min, state.area.max, true);
  draw_range_shade(context, state);
  draw_falloff_band(context, state);
  lines_.draw(context, state);
  for (const ChannelIndex channel : state.shown) draw_dots(context, state, channel);
  draw_selection(context, state);
  draw_key_marks(context, state);
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
