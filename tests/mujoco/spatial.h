#pragma once

#include <array>
#include <glm/vec3.hpp>

namespace marey::test {

/// Three numbers of MuJoCo's.
[[nodiscard]] inline glm::dvec3 vector_at(const double* place) { return {place[0], place[1], place[2]}; }

/// MuJoCo's spatial vectors: the rotational half stands first.
struct Spatial {
  std::array<double, 6> values{};
  [[nodiscard]] glm::dvec3 angular() const { return vector_at(values.data()); }
  [[nodiscard]] glm::dvec3 linear() const { return vector_at(values.data() + 3); }
};

}  // namespace marey::test
