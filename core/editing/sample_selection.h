#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/index.h"

namespace marey {

/// Neighbouring samples of one channel.
struct SampleRun {
  ChannelIndex channel = 0;
  FrameRange frames;
  friend bool operator==(const SampleRun&, const SampleRun&) = default;
};

/// A set of samples, stored as runs: sorted by channel and frame, disjoint, never adjacent, so that a box over a long
/// capture costs a few words.
class SampleSelection {
 public:
  void add(ChannelIndex channel, FrameRange frames);
  void remove(ChannelIndex channel, FrameRange frames);
  void clear() { runs_.clear(); }

  [[nodiscard]] bool contains(ChannelIndex channel, FrameIndex frame) const;
  [[nodiscard]] const std::vector<SampleRun>& runs() const { return runs_; }
  [[nodiscard]] std::span<const SampleRun> runs_of(ChannelIndex channel) const;
  [[nodiscard]] bool empty() const { return runs_.empty(); }
  /// Number of selected samples.
  [[nodiscard]] std::int64_t count() const;
  /// Channels with a selected sample, ascending.
  [[nodiscard]] std::vector<ChannelIndex> channels() const;

 private:
  std::vector<SampleRun> runs_;
};

}  // namespace marey
