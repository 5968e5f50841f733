#include "wasm/views/analysis/clip_legend.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "wasm/app/icons.h"
#include "wasm/app/widgets.h"
#include "wasm/views/analysis/plot_row.h"

namespace marey::app {
namespace {

constexpr float kLeastRow = 26.0f;
constexpr float kInset = 12.0f;
constexpr float kLine = 34.0f;
constexpr float kGap = 8.0f;
constexpr float kMostName = 220.0f;

/// Entries from left to right, and in further rows where there is no room.
class Legend {
 public:
  Legend(ViewContext& context, ImVec2 min, float width)
      : context_(context), min_(min), right_(min.x + width - kInset), row_(std::max(kLeastRow, ImGui::GetFrameHeight())), at_{min.x + kInset, min.y} {}

  // A line as the plots draw it, a name, and room for what comes behind it.
  void add(std::string_view name, float width, Dashes dashes, float behind) {
    const float most = std::min(kMostName, right_ - min_.x - kInset - kLine - 2.0f * kGap - behind);
    const float name_width = std::min(ImGui::CalcTextSize(name.data(), name.data() + name.size()).x, most);
    const float needs = kLine + kGap + name_width + kGap + behind;
    if (at_.x + needs > right_ && at_.x > min_.x + kInset) at_ = {min_.x + kInset, at_.y + row_};
    const float middle = std::round(at_.y + 0.5f * row_) + 0.5f;
    const ImVec2 line[] = {{at_.x, middle}, {at_.x + kLine, middle}};
    stroke_dashed(*ImGui::GetWindowDrawList(), line, context_.theme.dim_text, width, dashes);
    ImGui::SetCursorScreenPos({at_.x + kLine + kGap, at_.y + 0.5f * (row_ - ImGui::GetTextLineHeight())});
    ui::elided_text(context_, name, name_width + 1.0f, context_.theme.text);
    behind_ = {at_.x + needs - behind, at_.y + 0.5f * (row_ - ImGui::GetFrameHeight())};
    at_.x += needs + kGap;
  }
  [[nodiscard]] ImVec2 behind() const { return behind_; }
  [[nodiscard]] float height() const { return at_.y + row_ - min_.y; }

 private:
  ViewContext& context_;
  ImVec2 min_;
  float right_;
  float row_;
  ImVec2 at_;
  ImVec2 behind_;
};

}  // namespace

float draw_clip_legend(ViewContext& context, ImVec2 min, float width) {
  Session& session = context.session;
  if (session.others.empty()) return 0.0f;
  Legend legend(context, min, width);
  legend.add(ui::displayable(session.document.file_name()), 1.75f, {}, 0.0f);
  std::optional<int> removed;
  for (std::size_t i = 0; i < session.others.size(); ++i) {
    const std::string name = ui::displayable(session.others[i]->file_name);
    legend.add(name, 1.25f, dashes_of(i), ImGui::GetFrameHeight());
    context.items.add_last(SmallText("plots.other.{}", i), name);
    ImGui::SetCursorScreenPos(legend.behind());
    if (ui::icon_button(context, SmallText("plots.other.{}.remove", i).c_str(), icons::kX, "Take away. The file is not changed.")) removed = static_cast<int>(i);
  }
  if (removed) {
    session.take_away(*removed);
    context.redraw = true;
  }
  return legend.height();
}

}  // namespace marey::app
