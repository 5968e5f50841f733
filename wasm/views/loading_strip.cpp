#include "wasm/views/loading_strip.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "wasm/app/icons.h"
#include "wasm/app/widgets.h"

namespace marey::app {
namespace {

constexpr float kPadding = 12.0f;
constexpr float kVerticalPadding = 8.0f;
constexpr float kBarHeight = 3.0f;
constexpr float kGap = 12.0f;
constexpr float kLeastTitle = 96.0f;

double elapsed_of(const ViewContext& context, const FileLoading& loading) {
  return loading.begun_s ? context.now_s - *loading.begun_s : 0.0;
}

double share_of(const FileLoading& loading) {
  if (loading.size() <= 0) return 0.0;
  return std::clamp(static_cast<double>(loading.fed_bytes()) / static_cast<double>(loading.size()), 0.0, 1.0);
}

std::string megabytes(std::int64_t bytes) {
  const double mb = static_cast<double>(bytes) / 1e6;
  return mb < 9.95 ? fmt::format("{:.1f}", mb) : fmt::format("{:.0f}", mb);
}

}  // namespace

std::string progress_text(std::int64_t fed_bytes, std::int64_t size, double elapsed_s) {
  constexpr double kTimeToJudge_s = 0.5;
  if (size <= 0) return megabytes(fed_bytes) + " MB";
  std::string text = fmt::format("{} of {} MB", megabytes(std::min(fed_bytes, size)), megabytes(size));
  if (elapsed_s < kTimeToJudge_s || fed_bytes <= 0) return text;
  const double left_s = elapsed_s * static_cast<double>(std::max<std::int64_t>(size - fed_bytes, 0)) / static_cast<double>(fed_bytes);
  return text + fmt::format(", {:.0f} s left", std::ceil(left_s));
}

float LoadingStrip::height(const ViewContext& context, const FileLoading* loading) const {
  if (loading == nullptr || elapsed_of(context, *loading) < FileLoading::kPatience_s) return 0.0f;
  return ImGui::GetFrameHeight() + 2.0f * kVerticalPadding + kBarHeight;
}

void LoadingStrip::draw(ViewContext& context, const FileLoading& loading) {
  context.redraw = true;
  const ImVec2 min = ImGui::GetWindowPos();
  const float width = ImGui::GetWindowWidth();
  const ImVec2 max(min.x + width, min.y + ImGui::GetWindowHeight());
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(min, max, with_alpha(context.theme.accent, 0.1f));
  list.AddRectFilled(ImVec2(min.x, max.y - kBarHeight), max, with_alpha(context.theme.accent, 0.2f));
  const float filled = width * static_cast<float>(share_of(loading));
  list.AddRectFilled(ImVec2(min.x, max.y - kBarHeight), ImVec2(min.x + filled, max.y), context.theme.accent);

  const Command* stop = context.commands.find("file.cancel_loading");
  const float button_width = context.options.compact ? ImGui::GetFrameHeight() : ImGui::CalcTextSize(stop->label.c_str()).x + 52.0f;
  const std::string progress = progress_text(loading.fed_bytes(), loading.size(), elapsed_of(context, loading));
  const float progress_width = ImGui::CalcTextSize(progress.c_str()).x;
  const float button_x = width - kPadding - button_width;
  const float text_y = kVerticalPadding + 0.5f * (ImGui::GetFrameHeight() - ImGui::GetTextLineHeight());
  const float title_width = std::max(kLeastTitle, button_x - kGap - progress_width - kGap - kPadding);

  ImGui::SetCursorPos(ImVec2(kPadding, text_y));
  ImGui::PushFont(context.fonts.semibold, 0.0f);
  ui::elided_text(context, "Reading " + ui::displayable(loading.file_name()), title_width, context.theme.text);
  ImGui::PopFont();
  ImGui::SetCursorPos(ImVec2(button_x - kGap - progress_width, text_y));
  ImGui::TextUnformatted(progress.c_str());
  context.items.add_last("loading.progress", progress);
  ImGui::SetCursorPos(ImVec2(button_x, kVerticalPadding));
  ui::command_button(context, "file.cancel_loading", ui::ButtonLook::Raised, !context.options.compact, ".strip");
}

}  // namespace marey::app
