#include "wasm/views/operations/operation_form.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "wasm/app/faults.h"
#include "wasm/app/widgets.h"
#include "wasm/views/inspector/property_row.h"

namespace marey::app {
namespace {

// A preview of so many samples takes about a tenth of a second.
constexpr std::size_t kMostPreviewed = 1'500'000;
constexpr float kButtonGap = 8.0f;

bool has_blends(const Operation& operation) {
  return operation.reach == OperationReach::Channels || operation.reach == OperationReach::Joints ||
         operation.reach == OperationReach::Roots;
}

bool has_target(const Operation& operation) {
  return operation.reach != OperationReach::Clip && operation.reach != OperationReach::Layers;
}

// A pixel of drag: a two hundredth of narrow ranges, else a little of the value that the slider starts with.
double step_of(const OperationParameter& parameter) {
  if (parameter.kind != ParameterKind::Number) return parameter.odd ? 2.0 : 1.0;
  const double range = parameter.most - parameter.least;
  if (range <= 40.0) return range / 200.0;
  return std::max(std::abs(parameter.initial) / 50.0, 0.1);
}

double fitting(const OperationParameter& parameter, double value) {
  if (parameter.kind != ParameterKind::Number) value = std::round(value);
  if (parameter.odd) value = 2.0 * std::floor(0.5 * value) + 1.0;
  return std::clamp(value, parameter.least, parameter.most);
}

void wrapped_text(std::string_view text, ImU32 color) {
  ImGui::SetCursorPosX(inspector::kPadding);
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::PushTextWrapPos(ImGui::GetWindowWidth() - inspector::kPadding);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

}  // namespace

void OperationForm::open(const Operation& operation, const Session& session) {
  operation_ = &operation;
  values_ = initial_values(operation);
  kind_ = narrowest_target(session);
  target_ = make_target(session, kind_);
  blend_in_ = blend_out_ = 0;
  weight_ = 1.0;
  gesture_ = 0;
  has_step_ = false;
  changed_ = true;
  notes_.clear();
  refusal_.clear();
  sample_serial_ = session.selection.sample_serial();
  take_other(session);
  applies_when_done_ = false;
  previews_ = operation.id == "to-keys" || target_.channels.size() * idx(target_.frames.count) <= kMostPreviewed;
}

bool OperationForm::lacks_other() const {
  const auto& parameters = operation_->parameters;
  return other_ == nullptr && std::any_of(parameters.begin(), parameters.end(), [](const OperationParameter& parameter) {
           return parameter.kind == ParameterKind::File;
         });
}

void OperationForm::take_other(const Session& session) {
  other_ = session.other();
  values_.other = other_ ? &other_->clip : nullptr;
}

// The target is that of the clip without the preview: frames that it takes away are still meant.
void OperationForm::follow_clip(ViewContext& context) {
  Session& session = context.session;
  if (has_step_ && !session.document.history().is_in_gesture(gesture_)) {
    // Undone, or another edit came after it: what is shown is no preview any more.
    has_step_ = false;
    gesture_ = 0;
    previews_ = false;
  }
  if (other_ != session.other()) {
    take_other(session);
    changed_ = true;
  }
  if (sample_serial_ == session.selection.sample_serial() || has_step_) return;
  sample_serial_ = session.selection.sample_serial();
  target_ = make_target(session, kind_);
  changed_ = true;
}

void OperationForm::draw_number(ViewContext& context, const OperationParameter& parameter, double& value) {
  const float width = inspector::begin_row(context, parameter.label);
  const double shift = parameter.kind == ParameterKind::Frame ? 1.0 : 0.0;
  const SmallText id("operation.value.{}", parameter.name);
  const auto result = ui::number_field(context, id.c_str(), parameter.label, value + shift,
                                       {.unit = parameter.unit == "degrees or file units" ? "° or units" : parameter.unit,
                                        .decimals = parameter.kind == ParameterKind::Number ? 3 : 0,
                                        .step = step_of(parameter),
                                        .low = parameter.least + shift,
                                        .high = parameter.most + shift,
                                        .width = width});
  if (ImGui::IsItemHovered()) context.status = parameter.help;
  inspector::end_row();
  if (result.event == ui::NumberEvent::None || result.event == ui::NumberEvent::Cancelled) return;
  const double fits = fitting(parameter, result.value - shift);
  changed_ = changed_ || fits != value;
  value = fits;
}

void OperationForm::draw_choice(ViewContext& context, const OperationParameter& parameter, double& value) {
  static constexpr std::string_view kAxes[] = {"x", "y", "z"};
  static constexpr std::string_view kNoYes[] = {"no", "yes"};
  const std::span<const std::string_view> names = parameter.kind == ParameterKind::Axis    ? std::span(kAxes)
                                                  : parameter.kind == ParameterKind::YesNo ? std::span(kNoYes)
                                                                                            : parameter.choices;
  std::vector<ui::ChoiceOption> options;
  for (const std::string_view name : names) {
    std::string label(name);
    std::replace(label.begin(), label.end(), '-', ' ');
    label[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(label[0])));
    options.push_back({fmt::format("operation.value.{}.{}", parameter.name, name), std::move(label)});
  }
  const float width = inspector::begin_row(context, parameter.label);
  int chosen = static_cast<int>(value);
  const SmallText id("operation.value.{}", parameter.name);
  if (ui::choice(context, id.c_str(), parameter.label, parameter.help, options, chosen, width)) {
    value = chosen;
    changed_ = true;
  }
  inspector::end_row();
}

void OperationForm::draw_file(ViewContext& context, const OperationParameter& parameter) {
  inspector::begin_row(context, parameter.label);
  const SmallText id("operation.value.{}", parameter.name);
  if (ui::text_button(context, id.c_str(), "Choose…", parameter.help)) context.commands.run("file.open_other", nullptr);
  inspector::end_row();
  if (other_) inspector::known_text_row(context, "operation.other", "", ui::displayable(other_->file_name));
}

void OperationForm::draw_parameter(ViewContext& context, const OperationParameter& parameter, std::size_t place) {
  if (parameter.kind == ParameterKind::File) return draw_file(context, parameter);
  if (is_text(parameter.kind)) {
    const float width = inspector::begin_row(context, parameter.label);
    const SmallText id("operation.value.{}", parameter.name);
    changed_ = ui::text_field(context, id.c_str(), parameter.label, parameter.help, values_.texts[place], width) || changed_;
    inspector::end_row();
    return;
  }
  const bool is_number = parameter.kind == ParameterKind::Number || parameter.kind == ParameterKind::Whole ||
                         parameter.kind == ParameterKind::Frame;
  if (is_number) {
    draw_number(context, parameter, values_.numbers[place]);
  } else {
    draw_choice(context, parameter, values_.numbers[place]);
  }
}

void OperationForm::draw_parameters(ViewContext& context) {
  if (has_target(*operation_)) {
    if (draw_target_choice(context, kind_)) {
      cancel_step(context.session);
      target_ = make_target(context.session, kind_);
      changed_ = true;
    }
    inspector::known_text_row(context, "operation.described", "", describe(target_));
  }
  for (std::size_t i = 0; i < operation_->parameters.size(); ++i) draw_parameter(context, operation_->parameters[i], i);
}

void OperationForm::draw_blends(ViewContext& context) {
  const auto frames = [&](const char* id, const char* label, int& value) {
    const float width = inspector::begin_row(context, label);
    const auto result = ui::number_field(context, id, label, value,
                                         {.unit = "frames", .decimals = 0, .step = 0.25, .low = 0.0, .high = 1e6, .width = width});
    inspector::end_row();
    if (result.event == ui::NumberEvent::None || result.event == ui::NumberEvent::Cancelled) return;
    const int rounded = static_cast<int>(std::lround(result.value));
    changed_ = changed_ || rounded != value;
    value = rounded;
  };
  frames("operation.blend_in", "Blend in", blend_in_);
  frames("operation.blend_out", "Blend out", blend_out_);
  const float width = inspector::begin_row(context, "Weight");
  const auto result = ui::number_field(context, "operation.weight", "Weight", 100.0 * weight_,
                                       {.unit = "%", .decimals = 0, .step = 0.5, .low = 0.0, .high = 100.0, .width = width});
  inspector::end_row();
  if (result.event == ui::NumberEvent::None || result.event == ui::NumberEvent::Cancelled) return;
  changed_ = changed_ || result.value != 100.0 * weight_;
  weight_ = 0.01 * result.value;
}

void OperationForm::take(ViewContext& context) {
  changed_ = false;
  job_.stop();
  notes_.clear();
  refusal_.clear();
  if (lacks_other()) {
    notes_.emplace_back("Choose the other clip first.");
    return;
  }
  const Document& document = context.session.document;
  if (OperationJob::is_for(*operation_, values_, target_, document.motion().frame_count())) {
    cancel_step(context.session);
    const Status status = job_.start(*operation_, values_, target_, document.clip(), document.revision());
    if (!status) refusal_ = status.error().message;
    return;
  }
  OperationTarget target = target_;
  target.blend_in_frames = blend_in_;
  target.blend_out_frames = blend_out_;
  target.weight = weight_;
  apply_outcome(context, [&](const Clip& clip) { return make_operation_edit(clip, *operation_, target, values_); });
}

template <class MakeOutcome>
void OperationForm::apply_outcome(ViewContext& context, const MakeOutcome& make_outcome) {
  const auto make_edit = [&](const Clip& clip) {
    Result<OperationOutcome> outcome = make_outcome(clip);
    if (!outcome) {
      refusal_ = outcome.error().message;
      return Edit{};
    }
    notes_ = std::move(outcome->notes);
    return std::move(outcome->edit);
  };
  if (gesture_ == 0) gesture_ = context.widgets.new_gesture();
  const Status status = with_memory_for("this change", [&] { return context.session.apply_gesture(gesture_, make_edit); });
  if (!status) refusal_ = status.error().message;
  has_step_ = context.session.document.history().is_in_gesture(gesture_);
  sample_serial_ = context.session.selection.sample_serial();
}

void OperationForm::cancel_step(Session& session) {
  job_.stop();
  if (has_step_) session.cancel_gesture(gesture_);
  has_step_ = false;
}

void OperationForm::cancel(Session& session) {
  if (operation_ != nullptr) cancel_step(session);
  operation_ = nullptr;
}

OperationForm::Answer OperationForm::apply(ViewContext& context) {
  if (!has_step_ || changed_) take(context);
  applies_when_done_ = job_.is_running();
  if (!refusal_.empty() || lacks_other() || job_.is_running()) return Answer::Open;
  report_.assign(1, has_step_ ? std::string(context.session.document.history().undo_name()) + "."
                              : fmt::format("{} changed nothing.", operation_->label));
  report_.insert(report_.end(), notes_.begin(), notes_.end());
  operation_ = nullptr;
  return Answer::Applied;
}

void OperationForm::draw_outcome(ViewContext& context) {
  if (!refusal_.empty()) {
    wrapped_text(refusal_, context.theme.error);
    context.items.add_last("operation.refusal", refusal_);
  }
  for (const std::string& note : notes_) wrapped_text(note, context.theme.dim_text);
  if (!notes_.empty()) context.items.add_last("operation.note", notes_.front());
  if (refusal_.empty() && previews_ && !has_step_ && !lacks_other() && !changed_ && !job_.is_running()) wrapped_text("Nothing changes.", context.theme.dim_text);
  ImGui::Dummy({0.0f, 8.0f});
}

OperationForm::Answer OperationForm::draw_buttons(ViewContext& context) {
  Answer answer = Answer::Open;
  ImGui::SetCursorPosX(inspector::kPadding);
  if (ui::text_button(context, "operation.apply", "Apply", "Keeps the change as one step of undo.", ui::ButtonLook::Primary)) {
    answer = apply(context);
  }
  if (answer == Answer::Applied) return answer;
  ImGui::SameLine(0.0f, 8.0f);
  if (ui::text_button(context, "operation.cancel", "Cancel", "Takes the change back. Escape does too.") ||
      (ImGui::IsKeyPressed(ImGuiKey_Escape) && !ImGui::IsAnyItemActive())) {
    cancel(context.session);
    return Answer::Cancelled;
  }
  ImGui::SameLine(0.0f, 8.0f);
  if (ui::toggle(context, "operation.preview", "Preview", "Shows the outcome while values change.", previews_)) {
    if (!previews_) cancel_step(context.session);
    changed_ = true;
  }
  return answer;
}

// A part of the job in each frame; what is done so far can be thrown away at any time.
OperationForm::Answer OperationForm::draw_job(ViewContext& context) {
  if (job_.revision() != context.session.document.revision()) take(context);
  if (!job_.is_running()) return Answer::Open;
  const Status status = job_.advance(context.session.document.clip());
  if (!status) refusal_ = status.error().message;
  context.redraw = true;
  ImGui::SetCursorPosX(inspector::kPadding);
  if (ui::text_button(context, "operation.cancel", "Cancel", "Stops, and leaves the clip as it is.") ||
      ImGui::IsKeyPressed(ImGuiKey_Escape)) {
    cancel(context.session);
    return Answer::Cancelled;
  }
  ImGui::SameLine(0.0f, 8.0f);
  const SmallText text = job_.progress();
  ImGui::ProgressBar(job_.share(), {ImGui::GetContentRegionAvail().x - inspector::kPadding, ImGui::GetFrameHeight()}, text.c_str());
  context.items.add_last("operation.progress", text);
  if (job_.is_running() || !status) return Answer::Open;
  apply_outcome(context, [&](const Clip& clip) { return job_.outcome(*operation_, target_, values_, clip); });
  job_.stop();
  return applies_when_done_ && has_step_ ? apply(context) : Answer::Open;
}

OperationForm::Answer OperationForm::draw(ViewContext& context) {
  follow_clip(context);
  const float buttons = ImGui::GetFrameHeight() + 2.0f * kButtonGap;
  ImGui::BeginChild("operation.rows", {0.0f, std::max(ImGui::GetContentRegionAvail().y - buttons, 2.0f * buttons)},
                    ImGuiChildFlags_NavFlattened);
  inspector::heading(context, operation_->label);
  wrapped_text(operation_->help, context.theme.dim_text);
  ImGui::Dummy({0.0f, 8.0f});
  draw_parameters(context);
  if (has_blends(*operation_)) draw_blends(context);
  if (previews_ && changed_) take(context);
  ImGui::Dummy({0.0f, 4.0f});
  draw_outcome(context);
  ImGui::EndChild();
  ImGui::Dummy({0.0f, kButtonGap});
  return job_.is_running() ? draw_job(context) : draw_buttons(context);
}

}  // namespace marey::app
