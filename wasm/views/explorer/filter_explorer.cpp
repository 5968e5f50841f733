#include "wasm/views/explorer/filter_explorer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/signal/derivative.h"
#include "wasm/app/widgets.h"
#include "wasm/views/curves/curve_lines.h"
#include "wasm/views/curves/curves_state.h"
#include "wasm/views/graph/small_plot.h"

namespace marey::app {
namespace {

constexpr int kMostFrames = 8192;  // that are looked at together
constexpr float kLeastWidth = 180.0f;

// The samples without the newest step of undo, which is the previewed operation.
std::vector<double> samples_before_step(const Document& document, ChannelIndex channel, bool has_step) {
  const auto present = document.motion().channel_samples(channel);
  std::vector<double> samples(present.begin(), present.end());
  const Edit* edit = has_step ? document.history().undo_edit() : nullptr;
  if (edit == nullptr) return samples;
  for (const SamplesChange& change : edit->samples) {
    if (change.channel == channel) std::copy(change.values.begin(), change.values.end(), samples.begin() + change.first);
  }
  return samples;
}

std::vector<double> part_of(const std::vector<double>& samples, FrameRange frames) {
  return {samples.begin() + frames.first, samples.begin() + frames.end()};
}

// The cut-off that the form asks for, Hz; 0 where it has none.
double asked_cutoff_hz(const OperationForm& form) {
  if (!form.is_open()) return 0.0;
  const int place = find_parameter(*form.operation(), "cutoff");
  return place < 0 ? 0.0 : form.values().numbers[idx(place)];
}

}  // namespace

void FilterExplorer::choose_channel(ViewContext& context, const OperationForm& form, const std::vector<ChannelIndex>& shown) {
  const Skeleton& skeleton = context.session.document.skeleton();
  if (std::find(shown.begin(), shown.end(), channel_) == shown.end()) {
    channel_ = shown.front();
    if (form.is_open() && !form.target().channels.empty()) {
      const ChannelIndex wanted = form.target().channels.front();
      if (std::find(shown.begin(), shown.end(), wanted) != shown.end()) channel_ = wanted;
    }
    known_ = false;
  }
  std::vector<ui::ChoiceOption> options;
  int chosen = 0;
  for (int i = 0; i < size_of(shown); ++i) {
    options.push_back({fmt::format("explorer.channel.{}", shown[idx(i)]), channel_label(skeleton, shown[idx(i)])});
    if (shown[idx(i)] == channel_) chosen = i;
  }
  if (ui::choice(context, "explorer.channel", "Channel", "The curve that is looked at.", options, chosen, 220.0f)) {
    channel_ = shown[idx(chosen)];
    known_ = false;
  }
}

FilterExplorer::State FilterExplorer::look_at(std::vector<double> curve, double rate_hz) {
  State state;
  state.curve = std::move(curve);
  state.acceleration.resize(state.curve.size());
  compute_second_derivative(state.curve, rate_hz, state.acceleration);
  state.spectrum = compute_spectrum(state.curve, rate_hz);
  for (std::size_t i = 0; i < state.spectrum.amplitudes.size(); ++i) {
    state.hertz.push_back(static_cast<double>(i) * state.spectrum.step_hz);
  }
  return state;
}

void FilterExplorer::follow(const ViewContext& context, bool is_previewed) {
  const Document& document = context.session.document;
  const bool same = known_ && clip_serial_ == context.clip_serial && revision_ == document.revision();
  if (same) return;
  known_ = true;
  clip_serial_ = context.clip_serial;
  revision_ = document.revision();
  const int count = document.motion().frame_count();
  const int length = std::min(count, kMostFrames);
  frames_ = {std::clamp(context.session.playback.frame() - length / 2, 0, count - length), length};
  const double rate_hz = 1.0 / document.motion().frame_time_s();
  std::vector<double> former = part_of(samples_before_step(document, channel_, is_previewed), frames_);
  if (former != before_.curve) {
    residuals_ = analyse_residuals(former, rate_hz);
    cutoffs_.clear();
    rms_.clear();
    for (const Residual& residual : residuals_.residuals) {
      cutoffs_.push_back(residual.cutoff_hz);
      rms_.push_back(residual.rms);
    }
    before_ = look_at(std::move(former), rate_hz);
  }
  after_ = look_at(part_of(samples_before_step(document, channel_, false), frames_), rate_hz);
  change_ = find_deviation(before_.curve, after_.curve);
  differs_ = after_.curve != before_.curve;
  seconds_.clear();
  for (int i = 0; i < frames_.count; ++i) seconds_.push_back((frames_.first + i) * document.motion().frame_time_s());
}

void FilterExplorer::draw_plots(ViewContext& context, const OperationForm& form, ImVec2 min, ImVec2 max) const {
  const Channel& channel = context.session.document.skeleton().channel(channel_);
  const bool angle = is_rotation(channel.kind);
  const ImU32 color = channel_color(context.theme, channel);
  const ImU32 faint = with_alpha(context.theme.dim_text, 0.7f);
  const double half_rate = 0.5 / context.session.document.motion().frame_time_s();
  const double asked = asked_cutoff_hz(form);
  const double cutoff = asked > 0.0 || !form.is_open() ? asked : residuals_.cutoff_hz;
  const SmallText cutoff_name("{:.3g} Hz", cutoff);
  const SmallText suggested_name("suggested {:.3g} Hz", residuals_.cutoff_hz);
  const PlotMark now{context.session.playback.position() * context.session.document.motion().frame_time_s(), context.theme.cursor, ""};
  const std::array<PlotMark, 2> marks = {PlotMark{cutoff > 0.0 ? cutoff : -1.0, context.theme.accent, cutoff_name},
                                         PlotMark{residuals_.cutoff_hz > 0.0 ? residuals_.cutoff_hz : -1.0, context.theme.ok, suggested_name}};
  const double from = seconds_.empty() ? 0.0 : seconds_.front();
  const double to = seconds_.empty() ? 1.0 : seconds_.back();
  const auto pair = [&](const std::vector<double>& x, const std::vector<double>& a, const std::vector<double>& x2, const std::vector<double>& b) {
    return std::array<PlotCurve, 2>{PlotCurve{x, a, differs_ ? faint : color, 1.25f}, PlotCurve{x2, b, color, 1.75f}};
  };
  const auto curves = pair(seconds_, before_.curve, seconds_, after_.curve);
  const auto accelerations = pair(seconds_, before_.acceleration, seconds_, after_.acceleration);
  const auto spectra = pair(before_.hertz, before_.spectrum.amplitudes, after_.hertz, after_.spectrum.amplitudes);
  const std::array<PlotCurve, 1> residual = {PlotCurve{cutoffs_, rms_, color, 1.75f}};
  const std::size_t shown = differs_ ? 2 : 1;
  const char* unit = angle ? "°" : "units";
  const std::array<SmallPlot, 4> plots = {
      SmallPlot{"Curve", "s", unit, from, to, std::span(curves).first(shown), std::span(&now, 1), {}, false},
      SmallPlot{"Second derivative", "s", angle ? "°/s²" : "u/s²", from, to, std::span(accelerations).first(shown), std::span(&now, 1), {}, false},
      SmallPlot{"Spectrum", "Hz", unit, 0.0, half_rate, std::span(spectra).first(shown), marks, {}, true},
      SmallPlot{"Residual of the cut-off", "Hz", unit, 0.0, half_rate, residual, marks, {}, true}};
  for (int i = 0; i < size_of(plots); ++i) {
    const ImVec4 place = plot_place(i, size_of(plots), min, max, kLeastWidth);
    draw_small_plot(context, SmallText("explorer.plot.{}", i).c_str(), {place.x, place.y}, {place.z, place.w}, plots[idx(i)]);
  }
}

void FilterExplorer::draw_advice(ViewContext& context, bool is_open, float right) const {
  const char* unit = is_rotation(context.session.document.skeleton().channel(channel_).kind) ? "°" : " units";
  const SmallText text = !is_open   ? SmallText("Open a filter under Edit to see what it does.")
                         : differs_ ? SmallText("Grey is before, coloured after: RMS {:.3g}{}, at most {:.3g}{} at frame {}.", change_.rms,
                                                unit, change_.largest, unit, frames_.first + change_.at + 1)
                                    : SmallText("Nothing changes in this curve.");
  const float room = right - ImGui::GetCursorScreenPos().x - 12.0f - 3.0f * (ImGui::GetFrameHeight() + 2.0f);
  ui::elided_text(context, text, std::max(room, 1.0f), context.theme.dim_text);
  context.items.add_last("explorer.change", text);
}

void FilterExplorer::draw(ViewContext& context, const OperationForm& form, const std::vector<ChannelIndex>& shown, ImVec2 min,
                          ImVec2 max) {
  ImGui::SetCursorScreenPos({min.x + 8.0f, min.y + 4.0f});
  choose_channel(context, form, shown);
  ImGui::SameLine(0.0f, 12.0f);
  ImGui::AlignTextToFramePadding();
  follow(context, form.is_previewed());
  draw_advice(context, form.is_open(), max.x);
  draw_plots(context, form, {min.x + 4.0f, min.y + ImGui::GetFrameHeight() + 12.0f}, max);
}

}  // namespace marey::app
