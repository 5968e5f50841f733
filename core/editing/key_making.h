#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/editing/key_reduction.h"
#include "core/motion/clip.h"

namespace marey {

/// What a tolerance is measured by.
enum class ToleranceOf : std::uint8_t {
  Value,  ///< each curve in its own unit: degrees or file units
  Tips,   ///< the distance of any point of the figure from where it was, file units
};

struct KeyMaking {
  double tolerance = 0.5;
  ToleranceOf of = ToleranceOf::Value;
  Interpolation interpolation = Interpolation::Bezier;
};

/// Keys in place of the samples of some channels, those of LayerStack::beneath where layers move them. By value no sample
/// moves by more than the tolerance. By tips the curves get tolerances of their own, smaller the more of the figure hangs on
/// them, and all are widened by steps of a factor of two as long as, posed frame by frame, no joint or end site moves by
/// more than the tolerance. A larger tolerance never takes more keys.
/// `carry_on(share)` is called now and then with how much is done, 0 to 1; false stops, and the result is empty.
[[nodiscard]] std::map<ChannelIndex, KeyCurve> make_keys(const Clip& clip, const std::vector<ChannelIndex>& channels,
                                                         const KeyMaking& making,
                                                         const std::function<bool(double)>& carry_on = {});

/// "412 keys instead of 5760 samples; at most 0.498 from them (LeftArm Zrotation, frame 31)."
[[nodiscard]] std::string describe_keys(const Clip& clip, const std::map<ChannelIndex, KeyCurve>& curves);

}  // namespace marey
