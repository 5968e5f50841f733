#pragma once

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string_view>

#include "core/base/result.h"
#include "core/base/text_place.h"

namespace marey::cli {

/// What a JSON text holds. Error InvalidArgument with the place: "The recipe is not valid JSON.", where `what` is "The recipe".
template <class Json>
[[nodiscard]] Result<Json> parse_json(std::string_view text, std::string_view what) {
  try {
    return Json::parse(text);
  } catch (const typename Json::parse_error& error) {
    const std::size_t offset = error.byte > 0 ? error.byte - 1 : 0;
    return Error{DiagnosticCode::InvalidArgument, text_place(text, offset), fmt::format("{} is not valid JSON.", what), {}, {}};
  } catch (const typename Json::out_of_range&) {
    return Error{DiagnosticCode::InvalidArgument, {}, fmt::format("{} has a number that is too large.", what), {}, {}};
  }
}

}  // namespace marey::cli
