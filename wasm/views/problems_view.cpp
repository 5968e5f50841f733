#include "wasm/views/problems_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "core/text/readable.h"
#include "core/text/utf8.h"
#include "wasm/app/builtin_commands.h"
#include "wasm/app/icons.h"
#include "wasm/app/widgets.h"
#include "wasm/views/problems/problem_entry.h"

namespace marey::app {
namespace {

constexpr float kPadding = 12.0f;
constexpr float kLineHeight = 18.0f;

std::string place_text(const Diagnostic& diagnostic) {
  std::string text = diagnostic.place.line > 0
                         ? fmt::format("line {}, column {}", diagnostic.place.line, diagnostic.place.column)
                         : std::string("whole file");
  if (diagnostic.count > 1) text += fmt::format(", {} times", diagnostic.count);
  return text;
}

void draw_nothing_found(const ViewContext& context, bool has_clip) {
  ImGui::SetCursorPosX(kPadding);
  ImGui::PushStyleColor(ImGuiCol_Text, has_clip ? context.theme.ok : context.theme.dim_text);
  ImGui::TextUnformatted(has_clip ? icons::kCircleCheck : icons::kFile);
  ImGui::PopStyleColor();
  ImGui::SameLine(0.0f, 8.0f);
  ImGui::PushTextWrapPos(ImGui::GetWindowWidth() - kPadding);
  ui::dim_text(context, has_clip ? "Nothing to report: the file reads as it is written." : "No file is open.");
  ImGui::PopTextWrapPos();
}

/// Where the lines of an excerpt stand; what does not fit is cut off, the place never.
struct ExcerptLayout {
  ImVec2 min, max;
  float letter;         ///< width of an ASCII letter
  float text_x;
  std::size_t skipped;  ///< letters at the front of each line
};

float mono_width(const ViewContext& context, std::string_view text) {
  return context.fonts.mono->CalcTextSizeA(Fonts::kSmallSize, 1e6f, 0.0f, text.data(), text.data() + text.size()).x;
}

ExcerptLayout lay_out_excerpt(const ViewContext& context, const TextExcerpt& excerpt, std::size_t number_width) {
  ExcerptLayout layout;
  layout.min = ImGui::GetCursorScreenPos();
  layout.max = {layout.min.x + ImGui::GetContentRegionAvail().x - kPadding,
                layout.min.y + kLineHeight * static_cast<float>(size_of(excerpt.lines)) + 8.0f};
  layout.letter = mono_width(context, "0");
  layout.text_x = layout.min.x + layout.letter * static_cast<float>(number_width) + 18.0f;
  const auto fitting = static_cast<std::size_t>(std::max(layout.max.x - layout.text_x, 0.0f) / layout.letter);
  const std::string_view marked = excerpt.lines[idx(excerpt.marked_line)];
  const std::size_t before = count_letters(marked.substr(0, idx(excerpt.marked_byte)));
  layout.skipped = before - std::min(before, fitting * 2 / 3);
  return layout;
}

void draw_excerpt_line(const ViewContext& context, const ExcerptLayout& layout, float y, const std::string& number,
                       const std::string& line) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const std::string_view text = without_letters(line, layout.skipped);
  list.AddText(context.fonts.mono, Fonts::kSmallSize, {layout.min.x + 8.0f, y}, context.theme.dim_text, number.c_str());
  list.AddText(context.fonts.mono, Fonts::kSmallSize, {layout.text_x, y}, context.theme.text, text.data(),
               text.data() + text.size());
}

}  // namespace

void ProblemsView::draw_excerpt(ViewContext& context, int index) const {
  const CharacterSet set = context.session.document.settings().names_in;
  const TextExcerpt excerpt = readable(context.session.excerpts[idx(index)], set);
  const std::size_t number_width = fmt::formatted_size("{}", excerpt.first_line + size_of(excerpt.lines) - 1);
  const ExcerptLayout layout = lay_out_excerpt(context, excerpt, number_width);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(layout.min, layout.max, context.theme.app, 4.0f);
  list.PushClipRect(layout.min, layout.max, true);
  const float marked_y = layout.min.y + 4.0f + kLineHeight * static_cast<float>(excerpt.marked_line);
  list.AddRectFilled({layout.min.x, marked_y}, {layout.max.x, marked_y + kLineHeight}, with_alpha(context.theme.accent, 0.15f));
  for (int i = 0; i < size_of(excerpt.lines); ++i) {
    draw_excerpt_line(context, layout, layout.min.y + 5.0f + kLineHeight * static_cast<float>(i),
                      fmt::format("{:>{}}", excerpt.first_line + i, number_width), excerpt.lines[idx(i)]);
  }
  const std::string_view before = std::string_view(excerpt.lines[idx(excerpt.marked_line)]).substr(0, idx(excerpt.marked_byte));
  const float x = layout.text_x + mono_width(context, without_letters(before, layout.skipped));
  list.AddRectFilled({x, marked_y + kLineHeight - 2.0f}, {x + layout.letter, marked_y + kLineHeight}, context.theme.warning);
  list.PopClipRect();
  ImGui::Dummy({layout.max.x - layout.min.x, layout.max.y - layout.min.y});
  context.items.add_last(fmt::format("problems.excerpt.{}", index), excerpt.lines[idx(excerpt.marked_line)]);
  ImGui::Dummy(ImVec2(0.0f, 4.0f));
}

void ProblemsView::draw_entry(ViewContext& context, const Diagnostic& diagnostic, int index) {
  const bool has_excerpt = index < size_of(context.session.excerpts) && !context.session.excerpts[idx(index)].lines.empty();
  ProblemEntry entry;
  entry.id = fmt::format("problems.entry.{}", index);
  entry.severity = diagnostic.severity;
  entry.message = diagnostic.message;
  entry.details = {place_text(diagnostic)};
  if (has_excerpt) entry.click_help = "Click to see the place in the text of the file.";
  if (draw_problem_entry(context, entry)) unfolded_ = unfolded_ == index ? -1 : index;
  ImGui::Indent(kPadding);
  if (unfolded_ == index) draw_excerpt(context, index);
  ImGui::Unindent(kPadding);
  if (choices_.draw_below(context, diagnostic.code)) ImGui::Dummy(ImVec2(0.0f, 4.0f));
  end_problem_entry(context);
}

void ProblemsView::draw(ViewContext& context) {
  if (clip_serial_ != context.clip_serial) {
    clip_serial_ = context.clip_serial;
    unfolded_ = -1;
    choices_ = {};
  }
  const Document& document = context.session.document;
  const auto& list = document.diagnostics().list();
  const bool has_clip = document.skeleton().joint_count() > 0;
  ImGui::Dummy(ImVec2(0.0f, 12.0f));
  if (list.empty()) draw_nothing_found(context, has_clip);
  for (int i = 0; i < size_of(list); ++i) draw_entry(context, list[idx(i)], i);
  if (!has_clip) return;
  lint_.update(context);
  if (!lint_.empty() || is_first_frame_left_out(document)) lint_.draw(context, choices_);
  choices_.draw_assumptions(context);
  ImGui::Dummy(ImVec2(0.0f, 16.0f));
}

}  // namespace marey::app
