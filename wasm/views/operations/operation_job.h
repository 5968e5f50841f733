#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "core/editing/key_making.h"
#include "core/editing/let_go.h"
#include "core/editing/operation.h"
#include "wasm/app/small_text.h"

namespace marey::app {

/// An operation that would hold the page up, some of it in each frame of the page, so that it goes on answering meanwhile: samples
/// to keys channel by channel, letting go frame by frame.
class OperationJob {
 public:
  /// Whether an operation with these values is one that would hold the page up and can be done in parts.
  [[nodiscard]] static bool is_for(const Operation& operation, const OperationValues& values, const OperationTarget& target, int frame_count);

  /// `revision` is that of the document as long as the job lasts. Errors: those of LetGo::make().
  [[nodiscard]] Status start(const Operation& operation, const OperationValues& values, const OperationTarget& target, const Clip& clip,
                             std::uint64_t revision);
  /// Ends the job and lets go of what it holds.
  void stop();
  [[nodiscard]] bool is_running() const { return running_; }
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  [[nodiscard]] float share() const;
  /// "Channel 3 of 9", "Second 1.5 of 10".
  [[nodiscard]] SmallText progress() const;

  /// The part of one frame of the page; it runs no longer when that was the last. Errors: those of LetGo::advance(), which end it.
  [[nodiscard]] Status advance(const Clip& clip);
  /// What the whole comes to, as make_operation_edit() says it. Precondition: it was done to the end.
  [[nodiscard]] Result<OperationOutcome> outcome(const Operation& operation, const OperationTarget& target, OperationValues values,
                                                 const Clip& clip) const;

 private:
  [[nodiscard]] int done() const { return let_go_ ? let_go_->done() : size_of(curves_); }
  [[nodiscard]] int all() const { return let_go_ ? let_go_->all() : size_of(channels_); }
  void start_keys(const Operation& operation, const OperationValues& values, const OperationTarget& target);

  bool running_ = false;
  std::uint64_t revision_ = 0;
  double frame_time_s_ = 0.0;
  KeyMaking making_;
  std::vector<ChannelIndex> channels_;
  std::map<ChannelIndex, KeyCurve> curves_;
  std::optional<LetGo> let_go_;
};

}  // namespace marey::app
