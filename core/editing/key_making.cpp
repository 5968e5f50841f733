#include "core/editing/key_making.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "core/base/counted.h"
#include "core/editing/layer_edits.h"
#include "core/kinematics/forward_kinematics.h"
#include "core/math/angle.h"
#include "core/motion/curve_deviation.h"

namespace marey {
namespace {

using Curves = std::map<ChannelIndex, KeyCurve>;

constexpr int kBlock = 256;      // frames posed together
constexpr int kMostSteps = 60;   // of a factor of two

// The longest way down from a joint along the offsets: nothing below it is farther away.
std::vector<double> find_reaches(const Skeleton& skeleton) {
  std::vector<double> reaches(idx(skeleton.joint_count()), 0.0);
  for (NodeIndex i = skeleton.node_count() - 1; i >= 0; --i) {
    const Node& node = skeleton.node(i);
    const double below = node.is_end_site ? 0.0 : reaches[idx(node.joint)];
    const JointIndex above = node.is_end_site ? node.joint : skeleton.parent(node.joint);
    if (above != kNoParent) reaches[idx(above)] = std::max(reaches[idx(above)], below + glm::length(node.offset));
  }
  return reaches;
}

// How far a curve may go for each file unit that a tip may move.
double share_of(const Channel& channel, double reach) {
  if (is_position(channel.kind)) return 1.0;
  if (is_scale(channel.kind)) return reach > 0.0 ? 1.0 / reach : 1.0;
  return reach > 0.0 ? to_degrees(1.0 / reach) : 180.0;
}

/// Finds the widest tolerances that leave all points of the figure within a distance.
class TipFitter {
 public:
  TipFitter(const Clip& clip, const std::vector<ChannelIndex>& channels, const KeyMaking& making)
      : clip_(clip), channels_(channels), making_(making), beneath_(clip.motion) {
    for (const auto& [channel, samples] : clip.stack.beneath) {
      std::copy(samples->begin(), samples->end(), beneath_.channel_samples(channel).begin());
    }
    posed_ = beneath_;
    const std::vector<double> reaches = find_reaches(clip.skeleton);
    for (const ChannelIndex channel : channels) {
      const Channel& c = clip.skeleton.channel(channel);
      shares_.push_back(share_of(c, reaches[idx(c.joint)]));
    }
  }

  Curves fit(const std::function<bool(double)>& carry_on) {
    // Steps on a grid that does not depend on the tolerance, so that more of it never ends on a lower one.
    const double start = making_.tolerance / static_cast<double>(std::max<std::size_t>(channels_.size(), 1));
    int step = start > 0.0 ? static_cast<int>(std::floor(std::log2(start))) : 0;
    Curves best = make(start > 0.0 ? std::exp2(step) : 0.0);
    bool fits = start > 0.0 && is_within(best);
    for (int tries = 0; start > 0.0 && !fits && tries < kMostSteps; ++tries) {
      best = make(std::exp2(--step));
      fits = is_within(best);
    }
    if (!fits) return make(0.0);
    for (int tries = 1; tries < kMostSteps; ++tries) {
      if (carry_on && !carry_on(1.0 - 1.0 / tries)) return {};
      Curves wider = make(std::exp2(++step));
      if (!is_within(wider)) break;
      const bool is_least = std::all_of(wider.begin(), wider.end(), [](const auto& curve) { return curve.second.keys.size() <= 2; });
      best = std::move(wider);
      if (is_least) break;
    }
    return best;
  }

 private:
  Curves make(double scale) const {
    Curves curves;
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      curves[channels_[i]] =
          reduce_to_keys(samples_beneath(clip_, channels_[i]), 0, {scale * shares_[i], making_.interpolation});
    }
    return curves;
  }

  // Layers are left out on both sides: they move the figure as it is.
  bool is_within(const Curves& curves) {
    const FrameRange all{0, clip_.motion.frame_count()};
    for (const auto& [channel, curve] : curves) {
      const std::span<double> samples = posed_.channel_samples(channel);
      KeyEvaluator(curve).sample(all, samples);
    }
    std::vector<double> before;
    std::vector<double> now;
    for (FrameIndex first = 0; first < all.count; first += kBlock) {
      const FrameRange frames{first, std::min(kBlock, all.count - first)};
      before.resize(idx(frames.count) * idx(clip_.skeleton.node_count()) * 3);
      now.resize(before.size());
      compute_world_positions(clip_.skeleton, beneath_, frames, clip_.settings.position_rule, std::span<double>(before));
      compute_world_positions(clip_.skeleton, posed_, frames, clip_.settings.position_rule, std::span<double>(now));
      for (std::size_t i = 0; i < now.size(); i += 3) {
        const double moved = std::hypot(now[i] - before[i], now[i + 1] - before[i + 1], now[i + 2] - before[i + 2]);
        if (moved > making_.tolerance) return false;
      }
    }
    return true;
  }

  const Clip& clip_;
  const std::vector<ChannelIndex>& channels_;
  const KeyMaking& making_;
  Motion beneath_;
  Motion posed_;
  std::vector<double> shares_;
};

}  // namespace

Curves make_keys(const Clip& clip, const std::vector<ChannelIndex>& channels, const KeyMaking& making,
                 const std::function<bool(double)>& carry_on) {
  if (clip.motion.frame_count() == 0) return {};
  if (making.of == ToleranceOf::Tips) return TipFitter(clip, channels, making).fit(carry_on);
  Curves curves;
  for (const ChannelIndex channel : channels) {
    if (carry_on && !carry_on(static_cast<double>(curves.size()) / static_cast<double>(channels.size()))) return {};
    curves[channel] = reduce_to_keys(samples_beneath(clip, channel), 0, {making.tolerance, making.interpolation});
  }
  return curves;
}

std::string describe_keys(const Clip& clip, const Curves& curves) {
  std::int64_t keys = 0;
  CurveDeviation worst;
  ChannelIndex worst_channel = 0;
  const FrameRange all{0, clip.motion.frame_count()};
  std::vector<double> values(idx(all.count));
  for (const auto& [channel, curve] : curves) {
    keys += size_of(curve.keys);
    KeyEvaluator(curve).sample(all, values);
    const CurveDeviation deviation = find_deviation(samples_beneath(clip, channel), values);
    if (deviation.largest <= worst.largest) continue;
    worst = deviation;
    worst_channel = channel;
  }
  std::string text = fmt::format("{} instead of {} samples", counted(keys, "key"), std::int64_t{all.count} * size_of(curves));
  if (worst.largest > 0.0) {
    text += fmt::format("; at most {:.3g} from them ({}, frame {})", worst.largest, channel_label(clip.skeleton, worst_channel),
                        worst.at + 1);
  }
  return text + ".";
}

}  // namespace marey
