#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace marey {

/// "1 frame", "3 frames": a count with its noun, whose plural has an s.
[[nodiscard]] inline std::string counted(std::int64_t count, std::string_view noun) {
  return std::to_string(count).append(" ").append(noun).append(count == 1 ? "" : "s");
}

}  // namespace marey
