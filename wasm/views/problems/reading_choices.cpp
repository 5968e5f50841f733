#include "wasm/views/problems/reading_choices.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/counted.h"
#include "wasm/app/builtin_commands.h"
#include "wasm/app/widgets.h"
#include "wasm/views/inspector/clip_page.h"
#include "wasm/views/inspector/property_row.h"

namespace marey::app {
namespace {

constexpr std::string_view kSuffix = "@inspector";
constexpr std::array kUsualRates_hz = {24.0, 25.0, 30.0, 60.0, 100.0, 120.0};

/// A card for a command: its label, its state, and the reason why it cannot run.
ChoiceCard card_for(const ViewContext& context, const char* command_id) {
  const Command& command = *context.commands.find(command_id);
  ChoiceCard card;
  card.id = command.id + std::string(kSuffix);
  card.label = CommandRegistry::label_of(command).view();
  card.help = command.help;
  card.chosen = command.checked && command.checked();
  card.blocked = card.chosen ? std::string() : std::string(CommandRegistry::blocked_reason(command));
  return card;
}

void run_pressed(ViewContext& context, const std::vector<ChoiceCard>& cards) {
  const int pressed = draw_choice_cards(context, cards);
  if (pressed < 0) return;
  const std::string& id = cards[idx(pressed)].id;
  context.commands.run(id.substr(0, id.size() - kSuffix.size()));
}

std::string height_text(double units, const ClipSettings& settings) {
  return fmt::format("{:.4g} units, {:.2f} m", units, units * settings.metres_per_unit);
}

}  // namespace

ChoiceCard ReadingChoices::pictured(ViewContext& context, const char* command_id, const ClipSettings& settings) {
  const Clip& clip = context.session.document.clip();
  const double frame = context.session.playback.position();
  ChoiceCard card = card_for(context, command_id);
  card.detail = height_text(picture_.measure_height(clip, settings, frame), settings);
  card.draw_picture = [this, &context, &clip, settings, frame](ImVec2 min, ImVec2 max) {
    picture_.draw(*ImGui::GetWindowDrawList(), context.theme, clip, settings, frame, min, max);
  };
  return card;
}

void ReadingChoices::draw_positions(ViewContext& context) {
  ClipSettings replace = context.session.document.settings();
  replace.position_rule = PositionRule::Replace;
  ClipSettings add = replace;
  add.position_rule = PositionRule::Add;
  ChoiceCard replacing = pictured(context, "clip.positions.replace", replace);
  ChoiceCard adding = pictured(context, "clip.positions.add", add);
  replacing.label = "Replace offset";
  adding.label = "Add to offset";
  std::vector<ChoiceCard> cards = {std::move(replacing), std::move(adding)};
  if (has_joints_that_add(context.session.document.skeleton())) {
    ClipSettings per_joint = add;
    per_joint.position_rule = PositionRule::PerJoint;
    cards.push_back(pictured(context, "clip.positions.per_joint", per_joint));
    cards.back().label = "Per joint";
  }
  run_pressed(context, cards);
}

void ReadingChoices::draw_frame_rate(ViewContext& context) {
  const Motion& motion = context.session.document.motion();
  const double present_hz = display_frame_rate_hz(motion.frame_time_s());
  std::vector<ChoiceCard> cards;
  for (const double rate_hz : kUsualRates_hz) {
    ChoiceCard card;
    card.id = fmt::format("clip.frame_rate.{:.0f}{}", rate_hz, kSuffix);
    card.label = fmt::format("{:.0f} fps", rate_hz);
    card.detail = fmt::format("{:.2f} s long", std::max(motion.frame_count() - 1, 0) / rate_hz);
    card.help = "Sets the frame time. The samples stay as they are.";
    card.chosen = std::abs(present_hz - rate_hz) < 1e-9;
    cards.push_back(std::move(card));
  }
  const int pressed = draw_choice_cards(context, cards);
  if (pressed >= 0) context.commands.run("clip.frame_time", {{"seconds", 1.0 / kUsualRates_hz[idx(pressed)]}});
  inspector::draw_frame_time(context);
}

void ReadingChoices::draw_unit(ViewContext& context) {
  const Document& document = context.session.document;
  const double stature = compute_stature(document.skeleton());
  std::vector<ChoiceCard> cards;
  for (const LengthUnit& unit : known_length_units()) {
    ChoiceCard card;
    card.id = fmt::format("clip.unit.{}{}", unit.name, kSuffix);
    card.label = std::string(unit.name);
    card.detail = fmt::format("{:.3g} m tall", stature * unit.metres);
    card.help = fmt::format("One unit of the file is {:.5g} m.", unit.metres);
    card.chosen = document.settings().metres_per_unit == unit.metres;
    cards.push_back(std::move(card));
  }
  const int pressed = draw_choice_cards(context, cards);
  if (pressed >= 0) context.commands.run("clip.unit", {{"metres", known_length_units()[idx(pressed)].metres}});
  inspector::draw_unit(context);
}

void ReadingChoices::draw_surplus_frames(ViewContext& context) {
  const Document& document = context.session.document;
  ChoiceCard all = card_for(context, "clip.frames.all");
  ChoiceCard declared = card_for(context, "clip.frames.declared");
  declared.detail = counted(document.declared_frames(), "frame");
  all.detail = declared.chosen ? std::string("as the file holds") : counted(document.motion().frame_count(), "frame");
  run_pressed(context, {all, declared});
}

ChoiceCard ReadingChoices::frame_card(ViewContext& context, const char* command_id, FrameIndex shown) {
  const Clip& clip = context.session.document.clip();
  ChoiceCard card = card_for(context, command_id);
  card.detail = "begins so";
  if (shown >= 0 && shown < clip.motion.frame_count()) {
    card.draw_picture = [this, &context, &clip, shown](ImVec2 min, ImVec2 max) {
      picture_.draw(*ImGui::GetWindowDrawList(), context.theme, clip, clip.settings, shown, min, max);
    };
  }
  return card;
}

void ReadingChoices::draw_first_frame(ViewContext& context) {
  const bool left_out = is_first_frame_left_out(context.session.document);
  ChoiceCard keep = frame_card(context, "clip.first_frame.keep", left_out ? -1 : 0);
  if (left_out) keep.detail.clear();
  run_pressed(context, {keep, frame_card(context, "clip.first_frame.leave_out", left_out ? 0 : 1)});
}

bool ReadingChoices::draw_below(ViewContext& context, DiagnosticCode code) {
  switch (code) {
    case DiagnosticCode::PositionsReplaceOffset:
    case DiagnosticCode::PositionsAddToOffset:
    case DiagnosticCode::PositionsAmbiguous: draw_positions(context); return true;
    case DiagnosticCode::MissingFrameTime:
    case DiagnosticCode::FrameTimeNotPositive:
    case DiagnosticCode::FrameTimeLooksLikeRate: draw_frame_rate(context); return true;
    case DiagnosticCode::NamesNotUtf8: inspector::draw_names_choice(context); return true;
    case DiagnosticCode::FrameCountMismatch:
      if (context.session.document.declared_frames() == 0) return false;
      draw_surplus_frames(context);
      return true;
    default: return false;
  }
}

void ReadingChoices::draw_assumptions(ViewContext& context) {
  inspector::heading(context, "Assumed: up axis");
  ClipSettings y_up = context.session.document.settings();
  y_up.up_axis = Axis::Y;
  ClipSettings z_up = y_up;
  z_up.up_axis = Axis::Z;
  run_pressed(context, {pictured(context, "clip.up_axis.y", y_up), pictured(context, "clip.up_axis.z", z_up)});
  inspector::heading(context, "Assumed: unit of length");
  draw_unit(context);
}

}  // namespace marey::app
