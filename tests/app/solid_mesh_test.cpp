#include "wasm/render/solid_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <tuple>

namespace marey::app {
namespace {

using Place = std::tuple<int, int, int>;

Place place_of(const glm::vec3& p) {
  const auto rounded = [](float value) { return static_cast<int>(std::lround(value * 1e4f)); };
  return {rounded(p.x), rounded(p.y), rounded(p.z)};
}

std::vector<glm::vec3> positions_of(const BoneMesh& mesh) {
  std::vector<glm::vec3> positions;
  for (const BoneVertex& vertex : mesh.vertices) positions.emplace_back(vertex.section, vertex.along * 6.0f);
  return positions;
}

struct Solid {
  std::vector<glm::vec3> positions;
  std::vector<std::uint16_t> indices;
  glm::vec3 inside{0.0f};
};

std::vector<Solid> solids() {
  std::vector<Solid> all;
  for (const auto& [sides, rings] : {std::pair{3, 2}, {8, 4}, {16, 9}}) {
    const BoneMesh bone = make_bone_mesh(sides, rings);
    all.push_back({positions_of(bone), bone.indices, {0.0f, 0.0f, 3.0f}});
  }
  const BallMesh ball = make_ball_mesh(10);
  all.push_back({ball.vertices, ball.indices, {}});
  return all;
}

// Each edge is walked once in each direction, so nothing is open and all triangles turn the same way.
TEST(SolidMesh, IsClosed) {
  for (const Solid& solid : solids()) {
    std::map<std::pair<Place, Place>, int> edges;
    for (std::size_t i = 0; i < solid.indices.size(); i += 3) {
      Place corner[3];
      for (std::size_t k = 0; k < 3; ++k) corner[k] = place_of(solid.positions[solid.indices[i + k]]);
      if (std::set<Place>(corner, corner + 3).size() < 3) continue;
      for (std::size_t k = 0; k < 3; ++k) ++edges[{corner[k], corner[(k + 1) % 3]}];
    }
    ASSERT_GT(edges.size(), 8u);
    for (const auto& [edge, count] : edges) {
      EXPECT_EQ(count, 1);
      EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
    }
  }
}

TEST(SolidMesh, TrianglesFaceOutwards) {
  for (const Solid& solid : solids()) {
    double volume = 0.0;
    for (std::size_t i = 0; i < solid.indices.size(); i += 3) {
      const glm::vec3 a = solid.positions[solid.indices[i]] - solid.inside;
      const glm::vec3 b = solid.positions[solid.indices[i + 1]] - solid.inside;
      const glm::vec3 c = solid.positions[solid.indices[i + 2]] - solid.inside;
      volume += static_cast<double>(glm::dot(a, glm::cross(b, c))) / 6.0;
    }
    EXPECT_GT(volume, 1.0);
  }
}

TEST(SolidMesh, BoneIsThickestAFifthOfTheWayAndNowhereThickerThanItsRadius) {
  EXPECT_FLOAT_EQ(bone_thickness(0.2f), 1.0f);
  for (float along = 0.0f; along <= 1.0f; along += 0.01f) {
    EXPECT_LE(bone_thickness(along), 1.0f);
    EXPECT_GE(bone_thickness(along), 0.3f);
  }
  for (const BoneVertex& vertex : make_bone_mesh(16, 9).vertices) {
    EXPECT_LE(std::max(std::abs(vertex.section.x), std::abs(vertex.section.y)), 1.0f + 1e-6f);
    EXPECT_NEAR(glm::length(vertex.section_normal), 1.0f, 1e-5f);
    EXPECT_GE(glm::dot(vertex.section, vertex.section_normal), 0.0f);
  }
}

}  // namespace
}  // namespace marey::app
