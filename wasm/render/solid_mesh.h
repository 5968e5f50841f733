#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace marey::app {

/// Vertex of the unit bone that the GPU stretches between two joints.
struct BoneVertex {
  glm::vec2 section{0.0f};         ///< point of the cross section, times the thickness here, in radii
  glm::vec2 section_normal{0.0f};  ///< unit, outwards within the section
  float along = 0.0f;              ///< 0 at the start of the bone, 1 at its end
  /// Direction of the outline along the bone: x in bone lengths, y in radii. The surface normal follows from it once
  /// length and radius are known.
  glm::vec2 outline{1.0f, 0.0f};
};

struct BoneMesh {
  std::vector<BoneVertex> vertices;
  std::vector<std::uint16_t> indices;  ///< triangles, counter-clockwise from outside
};

struct BallMesh {
  std::vector<glm::vec3> vertices;  ///< on the unit sphere: position and normal in one
  std::vector<std::uint16_t> indices;
};

/// Thickness of a bone at `along` in 0..1, in radii: at most 1, a fifth of the way along.
[[nodiscard]] float bone_thickness(float along);

/// `sides` >= 3 around, `rings` >= 2 along. Closed at both ends.
[[nodiscard]] BoneMesh make_bone_mesh(int sides, int rings);

/// Sphere of `rings` >= 2 bands from pole to pole, twice as many around.
[[nodiscard]] BallMesh make_ball_mesh(int rings);

}  // namespace marey::app
