#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/editing/edit.h"

namespace marey {

/// The edit that gives a clip other layers or keys, with the samples that come of them. Of `wanted` the layers and the
/// keyed channels count; what is beneath is found here: the keys of a channel that has some, else what was beneath already,
/// else the samples as they are. A channel without layers and keys of its own gets back what was beneath. Channels whose
/// layers and keys are the same stay to the bit. History checks the curves.
[[nodiscard]] Edit make_stack_edit(const Clip& clip, std::string name, LayerStack wanted);

/// The edit that changes one layer. Precondition: there is such a layer. Refused with InvalidArgument: a change of keys,
/// weight or mode of a layer that is locked before and after it.
[[nodiscard]] Result<Edit> make_layer_edit(const Clip& clip, std::string name, int layer,
                                           const std::function<void(Layer&)>& change);

/// The edit that takes one layer away. Precondition: there is such a layer. Refused with InvalidArgument if it is locked.
[[nodiscard]] Result<Edit> make_layer_deletion(const Clip& clip, int layer);

/// A name that no layer has: the wanted one, with a number behind it where it is taken. "Layer 1" if none is wanted.
[[nodiscard]] std::string free_layer_name(const LayerStack& stack, std::string_view wanted = {});

/// Keys of some curves together.
[[nodiscard]] int count_keys(const std::map<ChannelIndex, SharedKeys>& curves);

/// The samples stay as they are, layers and keys go.
[[nodiscard]] Edit make_bake_edit(const Clip& clip);

/// Makes an edit of samples, frames or the figure one that leaves layers and samples in agreement; History calls it. New
/// samples are what people want to see, so what is beneath the layers takes up the change, and keys of the channel itself
/// give way to samples. Other frames, or another figure, bake all layers and keys. An edit that brings a stack, and one of a
/// clip without any, stays. Refused with InvalidArgument: samples where a layer in place hides what is beneath.
[[nodiscard]] Result<Edit> fit_to_layers(const Clip& clip, Edit edit);

/// The samples of a channel as they were before any layer; those of the clip where none moves it.
[[nodiscard]] std::span<const double> samples_beneath(const Clip& clip, ChannelIndex channel);

}  // namespace marey
