#include "wasm/views/analysis/body_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/editing/clip_operations.h"
#include "core/signal/residual_analysis.h"
#include "wasm/app/widgets.h"
#include "wasm/views/inspector/clip_page.h"
#include "wasm/views/inspector/property_row.h"
#include "wasm/views/number_edit.h"

namespace marey::app {
namespace {

using Options = std::span<const ui::ChoiceOption>;

Options table_options() {
  static const std::vector<ui::ChoiceOption> kOptions = {{"body.table.auto", "By joint names"},
                                                         {"body.table.male", "de Leva 1996, male"},
                                                         {"body.table.female", "de Leva 1996, female"},
                                                         {"body.table.winter", "Winter 2009"},
                                                         {"body.table.rods", "Uniform rods"}};
  return kOptions;
}

Options support_options() {
  static const std::vector<ui::ChoiceOption> kOptions = {{"body.support.pivot", "A bar at the root"},
                                                         {"body.support.flight", "Nothing: in flight"},
                                                         {"body.support.ground", "The ground"},
                                                         {"body.support.auto", "As the motion tells"}};
  return kOptions;
}

Options derivation_options() {
  static const std::vector<ui::ChoiceOption> kOptions = {{"body.derivation.central", "As it is"},
                                                         {"body.derivation.butterworth", "Butterworth"},
                                                         {"body.derivation.savgol", "Savitzky-Golay"},
                                                         {"body.derivation.gcv", "Quintic spline, GCV"},
                                                         {"body.derivation.spline", "Quintic spline, known noise"}};
  return kOptions;
}

void apply_body(ViewContext& context, const BodyChoice& body) {
  const Status status = context.session.apply(make_body_edit(context.session.document.clip(), body));
  if (!status) context.refusal = status.error().message;
}

void draw_table(ViewContext& context) {
  const BodyChoice& present = context.session.document.clip().body;
  const float width = inspector::begin_row(context, "Table");
  int chosen = present.table ? static_cast<int>(*present.table) + 1 : 0;
  if (ui::choice(context, "body.table", "Table", "Where the masses of the segments come from.", table_options(), chosen, width)) {
    BodyChoice body = present;
    body.table = chosen == 0 ? std::nullopt : std::optional(static_cast<BodyTable>(chosen - 1));
    apply_body(context, body);
  }
  inspector::end_row();
}

void draw_mass(ViewContext& context, double mass_kg) {
  const float width = inspector::begin_row(context, "Mass");
  const auto result = ui::number_field(context, "body.mass", "Mass of the body. Masses typed in below go back to the table", mass_kg,
                                       {.unit = "kg", .decimals = 1, .step = 0.1, .low = 0.001, .high = 1e4, .width = width});
  apply_number(context, result, [&](const Clip& clip) {
    BodyChoice body = clip.body;
    body.mass_kg = result.value;
    body.own.clear();
    return make_body_edit(clip, body);
  });
  inspector::end_row();
}

void draw_part(ViewContext& context, const GuessedPart& part, int index) {
  const Skeleton& skeleton = context.session.document.skeleton();
  ImGui::SetCursorPosX(inspector::kPadding);
  const float room = ImGui::GetContentRegionAvail().x - inspector::kPadding;
  constexpr float kNumberWidth = 84.0f;
  const float y = ImGui::GetCursorPosY();
  ImGui::AlignTextToFramePadding();
  ui::elided_text(context, skeleton.name(part.joint), 0.5f * (room - kNumberWidth), context.theme.text);
  ImGui::SetCursorPos({inspector::kPadding + 0.5f * (room - kNumberWidth) + 4.0f, y});
  ImGui::AlignTextToFramePadding();
  ui::elided_text(context, part.name, 0.5f * (room - kNumberWidth) - 8.0f, context.theme.dim_text);
  ImGui::SetCursorPos({inspector::kPadding + room - kNumberWidth, y});
  const auto result = ui::number_field(context, SmallText("body.part.{}", index).c_str(), part.name, part.mass_kg,
                                       {.unit = "kg", .decimals = 2, .step = 0.01, .low = 0.0, .high = 1e4, .width = kNumberWidth});
  apply_number(context, result, [&](const Clip& clip) {
    BodyChoice body = clip.body;
    const auto at = std::lower_bound(body.own.begin(), body.own.end(), part.joint,
                                     [](const OwnMass& own, JointIndex joint) { return own.joint < joint; });
    if (at != body.own.end() && at->joint == part.joint) at->mass_kg = result.value;
    else body.own.insert(at, {part.joint, result.value});
    return make_body_edit(clip, body);
  });
  inspector::end_row();
}

// A joint has one mass, whatever parts it carries.
std::vector<GuessedPart> parts_by_joint(const std::vector<GuessedPart>& parts) {
  std::vector<GuessedPart> joints;
  for (const GuessedPart& part : parts) {
    const auto same = std::find_if(joints.begin(), joints.end(), [&](const GuessedPart& p) { return p.joint == part.joint; });
    if (same == joints.end()) {
      joints.push_back(part);
      continue;
    }
    same->mass_kg += part.mass_kg;
    if (same->name != part.name) same->name += ", " + part.name;
  }
  return joints;
}

/// What a joint can be said to carry, in the order of the list behind "As its name tells".
std::vector<OwnPart> sayable_parts(JointIndex joint) {
  std::vector<OwnPart> parts = {{joint, std::nullopt}, {joint, BodyPart::Head}, {joint, BodyPart::Trunk}};
  for (int part = static_cast<int>(BodyPart::UpperArm); part < kBodyPartCount; ++part) {
    for (const BodySide side : {BodySide::Left, BodySide::Right, BodySide::Middle}) parts.push_back({joint, static_cast<BodyPart>(part), side});
  }
  return parts;
}

Options part_options() {
  static const std::vector<ui::ChoiceOption> kOptions = [] {
    std::vector<ui::ChoiceOption> options = {{"body.carries.auto", "As its name tells"}};
    for (const OwnPart& part : sayable_parts(0)) {
      const bool is_limb = part.part && *part.part != BodyPart::Trunk && *part.part != BodyPart::Head;
      const char* side = !is_limb ? "" : part.side == BodySide::Left ? "left " : part.side == BodySide::Right ? "right " : "both: ";
      std::string label = part.part ? fmt::format("{}{}", side, body_part_name(*part.part)) : "nothing of its own";
      label.front() = static_cast<char>(label.front() - 'a' + 'A');
      options.push_back({fmt::format("body.carries.{}", options.size()), std::move(label)});
    }
    return options;
  }();
  return kOptions;
}

void draw_carried(ViewContext& context) {
  const JointIndex joint = find_plotted_joint(context.session);
  const BodyChoice& present = context.session.document.clip().body;
  const std::vector<OwnPart> sayable = sayable_parts(joint);
  const auto said = std::find_if(present.parts.begin(), present.parts.end(), [&](const OwnPart& own) { return own.joint == joint; });
  int chosen = said == present.parts.end() ? 0 : 1 + static_cast<int>(std::find(sayable.begin(), sayable.end(), *said) - sayable.begin());
  const std::string name = ui::displayable(context.session.document.skeleton().name(joint));
  inspector::heading(context, "What the selected joint carries");
  const float width = inspector::begin_row(context, name.c_str());
  if (ui::choice(context, "body.carries", "Carries", "Which part of the body begins at the selected joint.", part_options(), chosen, width)) {
    BodyChoice body = present;
    std::erase_if(body.parts, [&](const OwnPart& own) { return own.joint == joint; });
    const auto behind = std::find_if(body.parts.begin(), body.parts.end(), [&](const OwnPart& own) { return own.joint > joint; });
    if (chosen > 0) body.parts.insert(behind, sayable[idx(chosen - 1)]);
    apply_body(context, body);
  }
  inspector::end_row();
}

void draw_segments(ViewContext& context, const ChosenBody& body) {
  inspector::heading(context, "Segments");
  int index = 0;
  for (const GuessedPart& part : parts_by_joint(body.body.parts)) draw_part(context, part, index++);
}

void draw_notes(ViewContext& context, std::span<const std::string> notes) {
  for (const std::string& note : notes) {
    ImGui::SetCursorPosX(inspector::kPadding);
    ImGui::PushTextWrapPos(ImGui::GetWindowWidth() - inspector::kPadding);
    ImGui::PushStyleColor(ImGuiCol_Text, context.theme.dim_text);
    ImGui::TextUnformatted(note.c_str());
    context.items.add_last("body.note", note);
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
    ImGui::Dummy({0.0f, 4.0f});
  }
}

void draw_support(ViewContext& context) {
  inspector::heading(context, "What holds it");
  const float width = inspector::begin_row(context, "Support");
  int chosen = static_cast<int>(context.analysis.support);
  if (ui::choice(context, "body.support", "Support", "What the body hangs on or stands on.", support_options(), chosen, width)) {
    context.analysis.support = static_cast<SupportKind>(chosen);
  }
  inspector::end_row();
}

void draw_number(ViewContext& context, const char* id, const char* name, double& value, const ui::NumberFormat& format) {
  ui::NumberFormat fitted = format;
  fitted.width = inspector::begin_row(context, name);
  const auto result = ui::number_field(context, id, name, value, fitted);
  if (result.event != ui::NumberEvent::None) value = result.value;
  inspector::end_row();
}

// The middle one of what the residuals of the joint's rotations suggest; 0 where they suggest nothing.
double suggested_cutoff_hz(const Clip& clip, JointIndex joint) {
  std::vector<double> found;
  for (int i = 0; joint != kNoParent && i < clip.skeleton.channel_count(joint); ++i) {
    const ChannelIndex channel = clip.skeleton.first_channel(joint) + i;
    if (!is_rotation(clip.skeleton.channel(channel).kind)) continue;
    const double cutoff_hz = analyse_residuals(clip.motion.channel_samples(channel), 1.0 / clip.motion.frame_time_s()).cutoff_hz;
    if (cutoff_hz > 0.0) found.push_back(cutoff_hz);
  }
  std::sort(found.begin(), found.end());
  return found.empty() ? 0.0 : found[found.size() / 2];
}

void draw_suggestion(ViewContext& context, Derivation& derivation) {
  inspector::begin_row(context, "");
  if (ui::text_button(context, "body.cutoff.suggest", "Suggest", "Takes the cut-off that the residuals of the plotted joint suggest (Winter 2009).")) {
    const double cutoff_hz = suggested_cutoff_hz(context.session.document.clip(), find_plotted_joint(context.session));
    if (cutoff_hz > 0.0) derivation.cutoff_hz = std::round(10.0 * cutoff_hz) / 10.0;
    else context.refusal = "The residuals of this joint suggest no cut-off.";
  }
  inspector::end_row();
}

void draw_derivation(ViewContext& context) {
  Derivation& derivation = context.analysis.derivation;
  inspector::heading(context, "Velocities and accelerations");
  const float width = inspector::begin_row(context, "Smoothing");
  int chosen = static_cast<int>(derivation.kind);
  if (ui::choice(context, "body.derivation", "Smoothing", "What is done to samples before they are differentiated.", derivation_options(), chosen,
                 width)) {
    derivation.kind = static_cast<DerivationKind>(chosen);
  }
  inspector::end_row();
  if (derivation.kind == DerivationKind::Butterworth) {
    draw_number(context, "body.cutoff", "Cut-off", derivation.cutoff_hz, {.unit = "Hz", .decimals = 1, .step = 0.1, .low = 0.1, .high = 1000.0});
    draw_suggestion(context, derivation);
  } else if (derivation.kind == DerivationKind::SavitzkyGolay) {
    double window = derivation.window;
    double degree = derivation.degree;
    draw_number(context, "body.window", "Window", window, {.unit = "frames", .decimals = 0, .step = 2.0, .low = 3.0, .high = 301.0});
    draw_number(context, "body.degree", "Degree", degree, {.unit = "", .decimals = 0, .step = 0.1, .low = 2.0, .high = 8.0});
    derivation.window = static_cast<int>(window) / 2 * 2 + 1;
    derivation.degree = std::min(static_cast<int>(degree), derivation.window - 1);
  } else if (derivation.kind == DerivationKind::Spline) {
    draw_number(context, "body.noise.angles", "Noise, angles", derivation.noise_deg, {.unit = "°", .decimals = 2, .step = 0.01, .low = 0.001, .high = 90.0});
    draw_number(context, "body.noise.places", "Noise, places", derivation.noise_mm, {.unit = "mm", .decimals = 1, .step = 0.1, .low = 0.001, .high = 1e4});
  }
  ImGui::SetCursorPosX(inspector::kPadding);
  ui::toggle(context, "body.bands", "Bands of doubt",
             "Shows how far each curve moves with another cut-off, another table of the body, and a unit of length 2 % off.",
             context.analysis.shows_bands);
  inspector::end_row();
  if (derivation.kind == DerivationKind::Central) return;
  ImGui::SetCursorPosX(inspector::kPadding);
  ui::toggle(context, "body.raw", "Without smoothing too", "Draws the unsmoothed curve in grey behind the smoothed one.", context.analysis.shows_raw);
  inspector::end_row();
}

}  // namespace

void draw_body_page(ViewContext& context) {
  const Clip& clip = context.session.document.clip();
  if (clip.skeleton.joint_count() == 0) return;
  draw_derivation(context);
  draw_support(context);
  if (context.analysis.is_of(context.clip_serial)) draw_notes(context, context.analysis.notes());
  const std::vector<std::string>& judgement = context.analysis.judgement(context.session, context.clip_serial);
  if (!judgement.empty()) inspector::heading(context, "Does it make sense?");
  draw_notes(context, judgement);
  inspector::heading(context, "Body");
  draw_table(context);
  inspector::draw_unit(context);
  context.analysis.follow_body(context.session, context.clip_serial);
  const ChosenBody* body = context.analysis.body();
  if (body == nullptr) {
    draw_notes(context, std::span(&context.analysis.body_problem(), 1));
    draw_carried(context);
    return;
  }
  draw_mass(context, body->mass_kg);
  draw_notes(context, body->body.notes);
  draw_carried(context);
  draw_segments(context, *body);
  ImGui::Dummy({0.0f, 16.0f});
}

}  // namespace marey::app
