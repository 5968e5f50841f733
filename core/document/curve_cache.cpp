#include "core/document/curve_cache.h"

#include <algorithm>
#include <cmath>

namespace marey {
namespace {

// Panning rounds: the same width of columns may come out differently in its last digits.
constexpr double kSameWidth = 1e-9;

bool same_width(double a, double b) { return std::abs(a - b) <= kSameWidth * a; }

/// The columns that these frames are in; borders may lie elsewhere by a part of a column.
CurveColumns columns_around(FrameRange frames, const CurveColumns& within) {
  const double width = within.frames_per_column;
  const double first = std::max<double>(within.first, std::floor(frames.first / width) - 1.0);
  const double end = std::min<double>(within.first + within.count, std::ceil(frames.end() / width) + 1.0);
  return {width, static_cast<int>(first), static_cast<int>(std::max(0.0, end - first))};
}

}  // namespace

void CurveCache::follow(const Document& document, std::uint64_t clip_serial) {
  if (clip_serial != clip_serial_) {
    curves_.clear();
    saved_curves_.clear();
  }
  if (document.save_count() != saves_) saved_curves_.clear();
  clip_serial_ = clip_serial;
  saves_ = document.save_count();
}

void CurveCache::follow_edits(Curve& curve, const Document& document, std::span<const double> samples) {
  const bool same_length = curve.pyramid.sample_count() == size_of(samples);
  if (same_length && curve.revision == document.revision()) return;
  const FrameRange changed = document.history().changed_frames_since(curve.revision);
  curve.pyramid.update(samples, changed);
  curve.revision = document.revision();
  if (!same_length) {
    curve.columns = {};
    curve.extents.clear();
    return;
  }
  const CurveColumns touched = columns_around(changed, curve.columns);
  if (touched.count == 0) return;
  const auto at = idx(touched.first - curve.columns.first);
  compute_column_extents(curve.pyramid, samples, touched, std::span(curve.extents).subspan(at, idx(touched.count)));
}

std::span<const ValueExtent> CurveCache::fill_columns(Curve& curve, std::span<const double> samples,
                                                      const CurveColumns& columns) {
  CurveColumns wanted = columns;
  const CurveColumns& known = curve.columns;
  const bool reusable = known.count > 0 && same_width(known.frames_per_column, wanted.frames_per_column);
  if (reusable) wanted.frames_per_column = known.frames_per_column;
  if (reusable && known == wanted) return curve.extents;
  const int kept_first = reusable ? std::max(known.first, wanted.first) : wanted.first;
  const int kept_end = reusable ? std::min(known.first + known.count, wanted.first + wanted.count) : wanted.first;
  curve.spare.resize(idx(wanted.count));
  const std::span<ValueExtent> extents = curve.spare;
  const auto fill = [&](int first, int end) {
    if (end <= first) return;
    compute_column_extents(curve.pyramid, samples, {wanted.frames_per_column, first, end - first},
                           extents.subspan(idx(first - wanted.first), idx(end - first)));
  };
  if (kept_first >= kept_end) {
    fill(wanted.first, wanted.first + wanted.count);
  } else {
    fill(wanted.first, kept_first);
    std::copy_n(curve.extents.begin() + (kept_first - known.first), kept_end - kept_first,
                extents.begin() + (kept_first - wanted.first));
    fill(kept_end, wanted.first + wanted.count);
  }
  curve.extents.swap(curve.spare);
  curve.columns = wanted;
  return curve.extents;
}

std::span<const ValueExtent> CurveCache::columns(const Document& document, ChannelIndex channel,
                                                 const CurveColumns& columns) {
  const std::span<const double> samples = document.motion().channel_samples(channel);
  Curve& curve = curves_[channel];
  follow_edits(curve, document, samples);
  return fill_columns(curve, samples, columns);
}

std::span<const ValueExtent> CurveCache::saved_columns(const Document& document, ChannelIndex channel,
                                                       const CurveColumns& columns) {
  const std::span<const double> samples = document.saved_samples(channel);
  Curve& curve = saved_curves_[channel];
  curve.pyramid.update(samples, {});
  return fill_columns(curve, samples, columns);
}

const CurvePyramid& CurveCache::pyramid(const Document& document, ChannelIndex channel) {
  Curve& curve = curves_[channel];
  follow_edits(curve, document, document.motion().channel_samples(channel));
  return curve.pyramid;
}

}  // namespace marey
