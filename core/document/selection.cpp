#include "core/document/selection.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace marey {

Selection::Selection(const Skeleton& skeleton)
    : joint_count_(skeleton.joint_count()), channel_visible_(idx(skeleton.channel_count()), true) {
  channel_joints_.reserve(idx(skeleton.channel_count()));
  for (const Channel& channel : skeleton.channels()) channel_joints_.push_back(channel.joint);
}

void Selection::follow(const Skeleton& skeleton) {
  const auto channels = skeleton.channels();
  const bool same = skeleton.joint_count() == joint_count_ &&
                    std::equal(channels.begin(), channels.end(), channel_joints_.begin(), channel_joints_.end(),
                               [](const Channel& channel, JointIndex owner) { return channel.joint == owner; });
  if (same) return;
  const std::uint64_t serial = sample_serial_;
  *this = Selection(skeleton);
  sample_serial_ = serial + 1;
}

bool Selection::contains(JointIndex joint) const { return std::binary_search(joints_.begin(), joints_.end(), joint); }

void Selection::select_only(JointIndex joint) {
  if (!exists(joint)) return;
  anchor_joint_ = joint;
  select_joints({&joint, 1});
}

void Selection::toggle(JointIndex joint) {
  if (!exists(joint)) return;
  anchor_joint_ = joint;
  const auto place = std::lower_bound(joints_.begin(), joints_.end(), joint);
  if (place == joints_.end() || *place != joint) {
    joints_.insert(place, joint);
    active_joint_ = joint;
    return;
  }
  joints_.erase(place);
  if (active_joint_ == joint) active_joint_ = joints_.empty() ? kNoParent : joints_.back();
  drop_hidden_samples();
}

void Selection::select_through(JointIndex joint) {
  if (!exists(joint)) return;
  if (anchor_joint_ == kNoParent) anchor_joint_ = joint;
  const auto [low, high] = std::minmax(anchor_joint_, joint);
  joints_.resize(idx(high - low + 1));
  std::iota(joints_.begin(), joints_.end(), low);
  active_joint_ = joint;
  drop_hidden_samples();
}

void Selection::select_joints(std::span<const JointIndex> joints) {
  joints_.clear();
  active_joint_ = kNoParent;
  for (const JointIndex joint : joints) {
    if (!exists(joint)) continue;
    joints_.push_back(joint);
    active_joint_ = joint;
  }
  std::sort(joints_.begin(), joints_.end());
  joints_.erase(std::unique(joints_.begin(), joints_.end()), joints_.end());
  anchor_joint_ = active_joint_;
  drop_hidden_samples();
}

void Selection::clear_joints() { select_joints({}); }

void Selection::set_channel_visible(ChannelIndex channel, bool visible) {
  channel_visible_[idx(channel)] = visible;
  drop_hidden_samples();
}

std::vector<ChannelIndex> Selection::shown_channels(const Skeleton& skeleton) const {
  std::vector<ChannelIndex> channels;
  find_shown_channels(skeleton, channels);
  return channels;
}

void Selection::find_shown_channels(const Skeleton& skeleton, std::vector<ChannelIndex>& channels) const {
  channels.clear();
  for (const JointIndex joint : joints_) {
    const ChannelIndex first = skeleton.first_channel(joint);
    for (ChannelIndex channel = first; channel < first + skeleton.channel_count(joint); ++channel) {
      if (is_channel_visible(channel)) channels.push_back(channel);
    }
  }
}

bool Selection::is_shown(ChannelIndex channel) const {
  return channel >= 0 && channel < size_of(channel_joints_) && is_channel_visible(channel) &&
         contains(channel_joints_[idx(channel)]);
}

SampleSelection& Selection::change_samples() {
  ++sample_serial_;
  return samples_;
}

void Selection::drop_hidden_samples() {
  if (samples_.empty()) return;
  ++sample_serial_;
  SampleSelection kept;
  for (const SampleRun& run : samples_.runs()) {
    if (is_shown(run.channel)) kept.add(run.channel, run.frames);
  }
  samples_ = std::move(kept);
}

}  // namespace marey
