#include "wasm/render/solid_mesh.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/base/index.h"

namespace marey::app {
namespace {

constexpr float kThickest = 0.2f;    // of the length
constexpr float kStart = 0.56f;      // thickness at the start, in radii
constexpr float kEnd = 0.40f;        // and at the end
constexpr float kSquareness = 2.6f;  // exponent of the section's superellipse; 2 is a circle

struct OutlinePoint {
  float along = 0.0f;
  float thickness = 0.0f;
  glm::vec2 direction{1.0f, 0.0f};
};

OutlinePoint outline_at(float along) {
  constexpr float kStep = 1e-3f;
  const float slope = (bone_thickness(along + kStep) - bone_thickness(along - kStep)) / (2.0f * kStep);
  return {along, bone_thickness(along), {1.0f, slope}};
}

// From tip to tip: rings crowd where the bone swells.
std::vector<OutlinePoint> make_outline(int rings) {
  std::vector<OutlinePoint> outline{{0.0f, 0.0f, {0.0f, 1.0f}}, {0.0f, kStart, {0.0f, 1.0f}}};
  for (int ring = 0; ring < rings; ++ring) {
    const float share = static_cast<float>(ring) / static_cast<float>(rings - 1);
    outline.push_back(outline_at(std::pow(share, 1.6f)));
  }
  outline.push_back({1.0f, kEnd, {0.0f, -1.0f}});
  outline.push_back({1.0f, 0.0f, {0.0f, -1.0f}});
  return outline;
}

BoneVertex bone_vertex(const OutlinePoint& point, float angle) {
  const auto signed_power = [](float base, float exponent) {
    return std::copysign(std::pow(std::abs(base), exponent), base);
  };
  const glm::vec2 section(signed_power(std::cos(angle), 2.0f / kSquareness),
                          signed_power(std::sin(angle), 2.0f / kSquareness));
  const glm::vec2 normal(signed_power(section.x, kSquareness - 1.0f), signed_power(section.y, kSquareness - 1.0f));
  return {section * point.thickness, glm::normalize(normal), point.along, point.direction};
}

// Two triangles per cell of a grid of rows that go round.
std::vector<std::uint16_t> make_band_indices(int rows, int columns) {
  std::vector<std::uint16_t> indices;
  for (int row = 0; row + 1 < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const int next = (column + 1) % columns;
      const int corners[] = {row * columns + column, row * columns + next, (row + 1) * columns + next,
                             row * columns + column, (row + 1) * columns + next, (row + 1) * columns + column};
      for (const int corner : corners) indices.push_back(static_cast<std::uint16_t>(corner));
    }
  }
  return indices;
}

}  // namespace

float bone_thickness(float along) {
  if (along < kThickest) {
    const float share = std::max(along, 0.0f) / kThickest;
    return kStart + (1.0f - kStart) * share * share * (3.0f - 2.0f * share);
  }
  const float share = (std::min(along, 1.0f) - kThickest) / (1.0f - kThickest);
  return 1.0f + (kEnd - 1.0f) * std::pow(share, 1.35f);
}

BoneMesh make_bone_mesh(int sides, int rings) {
  BoneMesh mesh;
  const std::vector<OutlinePoint> outline = make_outline(rings);
  for (const OutlinePoint& point : outline) {
    for (int side = 0; side < sides; ++side) {
      // Half a step off, so that even a coarse section is square on.
      const float angle = 2.0f * std::numbers::pi_v<float> * (static_cast<float>(side) + 0.5f) / static_cast<float>(sides);
      mesh.vertices.push_back(bone_vertex(point, angle));
    }
  }
  mesh.indices = make_band_indices(size_of(outline), sides);
  return mesh;
}

BallMesh make_ball_mesh(int rings) {
  BallMesh mesh;
  const int columns = 2 * rings;
  for (int row = 0; row <= rings; ++row) {
    const float polar = std::numbers::pi_v<float> * static_cast<float>(row) / static_cast<float>(rings);
    for (int column = 0; column < columns; ++column) {
      const float around = 2.0f * std::numbers::pi_v<float> * static_cast<float>(column) / static_cast<float>(columns);
      mesh.vertices.emplace_back(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), -std::cos(polar));
    }
  }
  mesh.indices = make_band_indices(rings + 1, columns);
  return mesh;
}

}  // namespace marey::app
