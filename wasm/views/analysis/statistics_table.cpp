#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/signal/range_statistics.h"
#include "wasm/app/widgets.h"
#include "wasm/views/analysis/plots_view.h"

namespace marey::app {
namespace {

constexpr std::array kColumns = {"Quantity", "Of", "Unit", "Lowest", "at", "Highest", "at", "Mean", "RMS"};
constexpr int kFirstNumber = 3;
constexpr int kEventTime = 4;
constexpr float kPadding = 12.0f;

void draw_number(ViewContext& context, const SmallText& text) {
  ImGui::TableNextColumn();
  ImGui::PushFont(context.fonts.mono, Fonts::kSmallSize);
  const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
  if (room > 0.0f) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopFont();
}

void draw_header(ViewContext& context) {
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
  for (int i = 0; i < size_of(kColumns); ++i) {
    ImGui::TableSetColumnIndex(i);
    const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(kColumns[idx(i)]).x;
    if (i >= kFirstNumber && room > 0.0f) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room);
    ui::dim_text(context, kColumns[idx(i)]);
  }
}

/// The clip that a row is of: the open one, or one beside it, with its own frames.
struct RowClip {
  std::string name;  ///< "" for the open one
  double frame_time_s = 1.0;
  FrameRange frames;  ///< those within the seconds of the range
};

RowClip open_clip(const Session& session) { return {"", session.document.motion().frame_time_s(), session.playback.range()}; }

// The last frame of the range belongs to it.
RowClip clip_beside(const Session& session, const OtherClip& other, double frame_time_s) {
  const RowClip open = open_clip(session);
  constexpr double kRounding = 1e-9;
  const auto frame_at = [&](FrameIndex frame) { return frame * open.frame_time_s / frame_time_s; };
  const auto first = static_cast<FrameIndex>(std::ceil(std::min(frame_at(open.frames.first) - kRounding, 1e9)));
  const auto last = static_cast<FrameIndex>(std::floor(std::min(frame_at(open.frames.end() - 1) + kRounding, 1e9)));
  return {ui::displayable(other.file_name), frame_time_s, {first, std::max(last - first + 1, 0)}};
}

void draw_line(ViewContext& context, const AnalysisPlot& plot, const PlotLine& line, const RowClip& clip, int row) {
  const std::string& clip_name = clip.name;
  const FrameIndex first = std::min(clip.frames.first, size_of(line.values));
  const auto found = find_range_statistics(line.values, {first, std::min(clip.frames.end(), size_of(line.values)) - first});
  const double frame_time = clip.frame_time_s;
  const auto time_of = [&](FrameIndex frame) { return SmallText("{:.3f} s", frame * frame_time); };
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const char letter[] = {' ', line.component == 0 ? '\0' : static_cast<char>(line.component - 'x' + 'X'), '\0'};
  ui::elided_text(context, SmallText("{}{}", plot.choice.quantity->label, letter[1] == '\0' ? "" : letter), ImGui::GetContentRegionAvail().x,
                  component_color(context.theme, line.component));
  ImGui::TableNextColumn();
  const SmallText whose("{}{}{}", plot.whose(), clip_name.empty() ? "" : " · ", clip_name);
  ui::elided_text(context, whose, ImGui::GetContentRegionAvail().x, clip_name.empty() ? context.theme.text : context.theme.dim_text);
  context.items.add_last(SmallText("plots.statistics.{}.of", row), whose);
  ImGui::TableNextColumn();
  ui::dim_text(context, plot.unit);
  if (!found) return;
  draw_number(context, value_text(found->least));
  context.items.add_last(SmallText("plots.statistics.{}.lowest", row), value_text(found->least));
  draw_number(context, time_of(found->least_frame));
  draw_number(context, value_text(found->greatest));
  context.items.add_last(SmallText("plots.statistics.{}.highest", row), value_text(found->greatest));
  draw_number(context, time_of(found->greatest_frame));
  draw_number(context, value_text(found->mean));
  draw_number(context, value_text(found->rms));
}

// The same component of the clips beside the open one, below it; the next row.
int draw_others(ViewContext& context, const AnalysisPlot& plot, char component, int row) {
  const Session& session = context.session;
  for (std::size_t other = 0; other < std::min(plot.others.size(), session.others.size()); ++other) {
    const RowClip clip = clip_beside(session, *session.others[other], plot.others[other].frame_time_s);
    for (const PlotLine& line : plot.others[other].own) {
      if (line.component == component) draw_line(context, plot, line, clip, row++);
    }
  }
  return row;
}

// When a foot touches or leaves the ground, below the column of times.
void draw_events(ViewContext& context, FrameRange range) {
  const Document& document = context.session.document;
  int row = 0;
  for (const MotionEvent& event : context.analysis.events()) {
    if (event.frame < range.first || event.frame >= range.end()) continue;
    const std::string words = describe(event, document.skeleton());
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ui::elided_text(context, words, ImGui::GetContentRegionAvail().x, context.theme.text);
    context.items.add_last(SmallText("plots.event.{}", row++), words);
    ImGui::TableSetColumnIndex(kEventTime - 1);
    draw_number(context, SmallText("{:.3f} s", event.frame * document.motion().frame_time_s()));
  }
}

}  // namespace

void draw_statistics(ViewContext& context, ImVec2 min, ImVec2 max) {
  const FrameRange range = context.session.playback.range();
  ImGui::SetCursorScreenPos({min.x + kPadding, min.y});
  const ImVec2 size{max.x - min.x - 2.0f * kPadding, max.y - min.y - 4.0f};
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_SizingStretchProp;
  if (!ImGui::BeginTable("plots.statistics", size_of(kColumns), kFlags, size)) return;
  ImGui::TableSetupScrollFreeze(0, 1);
  for (std::size_t i = 0; i < kColumns.size(); ++i) {
    const SmallText id("{}##{}", kColumns[i], i);
    ImGui::TableSetupColumn(id.c_str(), ImGuiTableColumnFlags_None, i == 0 ? 2.2f : i == 1 ? 1.6f : 1.0f);
  }
  draw_header(context);
  int row = 0;
  for (const AnalysisPlot& plot : context.analysis.plots()) {
    for (const PlotLine& line : plot.lines) {
      draw_line(context, plot, line, open_clip(context.session), row++);
      row = draw_others(context, plot, line.component, row);
    }
  }
  draw_events(context, range);
  ImGui::EndTable();
  context.items.add_last("plots.statistics", SmallText("Frames {} to {}", range.first + 1, range.end()));
}

}  // namespace marey::app
