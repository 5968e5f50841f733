#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/motion/key_curve.h"
#include "core/motion/motion.h"
#include "core/skeleton/skeleton.h"

namespace marey {

/// Curves and samples are shared between a clip and its history: they are exchanged for others, never changed.
using SharedKeys = std::shared_ptr<const KeyCurve>;
using SharedSamples = std::shared_ptr<const std::vector<double>>;

enum class LayerMode : std::uint8_t {
  Additive,  ///< onto what lies beneath
  Override,  ///< in its place
};

/// Curves of keys over some channels, laid on what is beneath them. Where a joint has three rotation channels about
/// different neighbouring axes, the layer's angles (those without keys: 0 when they are added, those beneath in place)
/// make a rotation in the joint's own order: added, it turns the joint after what is beneath, R = R_beneath R_layer, as
/// in its own axes; in place, the joint turns the short way from the one to the other as far as the weight says. All
/// other channels are sums and linear blends.
struct Layer {
  std::string name;
  LayerMode mode = LayerMode::Additive;
  bool sums_angles = false;  ///< rotation channels as all others
  bool muted = false;
  bool solo = false;  ///< as soon as one layer is, only those that are count
  bool locked = false;  ///< keys and weight cannot be changed
  SharedKeys weight;  ///< over time, clamped to 0 ... 1; null: 1
  std::map<ChannelIndex, SharedKeys> curves;
};

/// What the samples of a clip are made of where they are not just samples.
struct LayerStack {
  std::vector<Layer> layers;  ///< from the lowest to the highest
  std::map<ChannelIndex, SharedKeys> keyed;  ///< channels that are keys rather than samples
  std::map<ChannelIndex, SharedSamples> beneath;  ///< the samples beneath the layers, of the channels that layers move

  [[nodiscard]] bool empty() const { return layers.empty() && keyed.empty(); }
};

/// Whether both say the same, whether or not they share it.
[[nodiscard]] bool operator==(const LayerStack& a, const LayerStack& b);

/// Bytes that nothing but this stack holds.
[[nodiscard]] std::size_t unshared_bytes(const LayerStack& stack);

/// Whether the layer counts at all.
[[nodiscard]] bool is_active(const LayerStack& stack, int layer);

/// The channels that move with each other when a layer moves `channel`, itself included: the three rotations of its joint,
/// or itself alone. Rising.
[[nodiscard]] std::vector<ChannelIndex> channels_moved_with(const Skeleton& skeleton, ChannelIndex channel);

/// The channels that some layer moves, muted or not, rising. Each needs its samples in LayerStack::beneath.
[[nodiscard]] std::vector<ChannelIndex> layered_channels(const Skeleton& skeleton, const LayerStack& stack);

/// Samples of some channels over a range, one span of the range's length each.
using ChannelSamples = std::map<ChannelIndex, std::vector<double>>;

/// Lays the layers from `first_layer` up to before `end_layer` on `samples`, which holds what is beneath them for all
/// channels that move with each other. Where no layer counts the samples stay to the bit; so do those of rotations that a
/// layer does not turn. A layer in place with full weight gives its own angles to the bit. Missing samples stay missing.
void lay_on(const Skeleton& skeleton, const LayerStack& stack, int first_layer, int end_layer, FrameRange frames,
            ChannelSamples& samples);

/// The way back: what must be beneath the layers from `first_layer` up so that `samples` are the result. Angles are those
/// nearest to the ones given.
/// False, and nothing is changed, if a layer in place counts at one of the frames: what is beneath it cannot be told.
[[nodiscard]] bool take_off(const Skeleton& skeleton, const LayerStack& stack, int first_layer, FrameRange frames,
                            ChannelSamples& samples);

}  // namespace marey
