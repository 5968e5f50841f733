#pragma once

#include <string_view>

#include "core/editing/operation.h"

namespace marey {

/// Position of the layer of this name, or of this number counted from 1; -1 if there is none.
[[nodiscard]] int find_layer(const LayerStack& stack, std::string_view name);

/// The layer that the parameter "layer" names; the highest where it is "". Refused where there is none.
[[nodiscard]] Result<int> choose_layer(const OperationCall& call);

/// The layer, or kOwnKeys where the parameter "layer" is "".
[[nodiscard]] Result<int> choose_keys(const OperationCall& call);

}  // namespace marey
