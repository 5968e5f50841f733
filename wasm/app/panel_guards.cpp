#include "wasm/app/panel_guards.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <utility>

#include "wasm/app/widgets.h"

namespace marey::app {
namespace {

constexpr float kPadding = 12.0f;
constexpr float kWidestText = 420.0f;

/// ImGui's stacks as they are, and the way back to them.
class Recovery {
 public:
  // Looked at and not "written to", as ImGui calls it: the window behind all windows would be shown.
  Recovery()
      : lines_(ImGui::GetCurrentWindowRead()->DrawList),
        clip_rects_(lines_->_ClipRectStack.Size),
        textures_(lines_->_TextureStack.Size) {
    ImGui::ErrorRecoveryStoreState(&state_);
  }

  void go_back() const {
    ImGuiIO& io = ImGui::GetIO();
    const bool asserts = std::exchange(io.ConfigErrorRecoveryEnableAssert, false);
    const bool logs = std::exchange(io.ConfigErrorRecoveryEnableDebugLog, false);
    const bool shows = std::exchange(io.ConfigErrorRecoveryEnableTooltip, false);
    ImGui::ErrorRecoveryTryToRecoverState(&state_);
    io.ConfigErrorRecoveryEnableAssert = asserts;
    io.ConfigErrorRecoveryEnableDebugLog = logs;
    io.ConfigErrorRecoveryEnableTooltip = shows;
    restore_draw_list();
    // A wrap width belongs to the window and is on no stack that ImGui looks after.
    const ImGuiWindow& window = *ImGui::GetCurrentWindowRead();
    while (window.DC.TextWrapPosStack.Size > 0) ImGui::PopTextWrapPos();
    while (window.DC.ItemWidthStack.Size > 0) ImGui::PopItemWidth();
  }

 private:
  void restore_draw_list() const {
    if (lines_->_Splitter._Count > 1) lines_->ChannelsMerge();
    lines_->PathClear();
    while (lines_->_ClipRectStack.Size > clip_rects_) lines_->PopClipRect();
    while (lines_->_TextureStack.Size > textures_) lines_->PopTexture();
    if (lines_->_ClipRectStack.Size > 0) ImGui::GetCurrentWindowRead()->ClipRect = lines_->_ClipRectStack.back();
  }

  ImGuiErrorRecoveryState state_;
  ImDrawList* lines_;
  int clip_rects_;
  int textures_;
};

std::string sentence_of(const Fault& fault, std::string_view name) {
  const std::string panel(name);
  if (fault.out_of_memory) {
    return "There is not enough memory for the " + panel + ". Download your changes, then close other tabs or open a smaller file.";
  }
  return "The " + panel + " met with an error. Everything else goes on, and your file is as it was.";
}

}  // namespace

std::optional<Fault> draw_guarded(const std::function<void()>& draw) {
  const Recovery recovery;
  std::optional<Fault> fault = catch_fault(draw);
  if (fault) recovery.go_back();
  return fault;
}

void PanelGuards::draw(ViewContext& context, std::string_view id, std::string_view name,
                       const std::function<void()>& draw_panel) {
  const bool failed_before = faults_.contains(id);
  const auto draw_it = [&] {
    if (failed_before) {
      draw_fault(context, id);
    } else {
      draw_panel();
    }
  };
  const std::optional<Fault> fault = draw_guarded(std::ref(draw_it));
  // A sentence that cannot be drawn either is left out: it has been told.
  if (!fault || failed_before) return;
  const Report report{sentence_of(*fault, name), std::string(id) + ": " + fault->details};
  faults_.insert_or_assign(std::string(id), report);
  reports_.push_back(report);
  context.redraw = true;
}

void PanelGuards::draw_fault(ViewContext& context, std::string_view id) {
  const auto found = faults_.find(id);
  const Report& report = found->second;
  const ImVec2 size = ImGui::GetWindowSize();
  const ImVec2 min = ImGui::GetWindowPos();
  ImGui::GetWindowDrawList()->AddRectFilled(min, ImVec2(min.x + size.x, min.y + size.y), context.theme.panel);
  const float row = ImGui::GetFrameHeight();
  // A bar has room for one line: the buttons, then as much of the sentence as there is room for.
  const bool bar = size.y < 4.0f * row;
  ImGui::SetCursorPos(ImVec2(kPadding, bar ? std::max(0.0f, (size.y - row) * 0.5f) : kPadding));
  if (!bar) {
    ImGui::PushTextWrapPos(kPadding + std::min(kWidestText, size.x - 2.0f * kPadding));
    ImGui::TextUnformatted(report.sentence.c_str());
    ImGui::PopTextWrapPos();
    context.items.add_last(SmallText("fault.{}", id), report.sentence);
    ImGui::SetCursorPosX(kPadding);
  }
  const bool again = ui::text_button(context, SmallText("fault.{}.retry", id).c_str(), "Try again", "Draws this part of the page again");
  ImGui::SameLine();
  if (ui::text_button(context, SmallText("fault.{}.copy", id).c_str(), "Copy details", "Puts what went wrong on the clipboard")) {
    ImGui::SetClipboardText((report.sentence + "\n" + report.details).c_str());
  }
  if (bar) {
    ImGui::SameLine();
    ui::elided_text(context, report.sentence, std::max(0.0f, size.x - ImGui::GetCursorPosX() - kPadding), context.theme.text);
    context.items.add_last(SmallText("fault.{}", id), report.sentence);
  }
  if (!again) return;
  faults_.erase(found);
  context.redraw = true;
}

std::vector<PanelGuards::Report> PanelGuards::take_reports() { return std::exchange(reports_, {}); }

}  // namespace marey::app
