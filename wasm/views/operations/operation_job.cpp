#include "wasm/views/operations/operation_job.h"

#include <algorithm>
#include <utility>

#include "core/editing/key_edits.h"

namespace marey::app {
namespace {

constexpr std::size_t kMostAtOnce = 200'000;   // samples; as keys they take some tenths of a second
constexpr int kFrameSamples = 30'000;          // for one frame of the page
constexpr std::int64_t kFrameWork = 40'000;    // the same of LetGo::work(): some ten milliseconds

std::string_view chosen(const Operation& operation, const OperationValues& values, std::string_view parameter) {
  const std::size_t place = idx(std::max(find_parameter(operation, parameter), 0));
  return operation.parameters[place].choices[static_cast<std::size_t>(values.numbers[place])];
}

}  // namespace

bool OperationJob::is_for(const Operation& operation, const OperationValues& values, const OperationTarget& target, int frame_count) {
  if (operation.id == "let-go") return true;
  return operation.id == "to-keys" && chosen(operation, values, "measure") == "value" &&
         target.channels.size() * idx(frame_count) > kMostAtOnce;
}

Status OperationJob::start(const Operation& operation, const OperationValues& values, const OperationTarget& target, const Clip& clip,
                           std::uint64_t revision) {
  stop();
  revision_ = revision;
  if (operation.id == "let-go") {
    Result<LetGo> let_go = LetGo::make(clip, let_go_choice(operation, values));
    if (!let_go) return let_go.error();
    let_go_ = std::move(*let_go);
    frame_time_s_ = clip.motion.frame_time_s();
  } else {
    start_keys(operation, values, target);
  }
  running_ = true;
  return {};
}

void OperationJob::stop() {
  running_ = false;
  let_go_.reset();
  curves_.clear();
  channels_.clear();
}

void OperationJob::start_keys(const Operation& operation, const OperationValues& values, const OperationTarget& target) {
  const std::string_view interpolation = chosen(operation, values, "interpolation");
  making_ = {};
  making_.tolerance = values.numbers[idx(std::max(find_parameter(operation, "tolerance"), 0))];
  making_.interpolation = interpolation == "linear"    ? Interpolation::Linear
                          : interpolation == "stepped" ? Interpolation::Stepped
                                                       : Interpolation::Bezier;
  channels_ = target.channels;
}

float OperationJob::share() const { return static_cast<float>(done()) / static_cast<float>(std::max(all(), 1)); }

SmallText OperationJob::progress() const {
  if (let_go_) return SmallText("{:.1f} of {:.1f} s", done() * frame_time_s_, all() * frame_time_s_);
  return SmallText("Channel {} of {}", done(), all());
}

Status OperationJob::advance(const Clip& clip) {
  if (let_go_) {
    const std::int64_t end = let_go_->work() + kFrameWork;
    while (running_ && done() < all() && let_go_->work() < end) {
      if (Status status = let_go_->advance(1); !status) {
        running_ = false;
        return status;
      }
    }
  } else {
    int samples = 0;
    while (running_ && done() < all() && samples < kFrameSamples) {
      curves_.merge(make_keys(clip, {channels_[idx(done())]}, making_));
      samples += std::max(clip.motion.frame_count(), 1);
    }
  }
  running_ = running_ && done() < all();
  return {};
}

Result<OperationOutcome> OperationJob::outcome(const Operation& operation, const OperationTarget& target, OperationValues values,
                                               const Clip& clip) const {
  if (let_go_) {
    values.let_go = &*let_go_;
    return make_operation_edit(clip, operation, target, values);
  }
  Result<Edit> edit = make_keys_edit(clip, std::string(operation.label), kOwnKeys, curves_);
  if (!edit) return edit.error();
  return OperationOutcome{std::move(*edit), {describe_keys(clip, curves_)}};
}

}  // namespace marey::app
