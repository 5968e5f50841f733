#include "core/editing/layer_edits.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

#include "core/base/bits.h"

namespace marey {
namespace {

using Channels = std::set<ChannelIndex>;

bool lie_alike(const Layer& a, const Layer& b) {
  return a.mode == b.mode && a.sums_angles == b.sums_angles && a.weight == b.weight;
}

void add_differences(const std::map<ChannelIndex, SharedKeys>& a, const std::map<ChannelIndex, SharedKeys>& b,
                     Channels& channels) {
  for (const auto& [channel, keys] : a) {
    const auto found = b.find(channel);
    if (found == b.end() || found->second != keys) channels.insert(channel);
  }
  for (const auto& entry : b) {
    if (!a.contains(entry.first)) channels.insert(entry.first);
  }
}

void add_curves(const LayerStack& stack, Channels& channels) {
  for (const Layer& layer : stack.layers) {
    for (const auto& curve : layer.curves) channels.insert(curve.first);
  }
}

// The channels whose samples may come out differently, with those that move with them.
Channels find_affected(const Skeleton& skeleton, const LayerStack& before, const LayerStack& after) {
  Channels changed;
  add_differences(before.keyed, after.keyed, changed);
  bool alike = before.layers.size() == after.layers.size();
  for (int i = 0; alike && i < size_of(before.layers); ++i) {
    alike = lie_alike(before.layers[idx(i)], after.layers[idx(i)]) && is_active(before, i) == is_active(after, i);
  }
  if (alike) {
    for (std::size_t i = 0; i < before.layers.size(); ++i) {
      add_differences(before.layers[i].curves, after.layers[i].curves, changed);
    }
  } else {
    add_curves(before, changed);
    add_curves(after, changed);
  }
  Channels affected;
  for (const ChannelIndex channel : changed) {
    const std::vector<ChannelIndex> together = channels_moved_with(skeleton, channel);
    affected.insert(together.begin(), together.end());
  }
  return affected;
}

std::vector<double> copy_of(std::span<const double> samples) { return {samples.begin(), samples.end()}; }

// What is beneath the layers of a channel in the wanted stack.
std::vector<double> find_beneath(const Clip& clip, const LayerStack& wanted, ChannelIndex channel) {
  const auto keyed = wanted.keyed.find(channel);
  if (keyed == wanted.keyed.end()) return copy_of(samples_beneath(clip, channel));
  std::vector<double> samples(idx(clip.motion.frame_count()));
  KeyEvaluator(*keyed->second).sample({0, clip.motion.frame_count()}, samples);
  return samples;
}

bool fits(const std::map<ChannelIndex, SharedKeys>& curves, int channel_count) {
  return std::all_of(curves.begin(), curves.end(), [channel_count](const auto& curve) {
    return curve.first >= 0 && curve.first < channel_count && curve.second && check_key_curve(*curve.second).ok();
  });
}

// Whether there is something to evaluate; what does not fit is for check_edit() to refuse.
bool fits(const Clip& clip, const LayerStack& stack) {
  const int channel_count = clip.skeleton.channel_count();
  return fits(stack.keyed, channel_count) && std::all_of(stack.layers.begin(), stack.layers.end(), [&](const Layer& layer) {
           return fits(layer.curves, channel_count) && (!layer.weight || check_key_curve(*layer.weight).ok());
         });
}

/// Lets what is beneath the layers take up changes of the result.
class Absorber {
 public:
  Absorber(const Clip& clip, Edit& edit) : clip_(clip), edit_(edit), stack_(clip.stack) {}

  Status absorb() {
    const std::vector<ChannelIndex> layered = layered_channels(clip_.skeleton, stack_);
    for (const SamplesChange& change : edit_.samples) {
      stack_.keyed.erase(change.channel);
      if (!std::binary_search(layered.begin(), layered.end(), change.channel) || done_.contains(change.channel)) continue;
      if (Status status = absorb_joint(channels_moved_with(clip_.skeleton, change.channel)); !status) return status;
    }
    if (!(stack_ == clip_.stack)) edit_.stack = std::move(stack_);
    return {};
  }

 private:
  // A joint's rotation channels, or a channel alone.
  Status absorb_joint(const std::vector<ChannelIndex>& channels) {
    done_.insert(channels.begin(), channels.end());
    FrameRange frames;
    for (const SamplesChange& change : edit_.samples) {
      if (std::binary_search(channels.begin(), channels.end(), change.channel)) {
        frames = hull(frames, {change.first, size_of(change.values)});
      }
    }
    ChannelSamples samples;
    std::vector<bool> touched(idx(frames.count));
    for (const ChannelIndex channel : channels) samples[channel] = wanted_samples(channel, frames, touched);
    if (!take_off(clip_.skeleton, stack_, 0, frames, samples)) return refusal(channels.front());
    for (const ChannelIndex channel : channels) {
      std::vector<double> beneath = *stack_.beneath.at(channel);
      for (int i = 0; i < frames.count; ++i) {
        if (touched[idx(i)]) beneath[idx(frames.first + i)] = samples.at(channel)[idx(i)];
      }
      stack_.beneath[channel] = std::make_shared<const std::vector<double>>(std::move(beneath));
      stack_.keyed.erase(channel);
    }
    return {};
  }

  std::vector<double> wanted_samples(ChannelIndex channel, FrameRange frames, std::vector<bool>& touched) const {
    const auto present = clip_.motion.channel_samples(channel).subspan(idx(frames.first), idx(frames.count));
    std::vector<double> wanted = copy_of(present);
    for (const SamplesChange& change : edit_.samples) {
      if (change.channel != channel) continue;
      for (int i = 0; i < size_of(change.values); ++i) {
        const std::size_t at = idx(change.first - frames.first + i);
        if (same_bits(wanted[at], change.values[idx(i)])) continue;
        wanted[at] = change.values[idx(i)];
        touched[at] = true;
      }
    }
    return wanted;
  }

  [[nodiscard]] Error refusal(ChannelIndex channel) const {
    return {DiagnosticCode::InvalidArgument, {},
            fmt::format("A layer in place holds {}. Mute it, or change its keys.", channel_label(clip_.skeleton, channel)),
            {}, {}};
  }

  const Clip& clip_;
  Edit& edit_;
  LayerStack stack_;
  Channels done_;
};

Error locked_refusal(const Layer& layer) {
  return {DiagnosticCode::InvalidArgument, {}, fmt::format("The layer \"{}\" is locked. Unlock it to change it.", layer.name), {}, {}};
}

}  // namespace

Edit make_stack_edit(const Clip& clip, std::string name, LayerStack wanted) {
  Edit edit;
  edit.name = std::move(name);
  wanted.beneath = clip.stack.beneath;
  if (!fits(clip, wanted)) {
    edit.stack = std::move(wanted);
    return edit;
  }
  const std::vector<ChannelIndex> layered = layered_channels(clip.skeleton, wanted);
  const auto is_layered = [&](ChannelIndex channel) { return std::binary_search(layered.begin(), layered.end(), channel); };
  std::erase_if(wanted.beneath, [&](const auto& samples) { return !is_layered(samples.first); });
  ChannelSamples samples;
  for (const ChannelIndex channel : find_affected(clip.skeleton, clip.stack, wanted)) {
    std::vector<double> beneath = find_beneath(clip, wanted, channel);
    const auto former = clip.stack.beneath.find(channel);
    const bool is_same = former != clip.stack.beneath.end() && *former->second == beneath;
    if (is_layered(channel) && !is_same) wanted.beneath[channel] = std::make_shared<const std::vector<double>>(beneath);
    samples[channel] = std::move(beneath);
  }
  lay_on(clip.skeleton, wanted, 0, size_of(wanted.layers), {0, clip.motion.frame_count()}, samples);
  for (auto& [channel, values] : samples) edit.samples.push_back({channel, 0, std::move(values)});
  edit.stack = std::move(wanted);
  return edit;
}

Result<Edit> make_layer_edit(const Clip& clip, std::string name, int layer, const std::function<void(Layer&)>& change) {
  LayerStack stack = clip.stack;
  Layer& changed = stack.layers[idx(layer)];
  change(changed);
  const Layer& before = clip.stack.layers[idx(layer)];
  if (before.locked && changed.locked && (!lie_alike(before, changed) || before.curves != changed.curves)) {
    return locked_refusal(before);
  }
  return make_stack_edit(clip, std::move(name), std::move(stack));
}

Result<Edit> make_layer_deletion(const Clip& clip, int layer) {
  LayerStack stack = clip.stack;
  const Layer& deleted = stack.layers[idx(layer)];
  if (deleted.locked) return locked_refusal(deleted);
  std::string name = fmt::format("Delete layer \"{}\"", deleted.name);
  stack.layers.erase(stack.layers.begin() + layer);
  return make_stack_edit(clip, std::move(name), std::move(stack));
}

std::string free_layer_name(const LayerStack& stack, std::string_view wanted) {
  const auto is_taken = [&](const std::string& name) {
    return std::any_of(stack.layers.begin(), stack.layers.end(), [&](const Layer& layer) { return layer.name == name; });
  };
  std::string name = wanted.empty() ? "Layer 1" : std::string(wanted);
  for (int number = 2; is_taken(name); ++number) name = fmt::format("{} {}", wanted.empty() ? "Layer" : wanted, number);
  return name;
}

int count_keys(const std::map<ChannelIndex, SharedKeys>& curves) {
  int count = 0;
  for (const auto& curve : curves) count += size_of(curve.second->keys);
  return count;
}

Edit make_bake_edit(const Clip& clip) {
  Edit edit;
  edit.name = "Bake layers and keys";
  if (!clip.stack.empty()) edit.stack = LayerStack{};
  return edit;
}

Result<Edit> fit_to_layers(const Clip& clip, Edit edit) {
  if (edit.stack || clip.stack.empty()) return edit;
  if (edit.frames || edit.figure) {
    edit.stack = LayerStack{};
    return edit;
  }
  if (edit.samples.empty()) return edit;
  if (Status status = Absorber(clip, edit).absorb(); !status) return status.error();
  return edit;
}

std::span<const double> samples_beneath(const Clip& clip, ChannelIndex channel) {
  const auto found = clip.stack.beneath.find(channel);
  return found == clip.stack.beneath.end() ? clip.motion.channel_samples(channel) : std::span<const double>(*found->second);
}

}  // namespace marey
