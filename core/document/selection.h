#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/index.h"
#include "core/editing/sample_selection.h"
#include "core/skeleton/skeleton.h"

namespace marey {

/// What the user works on. Not part of the saved file and not undone. A sample stays selected only as long as its
/// channel is shown, so no operation reaches what cannot be seen.
class Selection {
 public:
  Selection() = default;
  /// Nothing selected, every channel visible.
  explicit Selection(const Skeleton& skeleton);

  /// After an edit: starts anew if the figure has other joints or channels, else nothing changes.
  void follow(const Skeleton& skeleton);

  /// Selected joints, ascending.
  [[nodiscard]] const std::vector<JointIndex>& joints() const { return joints_; }
  [[nodiscard]] bool contains(JointIndex joint) const;
  /// The joint selected last, whose numbers the inspector shows; kNoParent when none is selected.
  [[nodiscard]] JointIndex active_joint() const { return active_joint_; }

  /// A joint that does not exist is ignored by all of these.
  void select_only(JointIndex joint);
  void toggle(JointIndex joint);
  /// Selects the run of joints, in file order, from the one last selected or toggled through `joint` (Shift+click),
  /// and nothing else. The far end of the run can be chosen anew by another call.
  void select_through(JointIndex joint);
  /// Selects exactly these; the last one becomes active.
  void select_joints(std::span<const JointIndex> joints);
  void clear_joints();

  /// Channels shown in the curve editor can be hidden one by one.
  [[nodiscard]] bool is_channel_visible(ChannelIndex channel) const { return channel_visible_[idx(channel)]; }
  void set_channel_visible(ChannelIndex channel, bool visible);

  /// The channels that the curve editor shows: the visible channels of the selected joints, in file order.
  [[nodiscard]] std::vector<ChannelIndex> shown_channels(const Skeleton& skeleton) const;
  /// The same into `channels`, whose memory is used again.
  void find_shown_channels(const Skeleton& skeleton, std::vector<ChannelIndex>& channels) const;

  [[nodiscard]] const SampleSelection& samples() const { return samples_; }
  /// To change them.
  [[nodiscard]] SampleSelection& change_samples();
  /// Grows whenever the selected samples may have changed; for caches.
  [[nodiscard]] std::uint64_t sample_serial() const { return sample_serial_; }

 private:
  [[nodiscard]] bool exists(JointIndex joint) const { return joint >= 0 && joint < joint_count_; }
  [[nodiscard]] bool is_shown(ChannelIndex channel) const;
  void drop_hidden_samples();

  int joint_count_ = 0;
  std::vector<JointIndex> channel_joints_;  // owner of each channel
  std::vector<JointIndex> joints_;
  JointIndex active_joint_ = kNoParent;
  JointIndex anchor_joint_ = kNoParent;  // where select_through() starts
  std::vector<bool> channel_visible_;
  SampleSelection samples_;
  std::uint64_t sample_serial_ = 0;
};

}  // namespace marey
