#pragma once

#include <map>
#include <optional>

#include "core/motion/layers.h"

namespace marey {

/// One value for each of some channels.
using ChannelValues = std::map<ChannelIndex, double>;

/// The values that the curves of a layer must have at a frame so that the result there has the `wanted` ones; the rotation
/// channels that move with a wanted one and are not wanted themselves keep their values in `result`, and come out too.
/// Angles are those nearest to the ones that the layer has there. Nothing where the layer, or its weight at the frame, does
/// not count or is too small for the turn, or where a layer above hides it.
[[nodiscard]] std::optional<ChannelValues> solve_layer_values(const Skeleton& skeleton, const LayerStack& stack,
                                                              const Motion& result, int layer, FrameIndex frame,
                                                              const ChannelValues& wanted);

}  // namespace marey
