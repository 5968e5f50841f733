#include "wasm/views/save_as_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "wasm/app/icons.h"
#include "wasm/app/widgets.h"
#include "wasm/views/inspector/property_row.h"
#include "wasm/views/overlay_window.h"

namespace marey::app {
namespace {

constexpr ImVec2 kSize(460.0f, 500.0f);
constexpr float kIndent = 8.0f;  // brings the rows' padding under the title
constexpr std::array kDecimals = {2, 3, 4, 5, 6, 8, 10};
constexpr int kTables = 2;

std::vector<ui::ChoiceOption> form_options() {
  std::vector<ui::ChoiceOption> options = {{"save_as.form.bvh", "BVH as the file is"}};
  for (const TargetTraits& target : export_targets()) {
    options.push_back({fmt::format("save_as.form.{}", target.id), fmt::format("BVH for {}", target.name)});
  }
  options.push_back({"save_as.form.channels", "Table of channels (CSV)"});
  options.push_back({"save_as.form.positions", "Table of positions (CSV)"});
  return options;
}

int option_of(const SaveAs& wanted) {
  if (wanted.form == SavedForm::ChannelTable) return kExportTargetCount + 1;
  if (wanted.form == SavedForm::PositionTable) return kExportTargetCount + kTables;
  return wanted.target ? static_cast<int>(*wanted.target) + 1 : 0;
}

void set_option(SaveAs& wanted, int option) {
  wanted.target.reset();
  wanted.form = SavedForm::Bvh;
  if (option > kExportTargetCount) {
    wanted.form = option == kExportTargetCount + 1 ? SavedForm::ChannelTable : SavedForm::PositionTable;
  } else if (option > 0) {
    wanted.target = static_cast<ExportTarget>(option - 1);
  }
}

std::string form_tip(const SaveAs& wanted) {
  return wanted.target ? std::string(traits_of(*wanted.target).audience) : "The program or the form that the copy is for.";
}

}  // namespace

void SaveAsView::follow_clip(const ViewContext& context) {
  const int frame_count = context.session.document.motion().frame_count();
  if (clip_serial_ == context.clip_serial && frame_count_ == frame_count) return;
  if (clip_serial_ != context.clip_serial) {
    wanted_ = {};
    described_.reset();
  }
  clip_serial_ = context.clip_serial;
  frame_count_ = frame_count;
  first_ = 1;
  last_ = frame_count;
}

void SaveAsView::draw_form(ViewContext& context) {
  const float width = inspector::begin_row(context, "For");
  const std::vector<ui::ChoiceOption> options = form_options();
  int option = option_of(wanted_);
  if (ui::choice(context, "save_as.form", "For", form_tip(wanted_), options, option, width)) set_option(wanted_, option);
  inspector::end_row();
}

void SaveAsView::draw_numbers(ViewContext& context) {
  std::vector<ui::ChoiceOption> options = {{"save_as.decimals.all", "All, exactly"}};
  int decimals = 0;
  for (int i = 0; i < size_of(kDecimals); ++i) {
    options.push_back({fmt::format("save_as.decimals.{}", kDecimals[idx(i)]), fmt::format("{}", kDecimals[idx(i)])});
    if (wanted_.options.decimals == kDecimals[idx(i)]) decimals = i + 1;
  }
  float width = inspector::begin_row(context, "Decimals");
  if (ui::choice(context, "save_as.decimals", "Decimals", "Of samples and offsets. The frame time stays.", options, decimals, width)) {
    wanted_.options.decimals.reset();
    if (decimals > 0) wanted_.options.decimals = kDecimals[idx(decimals - 1)];
  }
  inspector::end_row();
  const std::array<ui::ChoiceOption, 3> ends = {ui::ChoiceOption{"save_as.line_ends.same", "As they are"},
                                                ui::ChoiceOption{"save_as.line_ends.lf", "LF (Linux, macOS)"},
                                                ui::ChoiceOption{"save_as.line_ends.crlf", "CR LF (Windows)"}};
  int end = wanted_.options.line_end ? 1 + static_cast<int>(*wanted_.options.line_end) : 0;
  width = inspector::begin_row(context, "Line ends");
  if (ui::choice(context, "save_as.line_ends", "Line ends", "How the lines of the text end.", ends, end, width)) {
    wanted_.options.line_end.reset();
    if (end > 0) wanted_.options.line_end = static_cast<LineEnd>(end - 1);
  }
  inspector::end_row();
}

void SaveAsView::draw_frames(ViewContext& context) {
  if (frame_count_ > 0) {
    const float width = inspector::begin_row(context, "Frames");
    const float field = std::floor((width - 32.0f) * 0.5f);
    const auto number = [&](const char* id, const char* label, int& value, int low, int high) {
      const auto result = ui::number_field(context, id, label, value,
                                           {.unit = "", .decimals = 0, .step = 1.0, .low = static_cast<double>(low),
                                            .high = static_cast<double>(high), .width = field});
      if (result.event != ui::NumberEvent::None) value = std::clamp(static_cast<int>(std::lround(result.value)), low, high);
    };
    number("save_as.first", "First frame", first_, 1, last_);
    ImGui::SameLine(0.0f, 0.0f);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddText(ImVec2(at.x + 10.0f, at.y + 0.5f * (ImGui::GetFrameHeight() - Fonts::kTextSize)),
                                        context.theme.dim_text, "to");
    ImGui::SameLine(0.0f, 32.0f);
    number("save_as.last", "Last frame", last_, first_, frame_count_);
    inspector::end_row();
  }
  const bool all = first_ == 1 && last_ == frame_count_;
  wanted_.options.frames = all ? FrameRange{} : FrameRange{first_ - 1, last_ - first_ + 1};
}

void SaveAsView::draw_differences(ViewContext& context) {
  const Document& document = context.session.document;
  if (described_ != wanted_ || described_revision_ != document.revision()) {
    differences_ = describe_copy(document, wanted_);
    described_ = wanted_;
    described_revision_ = document.revision();
  }
  inspector::heading(context, "In what the copy differs");
  const float height = ImGui::GetContentRegionAvail().y - ImGui::GetFrameHeight() - 2.0f * inspector::kPadding;
  ImGui::BeginChild("differences", ImVec2(0.0f, std::max(height, 40.0f)), ImGuiChildFlags_NavFlattened);
  const auto line = [&](const std::string& text, int index) {
    ImGui::SetCursorPosX(inspector::kPadding);
    ImGui::PushTextWrapPos(ImGui::GetWindowWidth() - inspector::kPadding);
    ImGui::TextUnformatted(text.c_str(), text.c_str() + text.size());
    ImGui::PopTextWrapPos();
    context.items.add_last(fmt::format("save_as.difference.{}", index), text);
    ImGui::Dummy(ImVec2(0.0f, 6.0f));
  };
  if (differences_.empty()) line("In nothing: it is the opened file, byte for byte where its style is uniform.", 0);
  for (int i = 0; i < size_of(differences_); ++i) line(ui::displayable(differences_[idx(i)]), i);
  ImGui::EndChild();
}

bool SaveAsView::draw_download(ViewContext& context) {
  const std::string name = ui::displayable(copy_name(context.session.document, wanted_));
  const float button = context.fonts.semibold->CalcTextSizeA(Fonts::kTextSize, 1e6f, 0.0f, "Download").x + 20.0f;
  const float bottom = ImGui::GetWindowHeight() - ImGui::GetFrameHeight() - inspector::kPadding;
  ImGui::SetCursorPos(ImVec2(inspector::kPadding, bottom + 0.5f * (ImGui::GetFrameHeight() - ImGui::GetTextLineHeight())));
  ui::elided_text(context, name, ImGui::GetWindowWidth() - button - 3.0f * inspector::kPadding, context.theme.dim_text);
  context.items.add_last("save_as.name", name);
  ImGui::SetCursorPos(ImVec2(ImGui::GetWindowWidth() - inspector::kPadding - button, bottom));
  return ui::text_button(context, "save_as.download", "Download", "Saves the copy. The open clip stays as it is.",
                         ui::ButtonLook::Primary);
}

void SaveAsView::draw(ViewContext& context, bool& open) {
  follow_clip(context);
  begin_overlay(context, {"##save_as", kSize, 0.4f}, open);
  draw_overlay_title(context, "Download as", "save_as.close", open);
  ImGui::SetCursorPosX(kIndent);
  ImGui::BeginChild("rows", ImVec2(ImGui::GetWindowWidth() - 2.0f * kIndent, ImGui::GetContentRegionAvail().y - kIndent),
                    ImGuiChildFlags_NavFlattened);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0f, 0.0f));
  draw_form(context);
  if (wanted_.form == SavedForm::Bvh) draw_numbers(context);
  draw_frames(context);
  draw_differences(context);
  const bool pressed = draw_download(context);
  ImGui::PopStyleVar();
  ImGui::EndChild();
  end_overlay();
  if (!pressed) return;
  context.commands.run("file.save_as", arguments_of(wanted_));
  open = false;
}

}  // namespace marey::app
