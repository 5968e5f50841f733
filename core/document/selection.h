#pragma once

#include <vector>

#include "core/base/index.h"
#include "core/editing/sample_selection.h"
#include "core/skeleton/skeleton.h"

namespace marey {

/// What the user works on. Not part of the saved file and not undone.
class Selection {
 public:
  Selection() = default;
  /// Nothing selected, every channel visible.
  explicit Selection(const Skeleton& skeleton);

  /// Selected joints, ascending.
  [[nodiscard]] const std::vector<JointIndex>& joints() const { return joints_; }
  [[nodiscard]] bool contains(JointIndex joint) const;
  /// The joint selected last, whose numbers the inspector shows; kNoParent when none is selected.
  [[nodiscard]] JointIndex active_joint() const { return active_joint_; }

  void select_only(JointIndex joint);
  void toggle(JointIndex joint);
  void clear_joints();

  /// Channels shown in the curve editor can be hidden one by one.
  [[nodiscard]] bool is_channel_visible(ChannelIndex channel) const { return channel_visible_[idx(channel)]; }
  void set_channel_visible(ChannelIndex channel, bool visible) { channel_visible_[idx(channel)] = visible; }

  /// The channels that the curve editor shows: the visible channels of the selected joints, in file order.
  [[nodiscard]] std::vector<ChannelIndex> shown_channels(const Skeleton& skeleton) const;

  [[nodiscard]] const SampleSelection& samples() const { return samples_; }
  [[nodiscard]] SampleSelection& samples() { return samples_; }

 private:
  std::vector<JointIndex> joints_;
  JointIndex active_joint_ = kNoParent;
  std::vector<bool> channel_visible_;
  SampleSelection samples_;
};

}  // namespace marey
