#include "core/editing/key_edits.h"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "core/editing/layer_edits.h"
#include "core/motion/key_curve_edits.h"

namespace marey {
namespace {

Error refusal(std::string message) { return {DiagnosticCode::InvalidArgument, {}, std::move(message), {}, {}}; }

Status check_layer(const LayerStack& stack, int layer) {
  if (layer == kOwnKeys) return {};
  if (layer < 0 || layer >= size_of(stack.layers)) return refusal(fmt::format("The clip has no layer {}.", layer + 1));
  if (stack.layers[idx(layer)].locked) {
    return refusal(fmt::format("The layer \"{}\" is locked. Unlock it to change its keys.", stack.layers[idx(layer)].name));
  }
  return {};
}

// So that the channel counts among the layered ones, and what is beneath it is there, before it has keys.
Clip with_channels(const Clip& clip, int layer, const ChannelValues& wanted) {
  LayerStack stack = clip.stack;
  for (const auto& entry : wanted) {
    KeyCurve still;
    still.keys.emplace_back();
    stack.layers[idx(layer)].curves.try_emplace(entry.first, std::make_shared<const KeyCurve>(std::move(still)));
  }
  Clip with{clip.skeleton, Motion{}, clip.settings, {}, std::move(stack)};
  for (const ChannelIndex channel : layered_channels(clip.skeleton, with.stack)) {
    const auto beneath = samples_beneath(clip, channel);
    with.stack.beneath.try_emplace(channel, std::make_shared<const std::vector<double>>(beneath.begin(), beneath.end()));
  }
  return with;
}

KeyCurve with_key(const SharedKeys& keys, FrameIndex frame, double value) {
  KeyCurve curve = keys ? *keys : KeyCurve{};
  set_key(curve, frame, value);
  return curve;
}

Result<Edit> make_own_key_edit(const Clip& clip, std::string name, FrameIndex frame, const ChannelValues& wanted) {
  ChannelSamples samples;
  for (const auto& [channel, value] : wanted) {
    if (!clip.stack.keyed.contains(channel)) {
      return refusal(fmt::format("{} has samples, not keys. Make keys of it, or choose a layer.",
                                 channel_label(clip.skeleton, channel)));
    }
    for (const ChannelIndex together : channels_moved_with(clip.skeleton, channel)) {
      samples[together] = {clip.motion.sample(together, frame)};
    }
  }
  for (const auto& [channel, value] : wanted) samples[channel] = {value};
  if (!take_off(clip.skeleton, clip.stack, 0, {frame, 1}, samples)) {
    return refusal("A layer in place hides the keys of the channel. Mute it, or change its keys.");
  }
  std::map<ChannelIndex, KeyCurve> curves;
  for (const auto& [channel, values] : samples) {
    const SharedKeys keys = find_keys(clip.stack, kOwnKeys, channel);
    if (keys) curves[channel] = with_key(keys, frame, values[0]);
  }
  return make_keys_edit(clip, std::move(name), kOwnKeys, std::move(curves));
}

}  // namespace

SharedKeys find_keys(const LayerStack& stack, int layer, ChannelIndex channel) {
  const auto& curves = layer == kOwnKeys ? stack.keyed : stack.layers[idx(layer)].curves;
  const auto found = curves.find(channel);
  return found == curves.end() ? nullptr : found->second;
}

Result<Edit> make_keys_edit(const Clip& clip, std::string name, int layer, std::map<ChannelIndex, KeyCurve> curves) {
  if (Status status = check_layer(clip.stack, layer); !status) return status.error();
  LayerStack stack = clip.stack;
  auto& present = layer == kOwnKeys ? stack.keyed : stack.layers[idx(layer)].curves;
  for (auto& [channel, curve] : curves) {
    if (curve.keys.empty()) {
      present.erase(channel);
    } else {
      present[channel] = std::make_shared<const KeyCurve>(std::move(curve));
    }
  }
  return make_stack_edit(clip, std::move(name), std::move(stack));
}

Result<Edit> make_pose_key_edit(const Clip& clip, std::string name, int layer, FrameIndex frame,
                                const ChannelValues& wanted) {
  if (Status status = check_layer(clip.stack, layer); !status) return status.error();
  if (frame < 0 || frame >= clip.motion.frame_count()) return refusal("The frame lies outside of the clip.");
  if (layer == kOwnKeys) return make_own_key_edit(clip, std::move(name), frame, wanted);
  const Clip with = with_channels(clip, layer, wanted);
  const auto values = solve_layer_values(clip.skeleton, with.stack, clip.motion, layer, frame, wanted);
  if (!values) {
    return refusal(fmt::format("The layer \"{}\" cannot do this at frame {}: it is muted, has too little weight there, or a layer "
                               "in place above hides it.", clip.stack.layers[idx(layer)].name, frame + 1));
  }
  std::map<ChannelIndex, KeyCurve> curves;
  for (const auto& [channel, value] : *values) {
    curves[channel] = with_key(find_keys(clip.stack, layer, channel), frame, value);
  }
  return make_keys_edit(clip, std::move(name), layer, std::move(curves));
}

}  // namespace marey
