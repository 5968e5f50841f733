#pragma once

#include <array>
#include <span>

#include "core/editing/operation.h"

namespace marey {

// The rows of the table of operations, a family in each file of this folder.

[[nodiscard]] std::span<const Operation> filter_operations();
[[nodiscard]] std::span<const Operation> value_operations();
[[nodiscard]] std::span<const Operation> blend_operations();
[[nodiscard]] std::span<const Operation> rotation_operations();
[[nodiscard]] std::span<const Operation> mirror_operations();
[[nodiscard]] std::span<const Operation> placing_operations();
[[nodiscard]] std::span<const Operation> timing_operations();
[[nodiscard]] std::span<const Operation> frame_operations();
[[nodiscard]] std::span<const Operation> joining_operations();
[[nodiscard]] std::span<const Operation> mechanics_operations();
[[nodiscard]] std::span<const Operation> figure_operations();
[[nodiscard]] std::span<const Operation> axis_operations();
[[nodiscard]] std::span<const Operation> key_operations();
[[nodiscard]] std::span<const Operation> layer_operations();

[[nodiscard]] inline std::array<std::span<const Operation>, 14> operation_families() {
  return {filter_operations(),  value_operations(),  blend_operations(), rotation_operations(), mirror_operations(),
          placing_operations(), timing_operations(), frame_operations(), joining_operations(),  mechanics_operations(),
          axis_operations(),    figure_operations(), key_operations(),   layer_operations()};
}

}  // namespace marey
