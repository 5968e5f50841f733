#include "core/bvh/sample_store.h"

#include <algorithm>

namespace marey {
namespace {

/// Rows per tile: long enough to fill cache lines when written out, small enough for the cache.
int rows_per_tile(int channel_count) {
  constexpr int kTileBytes = 512 * 1024;
  const int fitting = kTileBytes / (static_cast<int>(sizeof(double)) * std::max(channel_count, 1));
  return std::clamp(fitting, 8, 64);
}

}  // namespace

SampleStore::SampleStore(int channel_count, std::int64_t expected_frames, std::int64_t most_frames)
    : channel_count_(channel_count),
      tile_rows_(rows_per_tile(channel_count)),
      capacity_(expected_frames),
      most_frames_(most_frames),
      tile_(idx(tile_rows_ + 1) * idx(channel_count)),
      samples_(static_cast<std::size_t>(expected_frames) * idx(channel_count)) {}

void SampleStore::flush() {
  if (rows_in_tile_ == 0) return;
  if (flushed_ + rows_in_tile_ > capacity_ && !grow(flushed_ + rows_in_tile_)) {
    is_full_ = true;
    rows_in_tile_ = 0;
    return;
  }
  for (int channel = 0; channel < channel_count_; ++channel) {
    const double* from = tile_.data() + row_begin(0) + channel;
    double* to = samples_.data() + static_cast<std::size_t>(channel) * static_cast<std::size_t>(capacity_) + flushed_;
    for (int row = 0; row < rows_in_tile_; ++row) to[row] = from[idx(row) * idx(channel_count_)];
  }
  flushed_ += rows_in_tile_;
  std::copy_n(previous_row(), channel_count_, tile_.data());
  rows_in_tile_ = 0;
}

/// False if there is no room for `needed` frames beside those that are kept until they are copied.
bool SampleStore::grow(std::int64_t needed) {
  const std::int64_t frames = std::min(needed + capacity_ / 4, most_frames_ - capacity_);
  if (frames < needed) return false;
  change_capacity(frames);
  return true;
}

void SampleStore::change_capacity(std::int64_t frames) {
  const auto old_stride = static_cast<std::size_t>(capacity_);
  const auto new_stride = static_cast<std::size_t>(frames);
  const auto used = static_cast<std::size_t>(flushed_);
  if (new_stride > old_stride) {
    std::vector<double> moved(new_stride * idx(channel_count_));
    for (std::size_t c = 0; c < idx(channel_count_); ++c) {
      std::copy_n(samples_.data() + c * old_stride, used, moved.data() + c * new_stride);
    }
    samples_ = std::move(moved);
  } else {
    for (std::size_t c = 1; c < idx(channel_count_); ++c) {
      std::copy_n(samples_.data() + c * old_stride, used, samples_.data() + c * new_stride);
    }
    samples_.resize(new_stride * idx(channel_count_));
  }
  capacity_ = frames;
}

std::vector<double> SampleStore::copy_of_first(std::int64_t frame_count) const {
  const auto frames = static_cast<std::size_t>(std::min(frame_count, flushed_));
  std::vector<double> copy;
  copy.reserve(frames * idx(channel_count_));
  for (std::size_t c = 0; c < idx(channel_count_); ++c) {
    const auto begin = samples_.begin() + static_cast<std::ptrdiff_t>(c * static_cast<std::size_t>(capacity_));
    copy.insert(copy.end(), begin, begin + static_cast<std::ptrdiff_t>(frames));
  }
  return copy;
}

std::vector<double> SampleStore::take_samples() {
  if (flushed_ != capacity_) change_capacity(flushed_);
  return std::move(samples_);
}

}  // namespace marey
