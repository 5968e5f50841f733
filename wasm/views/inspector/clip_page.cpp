#include "wasm/views/inspector/clip_page.h"

#include <fmt/format.h>

#include <string>

#include "core/editing/clip_operations.h"
#include "wasm/app/widgets.h"
#include "wasm/views/inspector/property_row.h"
#include "wasm/views/number_edit.h"

namespace marey::app {
namespace {

void draw_content(ViewContext& context) {
  const Document& document = context.session.document;
  const Motion& motion = document.motion();
  inspector::heading(context, "Content");
  inspector::text_row(context, "File", ui::displayable(document.file_name()));
  inspector::text_row(context, "Joints", fmt::format("{}", document.skeleton().joint_count()), true);
  inspector::text_row(context, "Channels", fmt::format("{}", document.skeleton().channel_count()), true);
  inspector::text_row(context, "Frames", fmt::format("{}", motion.frame_count()), true);
  inspector::text_row(context, "Duration", fmt::format("{:.3f} s", motion.duration_s()), true);
}

void draw_names_preview(ViewContext& context, CharacterSet set) {
  constexpr int kMostNames = 4;
  const std::string text = fmt::format("{}", fmt::join(telling_names(context.session.document.skeleton(), set, kMostNames), ", "));
  ImGui::SetCursorPosX(inspector::kPadding + 12.0f);
  ui::elided_text(context, text, ImGui::GetContentRegionAvail().x - inspector::kPadding, context.theme.dim_text);
  context.items.add_last(fmt::format("inspector.names_in.{}", traits_of(set).id), text);
}

void draw_up_axis(ViewContext& context) {
  inspector::begin_row(context, "Up axis");
  ui::command_button(context, "clip.up_axis.y", ui::ButtonLook::Raised, true, "@inspector");
  ImGui::SameLine(0.0f, 4.0f);
  ui::command_button(context, "clip.up_axis.z", ui::ButtonLook::Raised, true, "@inspector");
  inspector::end_row();
}

void draw_position_choice(ViewContext& context) {
  std::vector<const char*> ids = {"clip.positions.replace", "clip.positions.add"};
  if (has_joints_that_add(context.session.document.skeleton())) ids.push_back("clip.positions.per_joint");
  for (const char* id : ids) {
    ImGui::SetCursorPosX(inspector::kPadding);
    ui::command_button(context, id, ui::ButtonLook::Raised, true, "@inspector");
    inspector::end_row();
  }
}

}  // namespace

namespace inspector {

void draw_frame_time(ViewContext& context) {
  const Motion& motion = context.session.document.motion();
  const float width = begin_row(context, "Frame time");
  const auto result = ui::number_field(context, "inspector.frame_time", "Frame time", motion.frame_time_s(),
                                       {.unit = "s", .decimals = 6, .step = 0.0001, .low = 1e-5, .high = 100.0, .width = width});
  apply_number(context, result, [&](const Clip&) { return make_frame_time_edit(result.value); });
  end_row();
  text_row(context, "Frame rate", fmt::format("{:.5g} fps", display_frame_rate_hz(motion.frame_time_s())), true);
}

void draw_unit(ViewContext& context) {
  const Document& document = context.session.document;
  const float width = begin_row(context, "One unit is");
  const auto result = ui::number_field(context, "inspector.metres_per_unit", "One unit is", document.settings().metres_per_unit,
                                       {.unit = "m", .decimals = 5, .step = 0.0005, .low = 1e-6, .high = 1e6, .width = width});
  apply_number(context, result, [&](const Clip& clip) {
    ClipSettings settings = clip.settings;
    settings.metres_per_unit = result.value;
    return make_settings_edit(clip, settings);
  });
  end_row();
  const double stature = compute_stature(document.skeleton());
  text_row(context, "Stature",
                      fmt::format("{:.2f} units {:6.2f} m", stature, stature * document.settings().metres_per_unit), true);
}

void draw_names_choice(ViewContext& context) {
  const Document& document = context.session.document;
  const bool is_open = telling_names(document.skeleton(), CharacterSet::Utf8, 1).size() == 1;
  if (!is_open || document.style().encoding != TextEncoding::Bytes) return;
  for (const CharacterSet set : kCharacterSets) {
    ImGui::SetCursorPosX(kPadding);
    ui::command_button(context, fmt::format("clip.names_in.{}", traits_of(set).id), ui::ButtonLook::Raised, true, "@inspector");
    draw_names_preview(context, set);
    end_row();
  }
}

}  // namespace inspector

void draw_clip_page(ViewContext& context) {
  draw_content(context);
  inspector::heading(context, "Time");
  inspector::draw_frame_time(context);
  inspector::heading(context, "Length");
  inspector::draw_unit(context);
  inspector::heading(context, "Reading");
  draw_up_axis(context);
  draw_position_choice(context);
  inspector::draw_names_choice(context);
  ImGui::Dummy({0.0f, 16.0f});
}

}  // namespace marey::app
