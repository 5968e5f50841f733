#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace marey::app {

/// What a part of the program threw.
struct Fault {
  bool out_of_memory = false;
  std::string details;  ///< for whoever is to mend it; the exception's own words
};

/// Calls `act`; what it throws comes back as a value.
[[nodiscard]] std::optional<Fault> catch_fault(const std::function<void()>& act);

/// For an action without memory for it: "There is not enough memory for reading walk.bvh." and what to do about it.
[[nodiscard]] Error out_of_memory(std::string_view action);

/// What `change` returns; where its memory ends, the error. `action` as above: "this change".
[[nodiscard]] Status with_memory_for(std::string_view action, const std::function<Status()>& change);

}  // namespace marey::app
