#pragma once

#include <span>

#include "core/base/index.h"
#include "core/motion/key_curve.h"

namespace marey {

/// How captured samples become keys.
struct KeyReduction {
  double tolerance = 0.0;  ///< in the unit of the curve, >= 0; what is not a number or below counts as 0
  Interpolation interpolation = Interpolation::Bezier;  ///< of all keys
};

/// The curve with as few keys as possible that KeyEvaluator takes no further than `tolerance` from any sample, to the
/// last bit. `first_frame` is the frame of samples[0]. The first and the last finite sample are keys, and all keys lie at
/// samples and have their values. Samples that are not finite are ignored; without any finite one there is one key, at
/// `first_frame` with value 0. A larger tolerance never takes more keys. Tolerance 0 gives back every sample, bit for bit,
/// and joins what runs through exactly: equal values, and other lines and cubics where rounding allows it.
///
/// The keys are a shortest path from the first to the last sample, breadth first, where from one sample those others can
/// be reached that a span leads to within the tolerance:
/// - Stepped: the samples before the next key are as good as the first.
/// - Linear: the straight line lies in the cone of slopes that the samples on the way leave open (Imai and Iri, Polygonal
///   approximations of a curve, 1988; the cone as in Williams, An efficient algorithm for the piecewise linear
///   approximation of planar curves, 1978, for vertical errors). The number of keys is the least possible.
/// - Bezier: the cubic with end values at the samples and both end slopes by least squares stays within the tolerance, or
///   else the straight line does, so that there are no more keys than with Linear, but for rounding. As the cubics do not
///   depend on the tolerance, what a smaller one reaches a larger one reaches as well. Nothing is looked for where fourth
///   differences rule out any cubic, nor behind two failures in a row at distances that grow by a half.
///
/// Handles of Bezier keys are a third of their span long, not weighted. Where both slopes of a key can be made equal with
/// the spans beside it still within the tolerance, it is Aligned, else Free.
///
/// Time: samples times the usual length of a span. Two limits bound it where long spans fit nearly everywhere, and may
/// take some keys more than the least. In curves of more than 4096 samples spans beyond 2^24 / samples frames (at least
/// 256) join only samples whose positions are multiples of 2, of 4 when they are twice as long, and so on, and both ends.
/// And spans of more than 128 frames whose error is the tolerance but for rounding do not count, unless they are level.
[[nodiscard]] KeyCurve reduce_to_keys(std::span<const double> samples, FrameIndex first_frame,
                                      const KeyReduction& reduction);

}  // namespace marey
