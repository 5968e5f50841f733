#include "wasm/views/transport_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "wasm/app/widgets.h"

namespace marey::app {
namespace {

constexpr std::array<double, 7> kSpeeds = {0.1, 0.25, 0.5, 1.0, 1.5, 2.0, 4.0};

std::string speed_label(double speed) { return fmt::format("{:g}×", speed); }

std::string rate_label(double frame_time_s) { return fmt::format("{:.4g} fps", display_frame_rate_hz(frame_time_s)); }

float mono_width(const ViewContext& context, const std::string& text) {
  return context.fonts.mono->CalcTextSizeA(Fonts::kTextSize, 1e6f, 0.0f, text.c_str()).x;
}

void mono_text(ViewContext& context, const std::string& text, ImU32 color) {
  ImGui::AlignTextToFramePadding();
  ImGui::PushFont(context.fonts.mono, Fonts::kTextSize);
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
  ImGui::PopFont();
}

}  // namespace

void TransportView::draw_buttons(ViewContext& context) {
  for (const char* id : {"play.first", "play.previous", "play.toggle", "play.next", "play.last"}) {
    const bool primary = std::string_view(id) == "play.toggle";
    ui::command_button(context, id, primary ? ui::ButtonLook::Raised : ui::ButtonLook::Plain);
    ImGui::SameLine(0.0f, 2.0f);
  }
  ImGui::SameLine(0.0f, 10.0f);
  ui::command_button(context, "play.loop");
}

void TransportView::follow_speed(double speed) {
  if (present_speed_ >= 0 && speeds_[idx(present_speed_)] == speed) return;
  speeds_.assign(kSpeeds.begin(), kSpeeds.end());
  auto present = std::lower_bound(speeds_.begin(), speeds_.end(), speed);
  if (present == speeds_.end() || *present != speed) present = speeds_.insert(present, speed);
  present_speed_ = static_cast<int>(present - speeds_.begin());
  speed_options_.clear();
  for (const double each : speeds_) speed_options_.push_back({fmt::format("play.speed.{:g}", each), speed_label(each)});
}

void TransportView::draw_speed(ViewContext& context) {
  Playback& playback = context.session.playback;
  follow_speed(playback.speed());
  int chosen = present_speed_;
  const auto tip = "How fast the clip plays. Below 1× poses are interpolated between frames.";
  if (ui::choice(context, "play.speed", "Speed", tip, speed_options_, chosen, 76.0f)) playback.set_speed(speeds_[idx(chosen)]);
}

void TransportView::draw_position(ViewContext& context) {
  Playback& playback = context.session.playback;
  const Motion& motion = context.session.document.motion();
  const int count = motion.frame_count();
  const bool compact = context.options.compact;
  const auto result = ui::number_field(
      context, "play.frame", "Frame", playback.frame() + 1,
      {.unit = "", .decimals = 0, .step = 0.25, .low = 1.0, .high = static_cast<double>(count > 0 ? count : 1), .width = compact ? 56.0f : 84.0f});
  if (result.event == ui::NumberEvent::Live || result.event == ui::NumberEvent::Committed) {
    playback.set_position(result.value - 1.0);
  }
  ImGui::SameLine(0.0f, 4.0f);
  mono_text(context, fmt::format("/{}", count), context.theme.dim_text);
  ImGui::SameLine(0.0f, compact ? 8.0f : 16.0f);
  const double time_s = playback.position() * motion.frame_time_s();
  const std::string time = fmt::format("{:.{}f} s", time_s, compact ? 2 : 3);
  if (compact && mono_width(context, time) > ImGui::GetContentRegionAvail().x) return ImGui::NewLine();
  mono_text(context, time, context.theme.text);
  if (compact) return;
  ImGui::SameLine(0.0f, 6.0f);
  mono_text(context, fmt::format("/ {:.3f} s", motion.duration_s()), context.theme.dim_text);
  ImGui::SameLine(0.0f, 16.0f);
  mono_text(context, rate_label(motion.frame_time_s()), context.theme.dim_text);
}

void TransportView::draw(ViewContext& context) {
  const ImVec2 corner = ImGui::GetCursorPos();
  ImGui::SetCursorPos({corner.x + 8.0f, corner.y + 6.0f});
  draw_buttons(context);
  if (!context.options.compact) {
    ImGui::SameLine(0.0f, 8.0f);
    draw_speed(context);
  }
  ImGui::SameLine(0.0f, context.options.compact ? 8.0f : 16.0f);
  draw_position(context);
}

}  // namespace marey::app
