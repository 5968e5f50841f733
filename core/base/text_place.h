#pragma once

#include <cstddef>
#include <string_view>

#include "core/base/diagnostic.h"

namespace marey {

/// Line and column of the byte at `offset`, both from 1.
[[nodiscard]] TextPlace text_place(std::string_view text, std::size_t offset);

}  // namespace marey
