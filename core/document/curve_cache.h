#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "core/document/document.h"
#include "core/motion/curve_pyramid.h"

namespace marey {

/// What curves are drawn by, derived from a document's samples: pyramids and the columns last asked for, of each channel
/// once it is asked for, and of the frames alone that an edit touched. Holds at most a third of the memory of the samples
/// it was asked for, beside 32 bytes for each column.
class CurveCache {
 public:
  /// Call before asking, in each frame. `clip_serial` changes with each opened file.
  void follow(const Document& document, std::uint64_t clip_serial);

  /// Extents of columns of the present samples of a channel, valid until the next call for this channel.
  [[nodiscard]] std::span<const ValueExtent> columns(const Document& document, ChannelIndex channel,
                                                     const CurveColumns& columns);
  /// The same of the samples as last opened or saved. Precondition: Document::saved_samples() has them.
  [[nodiscard]] std::span<const ValueExtent> saved_columns(const Document& document, ChannelIndex channel,
                                                           const CurveColumns& columns);
  [[nodiscard]] const CurvePyramid& pyramid(const Document& document, ChannelIndex channel);

 private:
  struct Curve {
    CurvePyramid pyramid;
    std::uint64_t revision = 0;  // of the samples that the pyramid is of
    CurveColumns columns;
    std::vector<ValueExtent> extents;
    std::vector<ValueExtent> spare;
  };
  void follow_edits(Curve& curve, const Document& document, std::span<const double> samples);
  [[nodiscard]] static std::span<const ValueExtent> fill_columns(Curve& curve, std::span<const double> samples,
                                                                 const CurveColumns& columns);

  std::uint64_t clip_serial_ = 0;
  std::uint64_t saves_ = 0;
  std::map<ChannelIndex, Curve> curves_;
  std::map<ChannelIndex, Curve> saved_curves_;
};

}  // namespace marey
