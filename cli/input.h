#pragma once

#include <optional>
#include <string>

#include "core/bvh/limits.h"
#include "core/text/character_set.h"

namespace marey::cli {

/// What every command takes, and what it does with a file that cannot be read.
struct Input {
  std::string file;  ///< "-" for standard input
  bool strict = false;
  ReadLimits limits{};
  std::optional<CharacterSet> names_in{};  ///< without it, a guess
  bool as_json = false;  ///< a refusal is printed as JSON too
};

}  // namespace marey::cli
