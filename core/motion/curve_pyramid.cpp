#include "core/motion/curve_pyramid.h"

#include <algorithm>
#include <cmath>

namespace marey {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Of fewer blocks a column would have ragged borders, of more it would be slow to read.
constexpr double kLeastBlocksPerColumn = 2.0;

int ceil_divided(int a, int b) { return (a + b - 1) / b; }

ValueExtent extent_of(std::span<const double> samples) {
  ValueExtent extent;
  double sum = 0.0;  // of zeros, until a sample is not finite
  for (const double value : samples) {
    extent.low = std::min(extent.low, value);
    extent.high = std::max(extent.high, value);
    sum += value * 0.0;
  }
  return sum == 0.0 ? extent : ValueExtent{-kInfinity, kInfinity};
}

ValueExtent extent_of(std::span<const ValueExtent> blocks) {
  ValueExtent extent;
  for (const ValueExtent& block : blocks) extent.add(block);
  return extent;
}

template <class Value>
ValueExtent extent_within(std::span<const Value> values, int first, int end) {
  const int last = std::clamp(end, 0, size_of(values));
  const int from = std::clamp(first, 0, last);
  return extent_of(values.subspan(idx(from), idx(last - from)));
}

/// The first value at or behind `border`, in values of `size` samples that lie at their middle.
int first_at(double border, int size) {
  const double middle = size > 1 ? 0.5 : 0.0;
  return static_cast<int>(std::clamp(std::ceil(border / size - middle), 0.0, 2147483647.0));
}

template <class Value>
void fill(std::span<const Value> values, int size, int last_sample, const CurveColumns& columns,
          std::span<ValueExtent> extents) {
  // The last block may have few samples and its middle beyond them: it belongs to the column of the last sample.
  const auto first_of = [&](double column) {
    const double border = column * columns.frames_per_column;
    return border > last_sample ? size_of(values) : first_at(border, size);
  };
  int begin = first_of(columns.first);
  for (int i = 0; i < columns.count; ++i) {
    const int end = first_of(columns.first + i + 1.0);
    extents[idx(i)] = extent_within(values, begin, end);
    begin = end;
  }
}

template <class Value>
void update_level(std::span<const Value> below, std::span<ValueExtent> blocks, int size, int first, int end) {
  for (int block = first; block < end; ++block) {
    blocks[idx(block)] = extent_within(below, block * size, (block + 1) * size);
  }
}

}  // namespace

void ValueExtent::add(double value) { add(std::isfinite(value) ? ValueExtent{value, value} : ValueExtent{-kInfinity, kInfinity}); }

void ValueExtent::add(const ValueExtent& other) {
  low = std::min(low, other.low);
  high = std::max(high, other.high);
}

int CurvePyramid::block_size(int level) const {
  int size = kSmallestBlock;
  for (int i = 0; i < level; ++i) size *= kGrowth;
  return size;
}

std::size_t CurvePyramid::bytes() const {
  std::size_t bytes = 0;
  for (const auto& level : levels_) bytes += level.capacity() * sizeof(ValueExtent);
  return bytes;
}

void CurvePyramid::resize(int sample_count) {
  sample_count_ = sample_count;
  levels_.clear();
  int count = ceil_divided(sample_count, kSmallestBlock);
  while (count > 0) {
    levels_.emplace_back(idx(count));
    count = count > kGrowth ? ceil_divided(count, kGrowth) : 0;
  }
}

void CurvePyramid::update(std::span<const double> samples, FrameRange changed) {
  if (size_of(samples) != sample_count_) {
    resize(size_of(samples));
    changed = {0, sample_count_};
  }
  int first = std::clamp(changed.first, 0, sample_count_);
  int end = std::clamp(changed.end(), first, sample_count_);
  for (int level = 0; level < level_count() && first < end; ++level) {
    const int size = level == 0 ? kSmallestBlock : kGrowth;
    first /= size;
    end = ceil_divided(end, size);
    const std::span<ValueExtent> blocks = levels_[idx(level)];
    if (level == 0) {
      update_level(samples, blocks, size, first, end);
    } else {
      update_level(std::span<const ValueExtent>(levels_[idx(level - 1)]), blocks, size, first, end);
    }
  }
}

void compute_column_extents(const CurvePyramid& pyramid, std::span<const double> samples, const CurveColumns& columns,
                            std::span<ValueExtent> extents) {
  int level = -1;
  while (level + 1 < pyramid.level_count() &&
         pyramid.block_size(level + 1) * kLeastBlocksPerColumn <= columns.frames_per_column) {
    ++level;
  }
  if (level < 0) {
    fill(samples, 1, size_of(samples) - 1, columns, extents);
  } else {
    fill(pyramid.blocks(level), pyramid.block_size(level), size_of(samples) - 1, columns, extents);
  }
}

}  // namespace marey
