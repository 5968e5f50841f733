#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "core/base/result.h"

namespace marey::app {

/// What a JSON text holds. Error InvalidArgument with the place of what is no JSON.
[[nodiscard]] Result<nlohmann::json> read_json(std::string_view text);

}  // namespace marey::app
