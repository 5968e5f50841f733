#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <vector>

#include "wasm/app/view_context.h"
#include "wasm/render/scene.h"
#include "wasm/views/viewport/figure_cache.h"

namespace marey::app {

/// The segments of the body as ellipsoids with their moments of inertia, where the pose has them. Playing allocates nothing.
class SegmentSolids {
 public:
  /// Adds to the scene what is switched on. A figure without masses has none.
  void add(ViewContext& context, const FigureCache& figure, Scene& scene);

 private:
  /// File units, in the joint's axes.
  struct Solid {
    JointIndex joint = 0;
    glm::dvec3 center{0.0};
    glm::dmat3 half_axes{0.0};  // columns
  };
  void follow(const Analysis& analysis, double metres_per_unit, double size);

  std::vector<Solid> solids_;
  std::uint64_t body_serial_ = 0;
};

}  // namespace marey::app
