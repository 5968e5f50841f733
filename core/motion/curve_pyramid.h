#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "core/base/index.h"

namespace marey {

/// The lowest and the highest of some neighbouring samples. As made it holds no sample.
struct ValueExtent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  /// A sample that is not finite makes the extent a broken one, whatever else is added.
  void add(double value);
  void add(const ValueExtent& other);
  [[nodiscard]] bool empty() const { return high < low; }
  [[nodiscard]] bool is_broken() const { return low == -std::numeric_limits<double>::infinity(); }
  friend bool operator==(const ValueExtent&, const ValueExtent&) = default;
};

/// The extents of a curve's samples by blocks of 16, 64, 256 ... samples, so that a long curve is drawn at the cost of
/// pixels. It takes a sixth of the memory of the samples, which it does not keep. As made it is that of no samples.
class CurvePyramid {
 public:
  static constexpr int kSmallestBlock = 16;
  static constexpr int kGrowth = 4;  ///< blocks in one of the next level

  /// Makes it that of `samples`. Only the blocks that `changed` touches are computed again, unless the number of samples
  /// is another one than before.
  void update(std::span<const double> samples, FrameRange changed);

  [[nodiscard]] int sample_count() const { return sample_count_; }
  [[nodiscard]] int level_count() const { return size_of(levels_); }
  /// Samples in a block of a level; the last block of a level may have fewer.
  [[nodiscard]] int block_size(int level) const;
  [[nodiscard]] std::span<const ValueExtent> blocks(int level) const { return levels_[idx(level)]; }
  [[nodiscard]] std::size_t bytes() const;

 private:
  void resize(int sample_count);

  int sample_count_ = 0;
  std::vector<std::vector<ValueExtent>> levels_;
};

/// Columns of equal width in time that a curve is drawn by. Column k holds the samples from frame k * frames_per_column
/// on; columns lie at multiples of their width, so that a curve does not change its shape while it is panned.
struct CurveColumns {
  double frames_per_column = 1.0;  ///< >= 1
  int first = 0;
  int count = 0;
  friend bool operator==(const CurveColumns&, const CurveColumns&) = default;
};

/// The extents of columns, into `extents` of columns.count. Each sample is in one column, so no peak is lost. Columns of 32
/// samples and more are made of whole blocks of the pyramid, and borders move by up to a quarter of a column to lie
/// between two of them. A column beyond the samples is empty. `pyramid` is that of `samples`.
void compute_column_extents(const CurvePyramid& pyramid, std::span<const double> samples, const CurveColumns& columns,
                            std::span<ValueExtent> extents);

}  // namespace marey
