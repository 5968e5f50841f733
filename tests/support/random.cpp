#include "tests/support/random.h"

#include <cmath>
#include <cstring>

namespace marey::test {

double Random::any_finite() {
  for (;;) {
    const std::uint64_t pattern = bits();
    double value = 0.0;
    std::memcpy(&value, &pattern, sizeof value);
    if (std::isfinite(value)) return value;
  }
}

}  // namespace marey::test
