#include "core/motion/layer_solution.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <numbers>
#include <set>

#include "core/motion/euler_channels.h"

namespace marey {
namespace {

/// One layer at one frame.
class LayerSolver {
 public:
  LayerSolver(const Skeleton& skeleton, const LayerStack& stack, int layer, FrameIndex frame)
      : skeleton_(skeleton), stack_(stack), layer_index_(layer), layer_(stack.layers[idx(layer)]), frame_(frame) {
    if (layer_.weight) weight_ = std::clamp(KeyEvaluator(*layer_.weight).value_at(frame), 0.0, 1.0);
  }

  [[nodiscard]] bool counts() const { return weight_ > 0.0 && is_active(stack_, layer_index_); }

  /// `samples` are those that the channels which move with each other are to have. A layer that sums angles gets values for
  /// the `wanted` ones of them alone.
  [[nodiscard]] bool solve(ChannelSamples samples, const ChannelValues& wanted, ChannelValues& values) const {
    const FrameRange frames{frame_, 1};
    if (!take_off(skeleton_, stack_, layer_index_ + 1, frames, samples)) return false;
    ChannelSamples beneath;
    for (const auto& entry : samples) {
      const auto found = stack_.beneath.find(entry.first);
      if (found == stack_.beneath.end()) return false;
      beneath[entry.first] = {(*found->second)[idx(frame_)]};
    }
    lay_on(skeleton_, stack_, 0, layer_index_, frames, beneath);
    if (samples.size() == 3 && !layer_.sums_angles) {
      return solve_rotation(samples, beneath, values);
    }
    for (const auto& [channel, sample] : samples) {
      if (layer_.sums_angles && !wanted.contains(channel)) continue;
      const double difference = (sample[0] - beneath.at(channel)[0]) / weight_;
      values[channel] = layer_.mode == LayerMode::Additive ? difference
                        : weight_ == 1.0                   ? sample[0]
                                                           : beneath.at(channel)[0] + difference;
    }
    return true;
  }

 private:
  [[nodiscard]] double present_value(ChannelIndex channel, double without) const {
    const auto found = layer_.curves.find(channel);
    return found == layer_.curves.end() ? without : KeyEvaluator(*found->second).value_at(frame_);
  }

  [[nodiscard]] bool solve_rotation(const ChannelSamples& wanted, const ChannelSamples& beneath,
                                    ChannelValues& values) const {
    const EulerChannels euler = *find_euler_channels(skeleton_, skeleton_.channel(wanted.begin()->first).joint);
    glm::dvec3 to(0.0);
    glm::dvec3 from(0.0);
    glm::dvec3 near(0.0);
    const bool adds = layer_.mode == LayerMode::Additive;
    for (int c = 0; c < 3; ++c) {
      to[c] = wanted.at(euler.channels[c])[0];
      from[c] = beneath.at(euler.channels[c])[0];
      near[c] = present_value(euler.channels[c], adds ? 0.0 : to[c]);
    }
    const auto solved = !adds && weight_ == 1.0 ? std::optional(to) : solve_angles(euler.order, from, to, near);
    for (int c = 0; solved && c < 3; ++c) values[euler.channels[c]] = (*solved)[c];
    return solved.has_value();
  }

  // Nothing where the turn would be more than half a one, as its part would then be taken the other way round.
  [[nodiscard]] std::optional<glm::dvec3> solve_angles(EulerOrder order, const glm::dvec3& from, const glm::dvec3& to,
                                        const glm::dvec3& near) const {
    const glm::dquat beneath = rotation_from_euler(order, from);
    glm::dquat turn = glm::normalize(glm::inverse(beneath) * rotation_from_euler(order, to));
    if (turn.w < 0.0) turn = -turn;
    if (weight_ < 1.0) {
      const double angle = glm::angle(turn) / weight_;
      if (angle > std::numbers::pi) return std::nullopt;
      turn = glm::angleAxis(angle, glm::axis(turn));
    }
    if (layer_.mode == LayerMode::Override) turn = beneath * turn;
    return euler_near(order, glm::mat3_cast(glm::normalize(turn)), near);
  }

  const Skeleton& skeleton_;
  const LayerStack& stack_;
  int layer_index_;
  const Layer& layer_;
  FrameIndex frame_;
  double weight_ = 1.0;
};

}  // namespace

std::optional<ChannelValues> solve_layer_values(const Skeleton& skeleton, const LayerStack& stack, const Motion& result,
                                                int layer, FrameIndex frame, const ChannelValues& wanted) {
  const LayerSolver solver(skeleton, stack, layer, frame);
  if (!solver.counts()) return std::nullopt;
  std::set<ChannelIndex> done;
  ChannelValues values;
  for (const auto& entry : wanted) {
    if (done.contains(entry.first)) continue;
    ChannelSamples samples;
    for (const ChannelIndex channel : channels_moved_with(skeleton, entry.first)) {
      const auto found = wanted.find(channel);
      samples[channel] = {found == wanted.end() ? result.sample(channel, frame) : found->second};
      done.insert(channel);
    }
    if (!solver.solve(std::move(samples), wanted, values)) return std::nullopt;
  }
  return values;
}

}  // namespace marey
