#include "core/editing/operations/new_samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace marey {
namespace {

// A weight of 0 or 1 keeps bits, which the formula would round.
double mixed(double before, double after, double weight, Missing missing) {
  if (weight <= 0.0) return before;
  if (!std::isfinite(before)) return missing == Missing::Stay ? before : after;
  return weight >= 1.0 ? after : before + weight * (after - before);
}

NewSamples* find_channel(std::vector<NewSamples>& samples, ChannelIndex channel) {
  const auto found = std::lower_bound(samples.begin(), samples.end(), channel,
                                      [](const NewSamples& s, ChannelIndex c) { return s.channel < c; });
  return found != samples.end() && found->channel == channel ? &*found : nullptr;
}

bool is_finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Mixes the rotations of one joint; what it mixes is taken off the list of what is left to be mixed straight.
void mix_rotations(const OperationCall& call, const EulerChannels& euler, std::span<const double> weights,
                   std::vector<NewSamples>& samples, std::vector<bool>& is_mixed) {
  NewSamples* channels[3] = {};
  for (int i = 0; i < euler.count; ++i) {
    channels[i] = find_channel(samples, euler.channels[i]);
    if (channels[i] == nullptr) return;
  }
  for (int i = 0; i < euler.count; ++i) is_mixed[static_cast<std::size_t>(channels[i] - samples.data())] = true;
  for (std::size_t frame = 0; frame < weights.size(); ++frame) {
    if (weights[frame] >= 1.0) continue;
    const glm::dvec3 before = angles_deg_of(call.clip.motion, euler, call.target.frames.first + static_cast<int>(frame));
    glm::dvec3 after(0.0);
    for (int i = 0; i < euler.count; ++i) after[i] = channels[i]->values[frame];
    const bool stays = weights[frame] <= 0.0 || !is_finite(before) || !is_finite(after);
    const glm::dvec3 angles = stays ? before : mixed_angles(euler, before, after, weights[frame]);
    for (int i = 0; i < euler.count; ++i) channels[i]->values[frame] = angles[i];
  }
}

double finite_or_zero(double value) { return std::isfinite(value) ? value : 0.0; }

}  // namespace

double Curve::before() const {
  for (FrameIndex frame = frames.first - 1; frame >= 0; --frame) {
    if (std::isfinite(samples[idx(frame)])) return samples[idx(frame)];
  }
  const auto range = samples.subspan(idx(frames.first), idx(frames.count));
  const auto found = std::find_if(range.begin(), range.end(), [](double v) { return std::isfinite(v); });
  return found == range.end() ? 0.0 : *found;
}

double Curve::behind() const {
  for (FrameIndex frame = frames.end(); frame < size_of(samples); ++frame) {
    if (std::isfinite(samples[idx(frame)])) return samples[idx(frame)];
  }
  for (FrameIndex frame = frames.end() - 1; frame >= frames.first; --frame) {
    if (std::isfinite(samples[idx(frame)])) return samples[idx(frame)];
  }
  return finite_or_zero(samples[idx(frames.first)]);
}

Edit blended_edit(const OperationCall& call, std::vector<NewSamples> samples, Mix mix, Missing missing) {
  const std::vector<double> weights = blend_weights(call.target);
  std::vector<bool> is_mixed(samples.size());
  if (mix == Mix::Rotations) {
    for (JointIndex joint = 0; joint < call.clip.skeleton.joint_count(); ++joint) {
      const auto euler = find_euler_channels(call.clip.skeleton, joint);
      if (euler) mix_rotations(call, *euler, weights, samples, is_mixed);
    }
  }
  Edit edit;
  edit.name = edit_name(call, samples);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::span<const double> before = target_samples(call, samples[i].channel);
    std::vector<double>& after = samples[i].values;
    for (std::size_t frame = 0; frame < after.size(); ++frame) {
      after[frame] = mixed(before[frame], after[frame], is_mixed[i] ? 1.0 : weights[frame], missing);
    }
    edit.samples.push_back({samples[i].channel, call.target.frames.first, std::move(after)});
  }
  return edit;
}

OperationOutcome make_curves_edit(const OperationCall& call, const CurveWork& work, Missing missing) {
  std::vector<NewSamples> samples;
  for (const ChannelIndex channel : call.target.channels) {
    const std::span<const double> before = target_samples(call, channel);
    NewSamples after{channel, {before.begin(), before.end()}};
    work({channel, call.clip.skeleton.channel(channel).kind, call.clip.motion.channel_samples(channel), call.target.frames},
         after.values);
    samples.push_back(std::move(after));
  }
  return {blended_edit(call, std::move(samples), Mix::Values, missing), {}};
}

OperationOutcome make_mapped_edit(const OperationCall& call, const std::function<double(double)>& rule) {
  return make_curves_edit(call, [&](const Curve&, std::span<double> values) {
    std::transform(values.begin(), values.end(), values.begin(), rule);
  });
}

std::string edit_name(const OperationCall& call, std::span<const NewSamples> samples) {
  if (samples.size() == 1) return fmt::format("{} {}", call.operation.label, channel_label(call.clip.skeleton, samples[0].channel));
  return fmt::format("{} {} channels", call.operation.label, samples.size());
}

std::span<const double> target_samples(const OperationCall& call, ChannelIndex channel) {
  const FrameRange frames = call.target.frames;
  return call.clip.motion.channel_samples(channel).subspan(idx(frames.first), idx(frames.count));
}

std::vector<NewSamples> copied_angles(const OperationCall& call, const EulerChannels& euler) {
  std::vector<NewSamples> samples;
  for (int i = 0; i < euler.count; ++i) {
    const std::span<const double> before = target_samples(call, euler.channels[i]);
    samples.push_back({euler.channels[i], {before.begin(), before.end()}});
  }
  return samples;
}

void set_angles(std::vector<NewSamples>& samples, std::size_t frame, const glm::dvec3& angles_deg) {
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i].values[frame] = angles_deg[static_cast<int>(i)];
}

glm::dvec3 mixed_angles(const EulerChannels& euler, const glm::dvec3& from_deg, const glm::dvec3& to_deg, double weight) {
  const glm::dquat from = rotation_from_euler(euler.order, from_deg);
  const glm::dquat to = rotation_from_euler(euler.order, to_deg);
  const glm::dmat3 rotation = glm::mat3_cast(glm::normalize(glm::slerp(from, to, weight)));
  return euler_near(euler.order, rotation, from_deg + weight * (to_deg - from_deg));
}

void append(std::vector<NewSamples>& to, std::vector<NewSamples> from) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

}  // namespace marey
