#pragma once

#include <cstdint>
#include <vector>

#include "core/base/index.h"

namespace marey {

/// Takes rows of samples as a file has them and keeps them channel after channel. Rows are collected in a small tile and
/// transposed from there, so there is never a second copy of all samples unless more frames come than were expected.
class SampleStore {
 public:
  /// `expected_frames` sizes the store; more may come. Room for at most `most_frames` is taken at any moment, the old
  /// and the new store together while it grows.
  SampleStore(int channel_count, std::int64_t expected_frames, std::int64_t most_frames);

  /// Where the next row goes: channel_count values.
  [[nodiscard]] double* next_row() { return tile_.data() + row_begin(rows_in_tile_); }
  /// The row before, zeros if there is none. Valid until commit_row().
  [[nodiscard]] const double* previous_row() const { return tile_.data() + row_begin(rows_in_tile_ - 1); }
  /// Takes the row over that was written to next_row().
  void commit_row() {
    if (++rows_in_tile_ == tile_rows_) flush();
  }
  /// True once rows had to be dropped for want of room.
  [[nodiscard]] bool is_full() const { return is_full_; }

  [[nodiscard]] std::int64_t frame_count() const { return flushed_ + rows_in_tile_; }
  /// The first frames, at most `frame_count` and as far as they are taken over, channel-major.
  [[nodiscard]] std::vector<double> copy_of_first(std::int64_t frame_count) const;
  [[nodiscard]] std::int64_t held_bytes() const {
    return static_cast<std::int64_t>((samples_.capacity() + tile_.capacity()) * sizeof(double));
  }
  [[nodiscard]] std::int64_t flushed_frames() const { return flushed_; }
  /// The samples, channel-major; the store is empty afterwards. Precondition: flush(), !is_full().
  [[nodiscard]] std::vector<double> take_samples();
  /// Takes over the rows that were committed; is_full() is certain only after that.
  void flush();

 private:
  /// Row -1 is the last one of the tile before.
  [[nodiscard]] std::size_t row_begin(int row) const { return idx(row + 1) * idx(channel_count_); }
  [[nodiscard]] bool grow(std::int64_t needed);
  void change_capacity(std::int64_t frames);

  int channel_count_;
  int tile_rows_;
  int rows_in_tile_ = 0;
  std::int64_t flushed_ = 0;
  std::int64_t capacity_;
  std::int64_t most_frames_;
  bool is_full_ = false;
  std::vector<double> tile_;
  std::vector<double> samples_;
};

}  // namespace marey
