#include "wasm/views/analysis/contact_strip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/editing/contact_edits.h"
#include "wasm/app/widgets.h"
#include "wasm/views/analysis/plot_row.h"
#include "wasm/views/time_gutter.h"

namespace marey::app {
namespace {

constexpr float kHeaderHeight = 22.0f;
constexpr float kRowHeight = 18.0f;
constexpr float kTouchRowHeight = 32.0f;
constexpr float kInset = 12.0f;
constexpr float kLegendBar = 16.0f;
constexpr const char* kMenu = "contacts.menu";

// Those that people have set are taller; a contact that was taken out is hollow.
void draw_bar(const Theme& theme, const ContactBar& bar, float left, float right, float middle) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float half = bar.is_own ? 5.0f : 3.0f;
  const ImVec2 min{left, middle - half};
  const ImVec2 max{std::max(right, left + 2.0f), middle + half};
  if (bar.touches) list.AddRectFilled(min, max, bar.is_own ? theme.accent : with_alpha(theme.dim_text, 0.75f), 2.0f);
  else list.AddRect(min, max, theme.accent, 2.0f, 0, 1.5f);
}

void draw_header(ViewContext& context, std::span<const ContactRow> rows, int hidden, ImVec2 min) {
  const float x = context.options.compact ? context.time_window.left + 4.0f : min.x + kInset;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddText(context.fonts.semibold, Fonts::kTextSize, {x, min.y + 2.0f}, context.theme.text, "Contacts");
  ImVec2 at{context.options.compact ? x + 76.0f : context.time_window.left, min.y + 4.0f};
  const auto add = [&](const char* text) {
    list.AddText(context.fonts.text, Fonts::kSmallSize, at, context.theme.dim_text, text);
    at.x += 16.0f + context.fonts.text->CalcTextSizeA(Fonts::kSmallSize, 1e4f, 0.0f, text).x;
  };
  constexpr std::array kKinds = {ContactBar{0, 0, true, false}, ContactBar{0, 0, true, true}, ContactBar{0, 0, false, true}};
  constexpr std::array kWords = {"detected", "set by hand", "taken out by hand"};
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    const bool is_shown = std::any_of(rows.begin(), rows.end(), [&](const ContactRow& row) {
      return std::any_of(row.bars.begin(), row.bars.end(),
                         [&](const ContactBar& bar) { return bar.touches == kKinds[i].touches && bar.is_own == kKinds[i].is_own; });
    });
    if (!is_shown) continue;
    draw_bar(context.theme, kKinds[i], at.x, at.x + kLegendBar, at.y + 6.0f);
    at.x += kLegendBar + 6.0f;
    add(kWords[i]);
  }
  if (hidden > 0) add(SmallText("{} more below", hidden).c_str());
}

const ContactBar* bar_at(const ContactRow& row, FrameIndex frame) {
  const auto found = std::find_if(row.bars.begin(), row.bars.end(),
                                  [&](const ContactBar& bar) { return bar.first <= frame && frame <= bar.last; });
  return found == row.bars.end() ? nullptr : &*found;
}

SmallText frames_text(FrameRange frames) {
  return frames.count == 1 ? SmallText("frame {}", frames.first + 1) : SmallText("frames {} to {}", frames.first + 1, frames.end());
}

FrameIndex frame_under_pointer(const ViewContext& context) {
  const double frame = std::round(context.time_window.frame_at(ImGui::GetIO().MousePos.x));
  return static_cast<FrameIndex>(std::clamp(frame, 0.0, static_cast<double>(context.session.document.motion().frame_count() - 1)));
}

}  // namespace

void ContactStrip::handle_row(ViewContext& context, const ContactRow& row, int index, ImVec2 min, ImVec2 max) {
  ImGui::SetCursorScreenPos({context.time_window.left, min.y});
  const SmallText id("contacts.row.{}", index);
  ImGui::InvisibleButton(id.c_str(), {context.time_window.right - context.time_window.left, max.y - min.y},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  context.items.add_last(id, row.name);
  const FrameIndex here = frame_under_pointer(context);
  if (ImGui::IsItemActivated()) dragged_from_ = here;
  if (ImGui::IsItemActive() || ImGui::IsItemDeactivated()) {
    asked_node_ = row.node;
    asked_frames_ = hull({dragged_from_, 1}, {here, 1});
    const ContactBar* bar = bar_at(row, here);
    if (asked_frames_.count == 1 && bar != nullptr) asked_frames_ = {bar->first, bar->last - bar->first + 1};
  }
  asks_ = asks_ || ImGui::IsItemDeactivated();
  if (!ImGui::IsItemHovered()) return;
  context.status = "Click a bar, or drag over frames, to correct what touches the floor.";
  zoom_by_wheel(context);
}

void ContactStrip::draw_row(ViewContext& context, const ContactRow& row, int index, ImVec2 min, ImVec2 max) {
  const TimeWindow& time = context.time_window;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  handle_row(context, row, index, min, max);
  list.PushClipRect({time.left, min.y}, {time.right, max.y}, true);
  list.AddRectFilled({time.left, min.y + 1.0f}, {time.right, max.y - 1.0f}, with_alpha(context.theme.app, 0.45f));
  const bool is_asked = asked_node_ == row.node && (ImGui::IsItemActive() || ImGui::IsPopupOpen(kMenu));
  if (is_asked) {
    list.AddRectFilled({time.x_of(asked_frames_.first - 0.5), min.y + 1.0f}, {time.x_of(asked_frames_.end() - 0.5), max.y - 1.0f},
                       with_alpha(context.theme.accent, 0.25f));
  }
  // On a narrow page the name stands in the row, above its bars.
  const bool is_narrow = context.options.compact;
  const float middle = is_narrow ? max.y - 9.0f : 0.5f * (min.y + max.y);
  for (const ContactBar& bar : row.bars) {
    if (bar.last + 1 < time.first || bar.first - 1 > time.last) continue;
    draw_bar(context.theme, bar, time.x_of(bar.first - 0.5), time.x_of(bar.last + 0.5), middle);
  }
  const float x = std::round(time.x_of(context.session.playback.position()));
  list.AddLine({x, min.y}, {x, max.y}, context.theme.cursor, 1.5f);
  list.PopClipRect();
  const float left = is_narrow ? time.left + 4.0f : min.x + kInset;
  ImGui::PushFont(context.fonts.text, Fonts::kSmallSize + 1.0f);
  ImGui::SetCursorScreenPos({left, std::round(is_narrow ? min.y + 2.0f : middle - 7.0f)});
  ui::elided_text(context, row.name, is_narrow ? time.right - left : kChannelListWidth - kInset, context.theme.dim_text);
  ImGui::PopFont();
}

void ContactStrip::draw_menu(ViewContext& context) const {
  if (!ImGui::BeginPopup(kMenu)) return;
  ui::popup_shadow(context);
  const Clip& clip = context.session.document.clip();
  if (asked_node_ < clip.skeleton.node_count()) {
    ui::dim_text(context, SmallText("{}, {}", node_label(clip.skeleton, asked_node_), frames_text(asked_frames_).view()));
  }
  struct Choice {
    const char* id;
    const char* label;
    std::optional<bool> touches;
  };
  for (const Choice& choice : {Choice{"contacts.menu.on", "Contact", true}, Choice{"contacts.menu.off", "No contact", false},
                               Choice{"contacts.menu.auto", "As detected", std::nullopt}}) {
    const bool chosen = ImGui::Selectable(choice.label);
    context.items.add_last(choice.id, choice.label);
    if (!chosen) continue;
    const Status status = context.session.apply(make_contact_edit(clip, std::span(&asked_node_, 1), asked_frames_, choice.touches));
    if (!status) context.refusal = status.error().message;
    context.redraw = true;
    break;
  }
  ImGui::EndPopup();
}

float ContactStrip::draw(ViewContext& context, ImVec2 min, ImVec2 max) {
  const std::span<const ContactRow> rows = context.analysis.contacts();
  const float height = context.options.touch || context.options.compact ? kTouchRowHeight : kRowHeight;
  const int fitting = static_cast<int>((max.y - min.y - kHeaderHeight) / height);
  const int count = std::min(fitting, size_of(rows));
  if (count <= 0) return 0.0f;
  draw_header(context, rows, size_of(rows) - count, min);
  float y = min.y + kHeaderHeight;
  for (int i = 0; i < count; ++i, y += height) draw_row(context, rows[idx(i)], i, {min.x, y}, {max.x, y + height});
  if (std::exchange(asks_, false)) ImGui::OpenPopup(kMenu);
  draw_menu(context);
  y += 4.0f;
  ImGui::GetWindowDrawList()->AddLine({min.x, y}, {max.x, y}, context.theme.line);
  return y - min.y;
}

}  // namespace marey::app
