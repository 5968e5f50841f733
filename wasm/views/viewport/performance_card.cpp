#include "wasm/views/viewport/performance_card.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "wasm/app/widgets.h"

namespace marey::app {
namespace {

constexpr float kWidth = 212.0f;
constexpr float kPadding = 10.0f;
constexpr float kInset = 12.0f;
constexpr float kLineHeight = 16.0f;
constexpr float kGraphHeight = 32.0f;
constexpr float kGraphGap = 8.0f;
constexpr float kBelowViewName = 22.0f;
constexpr float kBelowStrobeSetting = 36.0f;
/// A frame at 60 Hz; what takes longer is dropped.
constexpr float kFrameBudget_ms = 1000.0f / 60.0f;
constexpr double kMegabyte = 1e6;

using Text = std::array<char, 48>;

struct Row {
  std::string_view name;
  Text value{};
};

template <class... Values>
Text text_of(fmt::format_string<Values...> format, Values&&... values) {
  Text text{};
  *fmt::format_to_n(text.data(), text.size() - 1, format, std::forward<Values>(values)...).out = '\0';
  return text;
}

Text rate_text(const Performance& performance, bool playing) {
  const double rate = performance.frames_per_second();
  if (rate <= 0.0) return text_of("not played yet");
  return playing ? text_of("{:.0f}", rate) : text_of("{:.0f} when last played", rate);
}

Text memory_text(const Backend::Memory& memory) {
  if (memory.total == 0) return text_of("unknown");
  return text_of("{:.1f} of {:.1f} MB", static_cast<double>(memory.used) / kMegabyte,
                 static_cast<double>(memory.total) / kMegabyte);
}

std::array<Row, 6> rows_of(const ViewContext& context, const Performance& performance) {
  const double samples = static_cast<double>(context.session.document.motion().samples().size() * sizeof(double));
  const FrameCost& last = performance.last();
  return {{{"Frame", text_of("{:.1f} ms, worst {:.1f} ms", performance.median_ms(), performance.worst_ms())},
           {"Draw calls", text_of("{}", last.draw_calls)},
           {"Vertices", text_of("{}", last.vertices)},
           {"Frames/s", rate_text(performance, context.session.playback.is_playing())},
           {"Memory", memory_text(performance.memory)},
           {"Samples", text_of("{:.1f} MB", samples / kMegabyte)}}};
}

/// A bar for each frame, the newest at the right, and a line at the time that a frame has at 60 Hz.
void draw_graph(const ViewContext& context, const Performance& performance, ImVec2 min, ImVec2 max) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  // One slow frame, as when a file is opened, must not flatten all others.
  const float highest = std::clamp(performance.worst_ms(), 1.25f * kFrameBudget_ms, 4.0f * kFrameBudget_ms);
  const float step = (max.x - min.x) / static_cast<float>(Performance::kFramesKept);
  list.AddRectFilled(min, max, with_alpha(context.theme.line, 0.35f), 2.0f);
  for (int i = 0; i < performance.frame_count(); ++i) {
    const float ms = performance.cpu_ms(i);
    const float left = max.x - step * static_cast<float>(performance.frame_count() - i);
    const float top = max.y - std::max(1.0f, (max.y - min.y) * std::min(ms / highest, 1.0f));
    list.AddRectFilled({left, top}, {left + step, max.y}, ms > kFrameBudget_ms ? context.theme.warning : context.theme.accent);
  }
  const float budget = max.y - (max.y - min.y) * kFrameBudget_ms / highest;
  ui::hairline(list, {min.x, budget}, {max.x, budget}, context.theme.dim_text);
}

void draw_row(const ViewContext& context, const Row& row, ImVec2 place, float right) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float size = Fonts::kSmallSize;
  const float width = context.fonts.mono->CalcTextSizeA(size, 1e6f, 0.0f, row.value.data()).x;
  list.AddText(context.fonts.text, size, place, context.theme.dim_text, row.name.data(), row.name.data() + row.name.size());
  list.AddText(context.fonts.mono, size, {std::round(right - width), place.y}, context.theme.text, row.value.data());
}

}  // namespace

void draw_performance_card(ViewContext& context, const Performance& performance, ImVec2 corner, ImVec2 size) {
  const std::array<Row, 6> rows = rows_of(context, performance);
  const float above = kInset + kBelowViewName + (context.options.show_strobe ? kBelowStrobeSetting : 0.0f);
  const float height = 2.0f * kPadding + kGraphHeight + kGraphGap + kLineHeight * static_cast<float>(rows.size());
  const ImVec2 min{std::round(corner.x + kInset), std::round(corner.y + above)};
  const ImVec2 max{min.x + kWidth, min.y + height};
  if (max.x > corner.x + size.x || max.y > corner.y + size.y) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(min, max, with_alpha(context.theme.panel, 0.9f), 6.0f);
  list.AddRect(min, max, context.theme.line, 6.0f, 0, ui::device_pixel());
  float y = min.y + kPadding;
  for (const Row& row : rows) {
    draw_row(context, row, {min.x + kPadding, y}, max.x - kPadding);
    y += kLineHeight;
  }
  draw_graph(context, performance, {min.x + kPadding, y + kGraphGap}, {max.x - kPadding, max.y - kPadding});
  context.items.add("viewport.performance", "Performance", min, max);
}

}  // namespace marey::app
