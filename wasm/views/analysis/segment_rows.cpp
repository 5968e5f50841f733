#include "wasm/views/analysis/segment_rows.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/biomechanics/own_segments.h"
#include "core/editing/clip_operations.h"
#include "wasm/app/widgets.h"
#include "wasm/views/inspector/property_row.h"
#include "wasm/views/number_edit.h"

namespace marey::app {
namespace {

constexpr float kGap = 4.0f;

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

std::span<const ui::ChoiceOption> part_options() {
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

void draw_part_choice(ViewContext& context, JointIndex joint) {
  const BodyChoice& present = context.session.document.clip().body;
  const std::vector<OwnPart> sayable = sayable_parts(joint);
  const auto said = std::find_if(present.parts.begin(), present.parts.end(), [&](const OwnPart& own) { return own.joint == joint; });
  int chosen = said == present.parts.end() ? 0 : 1 + static_cast<int>(std::find(sayable.begin(), sayable.end(), *said) - sayable.begin());
  const std::string name = ui::displayable(context.session.document.skeleton().name(joint));
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

/// Numbers of a row that belong together: the label above them has their unit.
struct Triple {
  const char* id;
  const char* label;
  const char* help[3];
  double values[3];
  ui::NumberFormat format;
};

// Each number makes the segment with another value at its place: set(segment, place, value).
template <class Set>
void draw_triple(ViewContext& context, const Triple& triple, const Segment& present, const Set& set) {
  ImGui::SetCursorPosX(inspector::kPadding);
  ui::dim_text(context, triple.label);
  ImGui::SetCursorPosX(inspector::kPadding);
  const float room = ImGui::GetContentRegionAvail().x - inspector::kPadding;
  ui::NumberFormat format = triple.format;
  format.width = std::floor((room - 2.0f * kGap) / 3.0f);
  for (int i = 0; i < 3; ++i) {
    if (i > 0) ImGui::SameLine(0.0f, kGap);
    const auto result = ui::number_field(context, SmallText("{}.{}", triple.id, i).c_str(), triple.help[i], triple.values[i], format);
    apply_number(context, result, [&](const Clip& clip) {
      OwnSegment own = make_own_segment(present);
      set(*own.shape, i, result.value);
      BodyChoice body = clip.body;
      put_own_segment(body, own);
      return make_body_edit(clip, body);
    });
  }
  inspector::end_row();
}

void draw_shape(ViewContext& context, const Segment& present) {
  const OwnShape shape = *make_own_segment(present).shape;
  const auto set_moment = [](OwnShape& s, int i, double value) { s.inertia_kgm2[idx(i)] = value; };
  const auto set_product = [](OwnShape& s, int i, double value) { s.inertia_kgm2[idx(i + 3)] = value; };
  const auto& inertia = shape.inertia_kgm2;
  draw_triple(context,
              {"body.centre", "Centre of mass from the joint: X, Y, Z in m", {"Centre of mass from the joint, X", "Centre of mass from the joint, Y", "Centre of mass from the joint, Z"},
               {shape.com_m.x, shape.com_m.y, shape.com_m.z}, {.unit = "", .decimals = 3, .step = 0.001, .low = -100.0, .high = 100.0}},
              present, [](OwnShape& s, int i, double value) { s.com_m[i] = value; });
  draw_triple(context,
              {"body.moment", "Inertia about it: XX, YY, ZZ in kg·m²", {"Moment of inertia about the centre, XX", "Moment of inertia about the centre, YY", "Moment of inertia about the centre, ZZ"},
               {inertia[0], inertia[1], inertia[2]}, {.unit = "", .decimals = 4, .step = 0.0005, .low = 0.0, .high = 1e6}},
              present, set_moment);
  draw_triple(context,
              {"body.product", "Its products: XY, XZ, YZ in kg·m²", {"Product of inertia, XY", "Product of inertia, XZ", "Product of inertia, YZ"},
               {inertia[3], inertia[4], inertia[5]}, {.unit = "", .decimals = 4, .step = 0.0005, .low = -1e6, .high = 1e6}},
              present, set_product);
}

void draw_segment_mass(ViewContext& context, const char* id, JointIndex joint, double mass_kg, float width) {
  const auto result = ui::number_field(context, id, "Mass of all that the joint carries; the inertia goes along", mass_kg,
                                       {.unit = "kg", .decimals = 2, .step = 0.01, .low = 0.0, .high = 1e4, .width = width});
  apply_number(context, result, [&](const Clip& clip) { return make_body_edit(clip, with_segment_mass(clip, joint, result.value)); });
}

void draw_back_to_table(ViewContext& context, JointIndex joint) {
  const BodyChoice& present = context.session.document.clip().body;
  const bool is_own = std::any_of(present.segments.begin(), present.segments.end(), [&](const OwnSegment& own) { return own.joint == joint; });
  if (!is_own) return;
  inspector::begin_row(context, "");
  const char* label = present.is_only_own ? "Remove segment" : "As by the table";
  const char* help = present.is_only_own ? "Takes the segment off this joint." : "Takes back what was typed in for this joint.";
  if (ui::text_button(context, "body.segment.reset", label, help)) {
    BodyChoice body = present;
    std::erase_if(body.segments, [&](const OwnSegment& own) { return own.joint == joint; });
    apply_body(context, body);
  }
  inspector::end_row();
}

void draw_list_row(ViewContext& context, const GuessedPart& part, int index) {
  Session& session = context.session;
  ImGui::SetCursorPosX(inspector::kPadding);
  const float room = ImGui::GetContentRegionAvail().x - inspector::kPadding;
  constexpr float kNumberWidth = 84.0f;
  const float half = 0.5f * (room - kNumberWidth);
  const float y = ImGui::GetCursorPosY();
  ImGui::AlignTextToFramePadding();
  const bool is_selected = session.selection.active_joint() == part.joint;
  ui::elided_text(context, session.document.skeleton().name(part.joint), half, is_selected ? context.theme.accent : context.theme.text);
  ImGui::SetCursorPos({inspector::kPadding + half + 4.0f, y});
  ImGui::AlignTextToFramePadding();
  ui::elided_text(context, part.name, half - 8.0f, context.theme.dim_text);
  ImGui::SetCursorPos({inspector::kPadding, y});
  const SmallText name("body.joint.{}", index);
  if (ImGui::InvisibleButton(name.c_str(), {room - kNumberWidth - kGap, ImGui::GetFrameHeight()})) session.selection.select_only(part.joint);
  context.items.add_last(name, part.name);
  ImGui::SetCursorPos({inspector::kPadding + room - kNumberWidth, y});
  draw_segment_mass(context, SmallText("body.part.{}", index).c_str(), part.joint, part.mass_kg, kNumberWidth);
  inspector::end_row();
}

}  // namespace

void apply_body(ViewContext& context, const BodyChoice& body) {
  const Status status = context.session.apply(make_body_edit(context.session.document.clip(), body));
  if (!status) context.refusal = status.error().message;
}

void draw_carried_segment(ViewContext& context) {
  const JointIndex joint = find_plotted_joint(context.session);
  inspector::heading(context, "What the selected joint carries");
  if (context.session.document.clip().body.is_only_own) inspector::text_row(context, "Joint", ui::displayable(context.session.document.skeleton().name(joint)));
  else draw_part_choice(context, joint);
  const ChosenBody* body = context.analysis.body();
  const auto segment = body == nullptr ? std::nullopt : find_whole_segment(body->body.model, joint);
  const float width = inspector::begin_row(context, "Mass");
  draw_segment_mass(context, "body.segment.mass", joint, segment ? segment->mass_kg : 0.0, width);
  inspector::end_row();
  if (segment) draw_shape(context, *segment);
  draw_back_to_table(context, joint);
}

void draw_segment_list(ViewContext& context, const ChosenBody& body) {
  inspector::heading(context, "Segments");
  int index = 0;
  for (const GuessedPart& part : parts_by_joint(body.body.parts)) draw_list_row(context, part, index++);
}

void draw_model_buttons(ViewContext& context) {
  ImGui::Dummy({0.0f, 4.0f});
  ImGui::SetCursorPosX(inspector::kPadding);
  ui::command_button(context, "analysis.open_model", ui::ButtonLook::Raised, true);
  ImGui::SameLine(0.0f, 8.0f);
  ui::command_button(context, "analysis.save_model", ui::ButtonLook::Raised, true);
}

}  // namespace marey::app
