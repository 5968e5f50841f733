#include "wasm/views/analysis/clip_legend.h"

#include <algorithm>
#include <optional>

#include "wasm/app/icons.h"
#include "wasm/app/widgets.h"
#include "wasm/views/analysis/plot_row.h"

namespace marey::app {
namespace {

constexpr float kHeight = 26.0f;
constexpr float kInset = 12.0f;
constexpr float kLine = 34.0f;
constexpr float kGap = 8.0f;
constexpr float kMostName = 220.0f;

// A line as the plots draw it, and a name; where it ends.
float draw_entry(ViewContext& context, ImVec2 at, float room, std::string_view name, float width, Dashes dashes) {
  CurveShape shape;
  const TimeWindow time{.first = 0.0, .last = 1.0, .left = at.x, .right = at.x + kLine};
  ValueAxis axis;
  axis.low = -1.0;
  axis.high = 1.0;
  axis.top = at.y;
  axis.bottom = at.y + kHeight;
  const double middle[] = {0.0, 0.0};
  shape.build(middle, time, axis);
  shape.draw(*ImGui::GetWindowDrawList(), context.theme.dim_text, width, dashes);
  ImGui::SetCursorScreenPos({at.x + kLine + kGap, at.y + 0.5f * (kHeight - ImGui::GetTextLineHeight())});
  const float name_width = std::min(ImGui::CalcTextSize(name.data(), name.data() + name.size()).x, room - kLine - kGap);
  ui::elided_text(context, name, name_width + 1.0f, context.theme.text);
  return at.x + kLine + kGap + name_width + kGap;
}

}  // namespace

float draw_clip_legend(ViewContext& context, ImVec2 min, float width) {
  Session& session = context.session;
  if (session.others.empty()) return 0.0f;
  const float button = ImGui::GetFrameHeight();
  const float count = static_cast<float>(session.others.size() + 1);
  const float room = std::min((width - 2.0f * kInset) / count - button - kGap, kMostName);
  float x = draw_entry(context, {min.x + kInset, min.y}, room, ui::displayable(session.document.file_name()), 1.75f, {});
  std::optional<std::size_t> removed;
  for (std::size_t i = 0; i < session.others.size(); ++i) {
    const std::string name = ui::displayable(session.others[i]->file_name);
    x = draw_entry(context, {x + kGap, min.y}, room, name, 1.25f, dashes_of(i));
    context.items.add_last(SmallText("plots.other.{}", i), name);
    ImGui::SetCursorScreenPos({x - 4.0f, min.y + 0.5f * (kHeight - button)});
    if (ui::icon_button(context, SmallText("plots.other.{}.remove", i).c_str(), icons::kX, "Take away. The file is not changed.")) removed = i;
    x += button;
  }
  if (removed) {
    session.others.erase(session.others.begin() + static_cast<std::ptrdiff_t>(*removed));
    context.redraw = true;
  }
  return kHeight;
}

}  // namespace marey::app
