#pragma once

#include <string>

namespace marey::cli {

/// What every command takes, and what it does with a file that cannot be read.
struct Input {
  std::string file;  ///< "-" for standard input
  bool strict = false;
  bool as_json = false;  ///< a refusal is printed as JSON too
};

}  // namespace marey::cli
