#include "wasm/views/operations/key_job.h"

#include <algorithm>

namespace marey::app {
namespace {

constexpr std::size_t kMostAtOnce = 200'000;  // samples; as keys they take some tenths of a second
constexpr int kFrameSamples = 30'000;         // for one frame of the page

std::string_view chosen(const Operation& operation, const OperationValues& values, std::string_view parameter) {
  const std::size_t place = idx(std::max(find_parameter(operation, parameter), 0));
  return operation.parameters[place].choices[static_cast<std::size_t>(values.numbers[place])];
}

}  // namespace

bool KeyJob::is_for(const Operation& operation, const OperationValues& values, const OperationTarget& target,
                    int frame_count) {
  return operation.id == "to-keys" && chosen(operation, values, "measure") == "value" &&
         target.channels.size() * idx(frame_count) > kMostAtOnce;
}

void KeyJob::start(const Operation& operation, const OperationValues& values, const OperationTarget& target,
                   std::uint64_t revision) {
  const std::string_view interpolation = chosen(operation, values, "interpolation");
  making_ = {};
  making_.tolerance = values.numbers[idx(std::max(find_parameter(operation, "tolerance"), 0))];
  making_.interpolation = interpolation == "linear"    ? Interpolation::Linear
                          : interpolation == "stepped" ? Interpolation::Stepped
                                                       : Interpolation::Bezier;
  channels_ = target.channels;
  curves_.clear();
  revision_ = revision;
  running_ = true;
}

bool KeyJob::advance(const Clip& clip) {
  int samples = 0;
  while (running_ && done() < all() && samples < kFrameSamples) {
    curves_.merge(make_keys(clip, {channels_[idx(done())]}, making_));
    samples += std::max(clip.motion.frame_count(), 1);
  }
  running_ = running_ && done() < all();
  return !running_;
}

}  // namespace marey::app
