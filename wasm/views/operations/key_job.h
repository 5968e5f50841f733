#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "core/editing/key_making.h"
#include "core/editing/operation.h"

namespace marey::app {

/// Samples to keys, some channels in each frame of the page, so that it goes on answering meanwhile.
class KeyJob {
 public:
  /// Whether an operation with these values is one that would hold the page up and can be done in parts.
  [[nodiscard]] static bool is_for(const Operation& operation, const OperationValues& values, const OperationTarget& target,
                                   int frame_count);

  /// `revision` is that of the document as long as the job lasts.
  void start(const Operation& operation, const OperationValues& values, const OperationTarget& target, std::uint64_t revision);
  void stop() { running_ = false; }
  [[nodiscard]] bool is_running() const { return running_; }
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  /// How many channels are done, and of how many.
  [[nodiscard]] int done() const { return size_of(curves_); }
  [[nodiscard]] int all() const { return size_of(channels_); }

  /// The part of one frame. Returns true when it was the last.
  bool advance(const Clip& clip);
  [[nodiscard]] const std::map<ChannelIndex, KeyCurve>& curves() const { return curves_; }

 private:
  bool running_ = false;
  std::uint64_t revision_ = 0;
  KeyMaking making_;
  std::vector<ChannelIndex> channels_;
  std::map<ChannelIndex, KeyCurve> curves_;
};

}  // namespace marey::app
