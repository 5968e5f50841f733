#pragma once

#include <string>
#include <vector>

#include "core/text/character_set.h"

namespace marey::test {

/// Names of joints as people write them, in UTF-8, and the set that programs of their country save them in.
struct NamesOfALanguage {
  const char* language;
  CharacterSet set;
  std::vector<std::string> names;
};

[[nodiscard]] const std::vector<NamesOfALanguage>& names_of_languages();

/// The bytes of `utf8` in `set`; a failed test and "" if it cannot be.
[[nodiscard]] std::string bytes_in(CharacterSet set, const std::string& utf8);

/// A BVH file whose joints have these names as bytes: a chain below a root with six channels, `header_line` before
/// MOTION, two frames.
[[nodiscard]] std::string chain_file(const std::vector<std::string>& names, const std::string& header_line = "");

}  // namespace marey::test
