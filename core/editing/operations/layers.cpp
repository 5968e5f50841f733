#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "core/editing/layer_edits.h"
#include "core/editing/operations/families.h"
#include "core/editing/operations/layer_choice.h"
#include "core/motion/key_curve_edits.h"

namespace marey {
namespace {

using Outcome = Result<OperationOutcome>;

Outcome with_stack(const OperationCall& call, std::string name, LayerStack stack) {
  OperationOutcome outcome;
  outcome.edit = make_stack_edit(call.clip, std::move(name), std::move(stack));
  return outcome;
}

Outcome outcome_of(Result<Edit> edit) {
  if (!edit) return edit.error();
  OperationOutcome outcome;
  outcome.edit = std::move(*edit);
  return outcome;
}

Outcome make_layer_add(const OperationCall& call) {
  LayerStack stack = call.clip.stack;
  Layer layer;
  layer.name = free_layer_name(stack, call.text("name"));
  layer.mode = call.choice("mode") == "override" ? LayerMode::Override : LayerMode::Additive;
  layer.sums_angles = call.choice("rotations") == "sum";
  std::string name = fmt::format("Add layer \"{}\"", layer.name);
  stack.layers.push_back(std::move(layer));
  return with_stack(call, std::move(name), std::move(stack));
}

Outcome make_layer_delete(const OperationCall& call) {
  const Result<int> layer = choose_layer(call);
  return layer ? outcome_of(make_layer_deletion(call.clip, *layer)) : layer.error();
}

Outcome make_layer_rename(const OperationCall& call) {
  const Result<int> layer = choose_layer(call);
  if (!layer) return layer.error();
  LayerStack others = call.clip.stack;
  others.layers.erase(others.layers.begin() + *layer);
  const std::string name = free_layer_name(others, call.text("name"));
  return outcome_of(make_layer_edit(call.clip, "Rename layer", *layer, [&](Layer& l) { l.name = name; }));
}

Outcome make_layer_order(const OperationCall& call) {
  const Result<int> layer = choose_layer(call);
  if (!layer) return layer.error();
  LayerStack stack = call.clip.stack;
  const int to = std::clamp(call.whole("to") - 1, 0, size_of(stack.layers) - 1);
  const auto from = stack.layers.begin() + *layer;
  if (to > *layer) std::rotate(from, from + 1, stack.layers.begin() + to + 1);
  if (to < *layer) std::rotate(stack.layers.begin() + to, from, from + 1);
  return with_stack(call, "Move layer", std::move(stack));
}

using SetSwitch = void (*)(Layer& layer, bool on);

Outcome make_switch(const OperationCall& call, std::string_view on_verb, std::string_view off_verb, SetSwitch set) {
  const Result<int> layer = choose_layer(call);
  if (!layer) return layer.error();
  const bool on = call.yes("on");
  std::string name = fmt::format("{} layer \"{}\"", on ? on_verb : off_verb, call.clip.stack.layers[idx(*layer)].name);
  return outcome_of(make_layer_edit(call.clip, std::move(name), *layer, [&](Layer& l) { set(l, on); }));
}

Outcome make_layer_mute(const OperationCall& call) {
  return make_switch(call, "Mute", "Hear", [](Layer& layer, bool on) { layer.muted = on; });
}

Outcome make_layer_solo(const OperationCall& call) {
  return make_switch(call, "Solo", "Unsolo", [](Layer& layer, bool on) { layer.solo = on; });
}

Outcome make_layer_lock(const OperationCall& call) {
  return make_switch(call, "Lock", "Unlock", [](Layer& layer, bool on) { layer.locked = on; });
}

Outcome make_layer_mode(const OperationCall& call) {
  const Result<int> layer = choose_layer(call);
  if (!layer) return layer.error();
  return outcome_of(make_layer_edit(call.clip, "Change how a layer counts", *layer, [&](Layer& l) {
    l.mode = call.choice("mode") == "override" ? LayerMode::Override : LayerMode::Additive;
    l.sums_angles = call.choice("rotations") == "sum";
  }));
}

// One weight for all times, or a key of the weight's curve.
Outcome make_layer_weight(const OperationCall& call) {
  const Result<int> layer = choose_layer(call);
  if (!layer) return layer.error();
  return outcome_of(make_layer_edit(call.clip, "Weight of a layer", *layer, [&](Layer& l) {
    const bool is_constant = call.choice("at") == "all";
    KeyCurve curve = is_constant || !l.weight ? KeyCurve{} : *l.weight;
    set_key(curve, is_constant ? 0.0 : call.number("frame"), call.number("value"));
    l.weight = std::make_shared<const KeyCurve>(std::move(curve));
  }));
}

Outcome make_layers_bake(const OperationCall& call) {
  OperationOutcome outcome;
  outcome.edit = make_bake_edit(call.clip);
  return outcome;
}

constexpr std::string_view kModes[] = {"additive", "override"};
constexpr std::string_view kRotations[] = {"turn", "sum"};
constexpr std::string_view kWeightTimes[] = {"all", "frame"};
constexpr OperationParameter kLayer{.name = "layer", .label = "Layer", .help = "Its name, or its number from the bottom.",
                                    .kind = ParameterKind::Text};
constexpr OperationParameter kName{.name = "name", .label = "Name", .help = "A name for the layer; one is found if there is none.",
                                   .kind = ParameterKind::Text};
constexpr OperationParameter kMode{.name = "mode", .label = "Counts", .help = "Added to what is beneath, or in its place.",
                                   .kind = ParameterKind::Choice, .most = 1.0, .choices = kModes};
constexpr OperationParameter kHow{.name = "rotations", .label = "Rotations",
                                  .help = "Whether joints are turned, or angles are summed channel by channel.",
                                  .kind = ParameterKind::Choice, .most = 1.0, .choices = kRotations};
constexpr OperationParameter kOn{.name = "on", .label = "On", .help = "Whether it is switched on or off.",
                                 .kind = ParameterKind::YesNo, .initial = 1.0, .most = 1.0};

constexpr OperationParameter kAdd[] = {kName, kMode, kHow};
constexpr OperationParameter kOne[] = {kLayer};
constexpr OperationParameter kRename[] = {kLayer, kName};
constexpr OperationParameter kOrder[] = {
    kLayer, {.name = "to", .label = "To", .help = "Its new number; 1 is the lowest.", .kind = ParameterKind::Whole,
             .initial = 1.0, .least = 1.0, .most = 1e6}};
constexpr OperationParameter kSwitch[] = {kLayer, kOn};
constexpr OperationParameter kModeOf[] = {kLayer, kMode, kHow};
constexpr OperationParameter kWeight[] = {
    kLayer,
    {.name = "value", .label = "Weight", .help = "1 counts fully, 0 not at all.", .initial = 1.0, .most = 1.0},
    {.name = "at", .label = "At", .help = "All times, or a key at one frame.", .kind = ParameterKind::Choice, .most = 1.0,
     .choices = kWeightTimes},
    {.name = "frame", .label = "Frame", .help = "Where the key lies.", .kind = ParameterKind::Frame, .most = 1e9}};

constexpr Operation kLayers[] = {
    {.id = "layer-add", .label = "Add layer", .group = "Layers", .help = "Puts an empty layer on top of the others.",
     .reach = OperationReach::Layers, .parameters = kAdd, .make = make_layer_add},
    {.id = "layer-delete", .label = "Delete layer", .group = "Layers", .help = "Takes a layer and its keys away.",
     .reach = OperationReach::Layers, .parameters = kOne, .make = make_layer_delete},
    {.id = "layer-rename", .label = "Rename layer", .group = "Layers", .help = "Gives a layer another name.",
     .reach = OperationReach::Layers, .parameters = kRename, .make = make_layer_rename},
    {.id = "layer-order", .label = "Move layer", .group = "Layers", .help = "Puts a layer above or below others.",
     .reach = OperationReach::Layers, .parameters = kOrder, .make = make_layer_order},
    {.id = "layer-mute", .label = "Mute layer", .group = "Layers", .help = "Lets a layer count for nothing.",
     .reach = OperationReach::Layers, .parameters = kSwitch, .make = make_layer_mute},
    {.id = "layer-solo", .label = "Solo layer", .group = "Layers", .help = "Lets only the solo layers count.",
     .reach = OperationReach::Layers, .parameters = kSwitch, .make = make_layer_solo},
    {.id = "layer-lock", .label = "Lock layer", .group = "Layers", .help = "Keeps the keys and the weight of a layer as they are.",
     .reach = OperationReach::Layers, .parameters = kSwitch, .make = make_layer_lock},
    {.id = "layer-mode", .label = "Mode of layer", .group = "Layers", .help = "Sets how a layer counts.",
     .reach = OperationReach::Layers, .parameters = kModeOf, .make = make_layer_mode},
    {.id = "layer-weight", .label = "Weight of layer", .group = "Layers", .help = "Sets how much a layer counts, at all times or at a frame.",
     .reach = OperationReach::Layers, .parameters = kWeight, .make = make_layer_weight},
    {.id = "layers-bake", .label = "Bake layers and keys", .group = "Layers",
     .help = "Keeps the samples as they are and lets layers and keys go.", .reach = OperationReach::Layers,
     .make = make_layers_bake}};

}  // namespace

std::span<const Operation> layer_operations() { return kLayers; }

}  // namespace marey
