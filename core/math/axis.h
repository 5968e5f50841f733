#pragma once

#include <cstdint>

namespace marey {

enum class Axis : std::uint8_t { X, Y, Z };

}  // namespace marey
