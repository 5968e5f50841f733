#pragma once

#include <string>
#include <vector>

namespace marey::test {

/// A text to be damaged.
struct Fixture {
  std::string name;
  std::string text;
};

/// The repository's own BVH files, long ones with their first rows only, and small texts that have what those lack.
[[nodiscard]] std::vector<Fixture> short_fixtures();

/// The samples as they are.
[[nodiscard]] std::vector<Fixture> whole_samples();

}  // namespace marey::test
