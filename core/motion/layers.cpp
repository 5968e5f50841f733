#include "core/motion/layers.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <set>
#include <span>

#include "core/motion/euler_channels.h"

namespace marey {
namespace {

bool same_keys(const SharedKeys& a, const SharedKeys& b) { return a == b || (a && b && *a == *b); }

template <class Map, class Same>
bool same_entries(const Map& a, const Map& b, Same same) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [&](const auto& x, const auto& y) {
           return x.first == y.first && same(x.second, y.second);
         });
}

bool same_layer(const Layer& a, const Layer& b) {
  return a.name == b.name && a.mode == b.mode && a.sums_angles == b.sums_angles && a.muted == b.muted &&
         a.solo == b.solo && a.locked == b.locked && same_keys(a.weight, b.weight) &&
         same_entries(a.curves, b.curves, same_keys);
}

std::vector<double> sample_keys(const KeyCurve& curve, FrameRange frames) {
  std::vector<double> values(idx(frames.count));
  KeyEvaluator(curve).sample(frames, values);
  return values;
}

/// A layer over a range.
class LaidLayer {
 public:
  LaidLayer(const Layer& layer, FrameRange frames) : layer_(layer), frames_(frames) {
    if (layer.weight) weights_ = sample_keys(*layer.weight, frames);
    for (double& weight : weights_) weight = std::clamp(weight, 0.0, 1.0);
  }

  [[nodiscard]] const Layer& layer() const { return layer_; }
  [[nodiscard]] double weight(int i) const { return weights_.empty() ? 1.0 : weights_[idx(i)]; }
  /// Empty for a channel without keys.
  [[nodiscard]] std::vector<double> values(ChannelIndex channel) const {
    const auto found = layer_.curves.find(channel);
    return found == layer_.curves.end() ? std::vector<double>() : sample_keys(*found->second, frames_);
  }
  [[nodiscard]] bool counts_anywhere() const {
    return weights_.empty() || std::any_of(weights_.begin(), weights_.end(), [](double weight) { return weight != 0.0; });
  }

 private:
  const Layer& layer_;
  FrameRange frames_;
  std::vector<double> weights_;
};

// The three rotation channels of a joint as a layer and the samples have them.
struct Rotation {
  EulerOrder order;
  std::span<double> samples[3];
  std::vector<double> layer[3];  // empty: no keys

  [[nodiscard]] glm::dvec3 angles(int i) const { return {samples[0][idx(i)], samples[1][idx(i)], samples[2][idx(i)]}; }
  [[nodiscard]] glm::dvec3 layer_angles(int i, const glm::dvec3& without) const {
    glm::dvec3 angles = without;
    for (int c = 0; c < 3; ++c) {
      if (!layer[c].empty()) angles[c] = layer[c][idx(i)];
    }
    return angles;
  }
  void set(int i, const glm::dvec3& angles) {
    for (int c = 0; c < 3; ++c) samples[c][idx(i)] = angles[c];
  }
};

bool is_finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

// A turn about one axis alone may be more than half a turn, and is weighted by its angle.
glm::dquat weighted_turn(EulerOrder order, const glm::dvec3& angles, double weight) {
  const int turning = (angles.x != 0.0 ? 1 : 0) + (angles.y != 0.0 ? 1 : 0) + (angles.z != 0.0 ? 1 : 0);
  if (weight == 1.0 || turning < 2) return rotation_from_euler(order, weight * angles);
  return glm::slerp(glm::dquat(1.0, 0.0, 0.0, 0.0), rotation_from_euler(order, angles), weight);
}

glm::dvec3 angles_near(EulerOrder order, const glm::dquat& rotation, const glm::dvec3& reference) {
  return euler_near(order, glm::mat3_cast(glm::normalize(rotation)), reference);
}

glm::dvec3 turned(const Rotation& rotation, int i, double weight) {
  const glm::dvec3 beneath = rotation.angles(i);
  const glm::dvec3 added = rotation.layer_angles(i, glm::dvec3(0.0));
  if (added == glm::dvec3(0.0)) return beneath;
  const glm::dquat turn = weighted_turn(rotation.order, added, weight);
  return angles_near(rotation.order, rotation_from_euler(rotation.order, beneath) * turn, beneath + weight * added);
}

glm::dvec3 turned_back(const Rotation& rotation, int i, double weight) {
  const glm::dvec3 result = rotation.angles(i);
  const glm::dvec3 added = rotation.layer_angles(i, glm::dvec3(0.0));
  if (added == glm::dvec3(0.0)) return result;
  const glm::dquat turn = weighted_turn(rotation.order, added, weight);
  return angles_near(rotation.order, rotation_from_euler(rotation.order, result) * glm::inverse(turn),
                     result - weight * added);
}

glm::dvec3 replaced(const Rotation& rotation, int i, double weight) {
  const glm::dvec3 beneath = rotation.angles(i);
  const glm::dvec3 target = rotation.layer_angles(i, beneath);
  if (weight == 1.0 || target == beneath) return target;
  const glm::dquat blend = glm::slerp(rotation_from_euler(rotation.order, beneath),
                                      rotation_from_euler(rotation.order, target), weight);
  return angles_near(rotation.order, blend, beneath + weight * (target - beneath));
}

enum class Way { On, Off };

void move_rotation(const LaidLayer& laid, Rotation& rotation, FrameRange frames, Way way) {
  for (int i = 0; i < frames.count; ++i) {
    const double weight = laid.weight(i);
    if (weight == 0.0 || !is_finite(rotation.angles(i))) continue;
    if (laid.layer().mode == LayerMode::Override) {
      rotation.set(i, replaced(rotation, i, weight));
    } else {
      rotation.set(i, way == Way::On ? turned(rotation, i, weight) : turned_back(rotation, i, weight));
    }
  }
}

void move_channel(const LaidLayer& laid, const std::vector<double>& layer, std::span<double> samples, Way way) {
  for (int i = 0; i < size_of(samples); ++i) {
    const double weight = laid.weight(i);
    double& sample = samples[idx(i)];
    if (weight == 0.0 || !std::isfinite(sample)) continue;
    if (laid.layer().mode == LayerMode::Override) {
      sample = weight == 1.0 ? layer[idx(i)] : sample + weight * (layer[idx(i)] - sample);
    } else {
      sample += (way == Way::On ? weight : -weight) * layer[idx(i)];
    }
  }
}

void move_samples(const Skeleton& skeleton, const LaidLayer& laid, FrameRange frames, ChannelSamples& samples, Way way) {
  std::set<ChannelIndex> done;
  for (const auto& curve : laid.layer().curves) {
    const ChannelIndex channel = curve.first;
    if (!samples.contains(channel) || !done.insert(channel).second) continue;
    const std::vector<ChannelIndex> together =
        laid.layer().sums_angles ? std::vector{channel} : channels_moved_with(skeleton, channel);
    if (together.size() < 3) {
      move_channel(laid, laid.values(channel), samples.at(channel), way);
      continue;
    }
    const std::optional<EulerChannels> euler = find_euler_channels(skeleton, skeleton.channel(channel).joint);
    Rotation rotation{euler->order, {}, {}};
    for (int c = 0; c < 3; ++c) {
      rotation.samples[c] = samples.at(euler->channels[c]);
      rotation.layer[c] = laid.values(euler->channels[c]);
    }
    move_rotation(laid, rotation, frames, way);
    done.insert(together.begin(), together.end());
  }
}

bool moves_any(const Skeleton& skeleton, const Layer& layer, const ChannelSamples& samples) {
  return std::any_of(layer.curves.begin(), layer.curves.end(), [&](const auto& curve) {
    const std::vector<ChannelIndex> together = channels_moved_with(skeleton, curve.first);
    return std::any_of(together.begin(), together.end(), [&](ChannelIndex channel) { return samples.contains(channel); });
  });
}

}  // namespace

bool operator==(const LayerStack& a, const LayerStack& b) {
  const auto same_samples = [](const SharedSamples& x, const SharedSamples& y) { return x == y || *x == *y; };
  return a.layers.size() == b.layers.size() &&
         std::equal(a.layers.begin(), a.layers.end(), b.layers.begin(), same_layer) &&
         same_entries(a.keyed, b.keyed, same_keys) && same_entries(a.beneath, b.beneath, same_samples);
}

std::size_t unshared_bytes(const LayerStack& stack) {
  std::size_t bytes = stack.layers.size() * sizeof(Layer);
  const auto add_keys = [&bytes](const SharedKeys& keys) {
    if (keys && keys.use_count() == 1) bytes += sizeof(KeyCurve) + keys->keys.size() * sizeof(Key);
  };
  for (const Layer& layer : stack.layers) {
    add_keys(layer.weight);
    for (const auto& curve : layer.curves) add_keys(curve.second);
  }
  for (const auto& curve : stack.keyed) add_keys(curve.second);
  for (const auto& samples : stack.beneath) {
    if (samples.second && samples.second.use_count() == 1) bytes += samples.second->size() * sizeof(double);
  }
  return bytes;
}

bool is_active(const LayerStack& stack, int layer) {
  const bool any_solo = std::any_of(stack.layers.begin(), stack.layers.end(), [](const Layer& l) { return l.solo; });
  const Layer& asked = stack.layers[idx(layer)];
  return !asked.muted && (!any_solo || asked.solo);
}

std::vector<ChannelIndex> channels_moved_with(const Skeleton& skeleton, ChannelIndex channel) {
  std::vector<ChannelIndex> together{channel};
  const std::optional<EulerChannels> euler = find_euler_channels(skeleton, skeleton.channel(channel).joint);
  if (!euler || euler->count != 3) return together;
  const auto end = std::begin(euler->channels) + 3;
  if (std::find(std::begin(euler->channels), end, channel) == end) return together;
  together.assign(std::begin(euler->channels), end);
  std::sort(together.begin(), together.end());
  return together;
}

std::vector<ChannelIndex> layered_channels(const Skeleton& skeleton, const LayerStack& stack) {
  std::set<ChannelIndex> channels;
  for (const Layer& layer : stack.layers) {
    for (const auto& curve : layer.curves) {
      const std::vector<ChannelIndex> together = channels_moved_with(skeleton, curve.first);
      channels.insert(together.begin(), together.end());
    }
  }
  return {channels.begin(), channels.end()};
}

void lay_on(const Skeleton& skeleton, const LayerStack& stack, int first_layer, int end_layer, FrameRange frames,
            ChannelSamples& samples) {
  for (int layer = first_layer; layer < end_layer; ++layer) {
    if (!is_active(stack, layer)) continue;
    move_samples(skeleton, LaidLayer(stack.layers[idx(layer)], frames), frames, samples, Way::On);
  }
}

bool take_off(const Skeleton& skeleton, const LayerStack& stack, int first_layer, FrameRange frames,
              ChannelSamples& samples) {
  std::vector<LaidLayer> laid;
  for (int layer = size_of(stack.layers) - 1; layer >= first_layer; --layer) {
    if (!is_active(stack, layer) || !moves_any(skeleton, stack.layers[idx(layer)], samples)) continue;
    laid.emplace_back(stack.layers[idx(layer)], frames);
    if (stack.layers[idx(layer)].mode == LayerMode::Override && laid.back().counts_anywhere()) return false;
  }
  for (const LaidLayer& layer : laid) {
    if (layer.layer().mode == LayerMode::Additive) move_samples(skeleton, layer, frames, samples, Way::Off);
  }
  return true;
}

}  // namespace marey
