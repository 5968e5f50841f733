#include "wasm/views/layers/layers_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "core/base/counted.h"
#include "core/editing/key_edits.h"
#include "core/editing/layer_edits.h"
#include "core/motion/key_curve_edits.h"
#include "wasm/app/icons.h"
#include "wasm/app/widgets.h"
#include "wasm/views/inspector/property_row.h"
#include "wasm/views/number_edit.h"

namespace marey::app {
namespace {

const Layer& layer_of(const ViewContext& context, int layer) { return context.session.document.clip().stack.layers[idx(layer)]; }

// Changes one layer as one step of undo.
template <class Change>
void change_layer(ViewContext& context, const char* name, int layer, Change change) {
  Result<Edit> edit = make_layer_edit(context.session.document.clip(), name, layer, change);
  const Status status = edit ? context.session.apply(std::move(*edit)) : edit.error();
  if (!status) context.refusal = status.error().message;
}

double weight_at(const Layer& layer, double frame) {
  return layer.weight ? std::clamp(KeyEvaluator(*layer.weight).value_at(frame), 0.0, 1.0) : 1.0;
}

// The first key of a curve takes the constant weight along, at the first frame.
void key_weight(ViewContext& context, int layer, double frame, double weight) {
  change_layer(context, "Key the weight", layer, [&](Layer& l) {
    KeyCurve curve = l.weight ? *l.weight : KeyCurve{};
    if (curve.keys.empty()) set_key(curve, 0.0, weight);
    set_key(curve, frame, weight);
    l.weight = std::make_shared<const KeyCurve>(std::move(curve));
  });
}

// A row that can be chosen, with room for buttons at its right end, where the cursor is left.
bool choice_row(ViewContext& context, const char* id, std::string_view label, bool active, float buttons) {
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = ImGui::GetFrameHeight();
  const bool pressed = ImGui::InvisibleButton(id, {width - buttons, height}, ImGuiButtonFlags_EnableNav);
  context.items.add_last(id, label);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (active) {
    list.AddRectFilled(min, {min.x + width, min.y + height}, with_alpha(context.theme.accent, 0.18f));
    list.AddRectFilled(min, {min.x + 3.0f, min.y + height}, context.theme.accent);
  } else if (ImGui::IsItemHovered()) {
    list.AddRectFilled(min, {min.x + width, min.y + height}, context.theme.hovered);
  }
  ImGui::SetCursorScreenPos({min.x + inspector::kPadding, min.y + std::round(0.5f * (height - ImGui::GetTextLineHeight()))});
  ui::elided_text(context, label, width - buttons - inspector::kPadding - 4.0f, context.theme.text);
  ImGui::SetCursorScreenPos({min.x + width - buttons, min.y});
  return pressed;
}

}  // namespace

void LayersPage::draw_layer(ViewContext& context, int layer) {
  const Layer shown = layer_of(context, layer);
  const SmallText id("layers.row.{}", layer);
  const float buttons = 3.0f * ImGui::GetFrameHeight() + 8.0f;
  if (choice_row(context, id.c_str(), ui::displayable(shown.name), context.session.active_layer == layer, buttons)) {
    context.session.active_layer = layer;
  }
  const auto flag = [&](const char* what, const char* icon, std::string_view tip, bool on) {
    const bool pressed = ui::icon_button(context, SmallText("layers.{}.{}", what, layer).c_str(), icon, tip, on);
    ImGui::SameLine(0.0f, 0.0f);
    return pressed;
  };
  if (flag("mute", shown.muted ? icons::kEyeOff : icons::kEye, "Mute: the layer counts for nothing.", shown.muted)) {
    change_layer(context, "Mute layer", layer, [](Layer& l) { l.muted = !l.muted; });
  }
  if (flag("solo", icons::kFocus, "Solo: only the solo layers count.", shown.solo)) {
    change_layer(context, "Solo layer", layer, [](Layer& l) { l.solo = !l.solo; });
  }
  if (flag("lock", shown.locked ? icons::kLock : icons::kLockOpen, "Lock: keys and weight stay as they are.", shown.locked)) {
    change_layer(context, "Lock layer", layer, [](Layer& l) { l.locked = !l.locked; });
  }
  ImGui::NewLine();
}

void LayersPage::draw_base(ViewContext& context) {
  const int keyed = size_of(context.session.document.clip().stack.keyed);
  const std::string label = keyed == 0 ? std::string("Samples of the file")
                                       : fmt::format("Samples, and keys of {}", counted(keyed, "channel"));
  if (choice_row(context, "layers.row.base", label, context.session.active_layer == kOwnKeys, 0.0f)) {
    context.session.active_layer = kOwnKeys;
  }
  ImGui::NewLine();
}

void LayersPage::draw_name(ViewContext& context, int layer) {
  if (!naming_) name_ = layer_of(context, layer).name;
  const float width = inspector::begin_row(context, "Name");
  ui::text_field(context, "layers.name", "Name", "Press Enter to rename the layer.", name_, width);
  naming_ = ImGui::IsItemActive();
  if (ImGui::IsItemDeactivatedAfterEdit() && name_ != layer_of(context, layer).name) {
    change_layer(context, "Rename layer", layer, [&](Layer& l) { l.name = name_; });
  }
  inspector::end_row();
}

// With keys the weight is a curve, and the field sets one at the frame. The button begins one.
void LayersPage::draw_weight(ViewContext& context, int layer) {
  const Layer& shown = layer_of(context, layer);
  const double frame = context.session.playback.position();
  const bool is_curve = shown.weight && shown.weight->keys.size() > 1;
  const double weight = weight_at(shown, frame);
  const float width = inspector::begin_row(context, is_curve ? "Weight here" : "Weight") - ImGui::GetFrameHeight() - 4.0f;
  const auto result = ui::number_field(context, "layers.weight", "Weight", 100.0 * weight,
                                       {.unit = "%", .decimals = 0, .step = 0.5, .low = 0.0, .high = 100.0, .width = width});
  apply_number(context, result, [&](const Clip& clip) {
    Result<Edit> edit = make_layer_edit(clip, "Weight of a layer", layer, [&](Layer& l) {
      KeyCurve curve = is_curve ? *l.weight : KeyCurve{};
      set_key(curve, is_curve ? frame : 0.0, 0.01 * result.value);
      l.weight = std::make_shared<const KeyCurve>(std::move(curve));
    });
    if (edit) return std::move(*edit);
    context.refusal = edit.error().message;
    return Edit{};
  });
  ImGui::SameLine(0.0f, 4.0f);
  if (ui::icon_button(context, "layers.weight_key", icons::kDiamondPlus, "Key the weight: it has this value at this frame.")) {
    key_weight(context, layer, frame, weight);
  }
  inspector::end_row();
}

void LayersPage::draw_modes(ViewContext& context, int layer) {
  static const std::array<ui::ChoiceOption, 2> kModes = {ui::ChoiceOption{"layers.mode.additive", "Added"},
                                                         ui::ChoiceOption{"layers.mode.override", "In place"}};
  static const std::array<ui::ChoiceOption, 2> kRotations = {ui::ChoiceOption{"layers.rotations.turn", "Turn the joint"},
                                                             ui::ChoiceOption{"layers.rotations.sum", "Sum the angles"}};
  float width = inspector::begin_row(context, "Counts");
  int mode = static_cast<int>(layer_of(context, layer).mode);
  if (ui::choice(context, "layers.mode", "Counts", "Added to what is beneath, or in its place.", kModes, mode, width)) {
    change_layer(context, "Mode of a layer", layer, [&](Layer& l) { l.mode = static_cast<LayerMode>(mode); });
  }
  inspector::end_row();
  width = inspector::begin_row(context, "Rotations");
  int sums = layer_of(context, layer).sums_angles ? 1 : 0;
  if (ui::choice(context, "layers.rotations", "Rotations", "How the layer counts where a joint has three rotations.", kRotations,
                 sums, width)) {
    change_layer(context, "Rotations of a layer", layer, [&](Layer& l) { l.sums_angles = sums == 1; });
  }
  inspector::end_row();
}

void LayersPage::draw_active(ViewContext& context) {
  const int layer = context.session.active_layer;
  inspector::heading(context, "Active layer");
  draw_name(context, layer);
  draw_weight(context, layer);
  draw_modes(context, layer);
  const Layer& shown = layer_of(context, layer);
  const std::string keys = fmt::format("{} in {}", count_keys(shown.curves), counted(size_of(shown.curves), "channel"));
  inspector::known_text_row(context, "layers.key_count", "Keys", keys);
}

void LayersPage::draw_keys(ViewContext& context) {
  inspector::heading(context, SmallText("Keys at frame {}", context.session.playback.frame() + 1));
  ImGui::SetCursorPosX(inspector::kPadding);
  ui::command_button(context, "keys.set", ui::ButtonLook::Raised, true);
  ImGui::SameLine(0.0f, 8.0f);
  ui::command_button(context, "keys.delete", ui::ButtonLook::Raised, true);
  inspector::end_row();
}

void LayersPage::follow_clip(const ViewContext& context) {
  const Document& document = context.session.document;
  const JointIndex joint = context.session.selection.active_joint();
  if (clip_serial_ == context.clip_serial && revision_ == document.revision() && joint_ == joint) return;
  clip_serial_ = context.clip_serial;
  revision_ = document.revision();
  joint_ = joint;
  deviations_.clear();
  if (joint == kNoParent) return;
  const Skeleton& skeleton = document.skeleton();
  for (int i = 0; i < skeleton.channel_count(joint); ++i) {
    const ChannelIndex channel = skeleton.first_channel(joint) + i;
    if (!document.clip().stack.beneath.contains(channel)) continue;
    deviations_.push_back(
        {channel, find_deviation(samples_beneath(document.clip(), channel), document.motion().channel_samples(channel))});
  }
}

void LayersPage::draw_deviations(ViewContext& context) {
  if (deviations_.empty()) return;
  inspector::heading(context, "Away from what is beneath");
  for (const Deviation& deviation : deviations_) {
    const Channel& channel = context.session.document.skeleton().channel(deviation.channel);
    const char* unit = is_rotation(channel.kind) ? "°" : "";
    const std::string text = fmt::format("max {:.2f}{} at {}, RMS {:.2f}{}", deviation.of.largest, unit, deviation.of.at + 1,
                                         deviation.of.rms, unit);
    inspector::known_text_row(context, SmallText("layers.deviation.{}", deviation.channel), channel_name(channel), text);
  }
}

void LayersPage::draw(ViewContext& context) {
  ImGui::Dummy({0.0f, 8.0f});
  ImGui::SetCursorPosX(inspector::kPadding);
  ui::command_button(context, "layer.add", ui::ButtonLook::Raised, true, "@layers");
  ImGui::SameLine(0.0f, 8.0f);
  for (const char* command : {"layer.up", "layer.down", "layer.delete", "layer.bake"}) {
    ui::command_button(context, command, ui::ButtonLook::Plain, false, "@layers");
    ImGui::SameLine(0.0f, 2.0f);
  }
  ImGui::NewLine();
  ImGui::Dummy({0.0f, 8.0f});
  for (int layer = size_of(context.session.document.clip().stack.layers) - 1; layer >= 0; --layer) draw_layer(context, layer);
  draw_base(context);
  ImGui::Dummy({0.0f, 8.0f});
  if (context.session.active_layer != kOwnKeys) draw_active(context);
  draw_keys(context);
  follow_clip(context);
  draw_deviations(context);
  ImGui::Dummy({0.0f, 16.0f});
}

}  // namespace marey::app
