#pragma once

#include <map>
#include <string>

#include "core/base/result.h"
#include "core/editing/edit.h"
#include "core/motion/layer_solution.h"

namespace marey {

/// In place of the position of a layer: the keys that a channel has itself instead of samples.
inline constexpr int kOwnKeys = -1;

/// The keys of a channel on a layer, or its own; null where it has none. Precondition: there is such a layer.
[[nodiscard]] SharedKeys find_keys(const LayerStack& stack, int layer, ChannelIndex channel);

/// The edit that gives channels other keys on a layer, or keys of their own. A curve without keys takes them away: from a
/// layer the channel goes, a channel with keys of its own becomes samples, as they are. Refused with InvalidArgument: a layer
/// that the clip does not have or that is locked.
[[nodiscard]] Result<Edit> make_keys_edit(const Clip& clip, std::string name, int layer,
                                          std::map<ChannelIndex, KeyCurve> curves);

/// The edit that sets keys at a frame so that the result there has the wanted values: on a layer, in all channels that move
/// with the wanted ones; or with keys of the channels' own, which give what is beneath the layers. A channel of samples
/// cannot have keys of its own one by one: core/editing/key_reduction.h makes them. Refused with InvalidArgument as above, and
/// where the layer does not count at the frame or a layer above hides it.
[[nodiscard]] Result<Edit> make_pose_key_edit(const Clip& clip, std::string name, int layer, FrameIndex frame,
                                              const ChannelValues& wanted);

}  // namespace marey
