#include "wasm/views/curves/curve_lines.h"

#include <algorithm>

namespace marey::app {
namespace {

// From this many samples in a column on, extremes say more than samples.
constexpr double kDenseSamplesPerColumn = 2.0;
constexpr double kDenseSamplesOfMany = 1.0;
constexpr float kRestrained = 0.55f;
constexpr float kGhostAlpha = 0.8f;
// Positions are drawn thinner than rotations: the same axis colour, another quantity.
constexpr float kRotationWidth = 1.75f;
constexpr float kPositionWidth = 1.25f;
constexpr float kGhostWidth = 1.25f;
constexpr float kHoveredWider = 1.0f;

bool are_many(const CurvesState& state) { return state.shown.size() > kMostCurvesInDetail; }

}  // namespace

bool is_curve_hovered(const ViewContext& context, const CurvesState& state, ChannelIndex channel) {
  return state.hit.channel == channel || context.hover.channel == channel;
}

ImU32 channel_color(const Theme& theme, const Channel& channel) {
  return channel.kind == ChannelKind::Other ? theme.middle : theme.axis[static_cast<int>(axis_of(channel.kind))];
}

ImU32 curve_color(const ViewContext& context, const CurvesState& state, ChannelIndex channel) {
  const Channel& described = context.session.document.skeleton().channel(channel);
  const bool first = described.joint == context.session.selection.active_joint();
  const bool stands_out = first || is_curve_hovered(context, state, channel);
  return with_alpha(channel_color(context.theme, described), stands_out ? 1.0f : kRestrained);
}

bool CurveLines::follow(const ViewContext& context, const CurvesState& state) {
  const Document& document = context.session.document;
  const Theme& theme = context.theme;
  cache_.follow(document, context.clip_serial);
  // The former list keeps its memory.
  std::vector<ChannelIndex> shown = std::move(look_.shown);
  const bool same_shown = shown == state.shown;
  if (!same_shown) shown.assign(state.shown.begin(), state.shown.end());
  look_.shown.clear();
  Look look{.clip_serial = context.clip_serial,
            .revision = document.revision(),
            .saves = document.save_count(),
            .time = context.time_window,
            .angles = state.angles,
            .lengths = state.lengths,
            .hit = state.hit.channel,
            .hovered = context.hover.channel,
            .active = context.session.selection.active_joint(),
            .colors = {theme.axis[0], theme.axis[1], theme.axis[2], theme.middle, theme.ghost},
            .shown = {}};
  const bool same = known_ && same_shown && look == look_;
  look_ = std::move(look);
  look_.shown = std::move(shown);
  known_ = true;
  return !same;
}

CurveLines::Line CurveLines::line_of(const ViewContext& context, const CurvesState& state, ChannelIndex channel) const {
  const float width =
      is_rotation(context.session.document.skeleton().channel(channel).kind) ? kRotationWidth : kPositionWidth;
  const bool hovered = is_curve_hovered(context, state, channel);
  return {channel, curve_color(context, state, channel), hovered ? width + kHoveredWider : width};
}

void CurveLines::add_line(const ViewContext& context, const CurvesState& state, const Line& line) {
  const Document& document = context.session.document;
  const ValueAxis& axis = state.axis_of(document.skeleton(), line.channel);
  if (dense_) {
    const auto extents = line.ghost ? cache_.saved_columns(document, line.channel, columns_)
                                    : cache_.columns(document, line.channel, columns_);
    band_.build(extents, columns_, context.time_window, axis);
    band_.add_to(batch_, line.color, line.width);
  } else {
    const auto samples = line.ghost ? document.saved_samples(line.channel) : document.motion().channel_samples(line.channel);
    shape_.build(samples, context.time_window, axis);
    if (are_many(state)) {
      shape_.add_to(batch_, line.color, line.width);
    } else {
      shape_.draw(*ImGui::GetWindowDrawList(), line.color, line.width);
    }
  }
}

void CurveLines::add_lines(const ViewContext& context, const CurvesState& state) {
  for (const ChannelIndex channel : state.shown) {
    if (context.session.document.saved_samples(channel).empty()) continue;
    add_line(context, state, {channel, with_alpha(context.theme.ghost, kGhostAlpha), kGhostWidth, true});
  }
  for (const ChannelIndex channel : state.shown) add_line(context, state, line_of(context, state, channel));
}

void CurveLines::draw(const ViewContext& context, const CurvesState& state) {
  columns_ = visible_columns(context.time_window, context.session.document.motion().frame_count());
  dense_ = columns_.frames_per_column >= (are_many(state) ? kDenseSamplesOfMany : kDenseSamplesPerColumn);
  const bool changed = follow(context, state);
  if (!dense_ && !are_many(state)) {
    add_lines(context, state);
    return;
  }
  if (changed) {
    batch_.begin();
    batch_.lines = !dense_;
    add_lines(context, state);
    batch_.finish();
  }
  add_curve_batch(*ImGui::GetWindowDrawList(), batch_);
}

}  // namespace marey::app
