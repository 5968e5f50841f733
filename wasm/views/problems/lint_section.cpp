#include "wasm/views/problems/lint_section.h"

#include <fmt/format.h>

#include <numeric>

#include "core/base/counted.h"
#include "wasm/app/builtin_commands.h"
#include "wasm/app/widgets.h"
#include "wasm/views/inspector/property_row.h"
#include "wasm/views/problems/problem_entry.h"

namespace marey::app {
namespace {

// Looking through so many samples takes about a tenth of a second.
constexpr std::size_t kMostSamplesUnasked = 1'000'000;

std::string list_tools(std::span<const std::string_view> tools) {
  std::string text;
  for (const std::string_view tool : tools) text.append(text.empty() ? "Known to stumble: " : ", ").append(tool);
  return text.empty() ? text : text + ".";
}

std::string place_of(const Finding& finding) {
  if (!finding.frames) return {};
  const int first = finding.frames->first + 1;
  const int last = finding.frames->end();
  return first == last ? fmt::format("frame {}", first) : fmt::format("frames {} to {}", first, last);
}

void go_to(ViewContext& context, const Finding& finding) {
  Session& session = context.session;
  if (finding.joint) session.selection.select_only(*finding.joint);
  if (!finding.frames) return;
  session.playback.set_playing(false);
  session.playback.set_position(finding.frames->first);
}

}  // namespace

void LintSection::look(const ViewContext& context) {
  report_ = lint_clip(context.session.document.clip());
  clip_serial_ = context.clip_serial;
  revision_ = context.session.document.revision();
  is_stale_ = false;
}

void LintSection::update(const ViewContext& context) {
  const Document& document = context.session.document;
  is_stale_ = clip_serial_ == context.clip_serial && revision_ != document.revision();
  const bool is_new = clip_serial_ != context.clip_serial;
  const bool is_short = document.motion().samples().size() <= kMostSamplesUnasked;
  if (is_new || (is_stale_ && is_short && !ImGui::IsAnyMouseDown())) look(context);
}

void LintSection::draw_finding(ViewContext& context, const Finding& finding, int index) const {
  const FindingTraits& traits = traits_of(finding.kind);
  ProblemEntry entry;
  entry.id = fmt::format("problems.finding.{}", index);
  entry.message = ui::displayable(finding.message);
  entry.details.emplace_back(traits.suggestion);
  for (const std::string& line : {list_tools(traits.tools), place_of(finding)}) {
    if (!line.empty()) entry.details.push_back(line);
  }
  if (finding.joint || finding.frames) entry.click_help = "Click to go there.";
  if (draw_problem_entry(context, entry)) go_to(context, finding);
}

void LintSection::draw_left_out(ViewContext& context) const {
  const int left_out = std::accumulate(report_.left_out.begin(), report_.left_out.end(), 0);
  if (left_out == 0) return;
  ImGui::SetCursorPosX(inspector::kPadding);
  ui::dim_text(context, fmt::format("{} of the same kinds are not listed.", counted(left_out, "smaller finding")));
  ImGui::Dummy(ImVec2(0.0f, 4.0f));
}

void LintSection::draw(ViewContext& context, ReadingChoices& choices) {
  inspector::heading(context, "In the motion and the figure");
  if (is_stale_) {
    ImGui::SetCursorPosX(inspector::kPadding);
    if (ui::text_button(context, "problems.look_again", "Look again", "The clip has changed since it was looked through.")) {
      look(context);
    }
    ImGui::Dummy(ImVec2(0.0f, 4.0f));
  }
  const Document& document = context.session.document;
  for (int i = 0; i < size_of(report_.findings); ++i) {
    const Finding& finding = report_.findings[idx(i)];
    draw_finding(context, finding, i);
    if (finding.kind == FindingKind::ReferencePose) choices.draw_first_frame(context);
    end_problem_entry(context);
  }
  if (is_first_frame_left_out(document)) {
    ImGui::SetCursorPosX(inspector::kPadding);
    ui::dim_text(context, "The first frame of the file is left out.");
    ImGui::Dummy(ImVec2(0.0f, 4.0f));
    choices.draw_first_frame(context);
    end_problem_entry(context);
  }
  draw_left_out(context);
}

}  // namespace marey::app
