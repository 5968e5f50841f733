#include "core/biomechanics/segment_solid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <random>

namespace marey::test {
namespace {

glm::dmat3 diagonal(const glm::dvec3& moments) {
  return symmetric_tensor(std::array{moments.x, moments.y, moments.z, 0.0, 0.0, 0.0});
}

glm::dmat3 turned(const glm::dmat3& tensor, const glm::dmat3& rotation) { return rotation * tensor * glm::transpose(rotation); }

/// By the formula of tables of moments: I_i = m (a_j^2 + a_k^2) / 5.
glm::dvec3 ellipsoid_moments(double mass_kg, const glm::dvec3& a) {
  return mass_kg / 5.0 * glm::dvec3(a.y * a.y + a.z * a.z, a.z * a.z + a.x * a.x, a.x * a.x + a.y * a.y);
}

void expect_near(const glm::dmat3& found, const glm::dmat3& expected, double within) {
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(found[i][k], expected[i][k], within) << i << k;
  }
}

glm::dmat3 random_rotation(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return glm::mat3_cast(glm::normalize(glm::dquat(normal(random), normal(random), normal(random), normal(random))));
}

glm::dvec3 half_axes(double mass_kg, const glm::dmat3& tensor) { return find_segment_solid({0, mass_kg, {}, tensor}).half_axes_m; }

TEST(PrincipalMoments, MakeTheTensorAgain) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-3.0, 3.0);
  for (int i = 0; i < 300; ++i) {
    const glm::dmat3 tensor = symmetric_tensor(
        std::array{number(random), number(random), number(random), number(random), number(random), number(random)});
    const PrincipalMoments found = find_principal_moments(tensor);
    expect_near(turned(diagonal(found.moments), found.axes), tensor, 1e-14 * 9.0);
    expect_near(glm::transpose(found.axes) * found.axes, glm::dmat3(1.0), 1e-14);
    EXPECT_NEAR(glm::determinant(found.axes), 1.0, 1e-14);
  }
}

TEST(PrincipalMoments, MayBeEqualOrNone) {
  std::mt19937 random(8);
  for (const glm::dvec3& moments : {glm::dvec3(2.0), glm::dvec3(1.0, 1.0, 3.0), glm::dvec3(0.0, 5.0, 5.0), glm::dvec3(0.0), glm::dvec3(1e-300),
                                    glm::dvec3(1.0, 1.0 + 1e-15, 1.0 - 1e-15)}) {
    const glm::dmat3 rotation = random_rotation(random);
    const PrincipalMoments found = find_principal_moments(turned(diagonal(moments), rotation));
    std::array sorted{found.moments.x, found.moments.y, found.moments.z};
    std::sort(sorted.begin(), sorted.end());
    std::array expected{moments.x, moments.y, moments.z};
    std::sort(expected.begin(), expected.end());
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(sorted[i], expected[i], 1e-14 * std::max(expected[2], 1e-300));
    expect_near(glm::transpose(found.axes) * found.axes, glm::dmat3(1.0), 1e-14);
  }
}

TEST(PrincipalMoments, LeaveADiagonalTensorItsAxes) {
  const PrincipalMoments found = find_principal_moments(diagonal({3.0, 1.0, 2.0}));
  EXPECT_EQ(found.moments, glm::dvec3(3.0, 1.0, 2.0));
  EXPECT_EQ(found.axes, glm::dmat3(1.0));
}

TEST(SegmentSolid, HasTheTensorOfItsSegment) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> length(0.01, 1.0);
  for (int i = 0; i < 300; ++i) {
    const glm::dvec3 axes(length(random), length(random), length(random));
    const double mass_kg = 10.0 * length(random);
    const glm::dmat3 tensor = turned(diagonal(ellipsoid_moments(mass_kg, axes)), random_rotation(random));
    const SegmentSolid solid = find_segment_solid({0, mass_kg, {}, tensor});
    expect_near(turned(diagonal(ellipsoid_moments(mass_kg, solid.half_axes_m)), solid.axes), tensor, 1e-13);
    std::array found{solid.half_axes_m.x, solid.half_axes_m.y, solid.half_axes_m.z};
    std::array expected{axes.x, axes.y, axes.z};
    std::sort(found.begin(), found.end());
    std::sort(expected.begin(), expected.end());
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k], expected[k], 1e-10);
  }
}

// 2/5 m r^2 of a ball of 3 kg and 0.2 m; 1/12 m l^2 of a rod of 2 kg and 0.6 m, whose ellipsoid is sqrt(5/12) of its length;
// 1/12 m (b^2 + c^2) of a box of 0.1, 0.2 and 0.3 m, whose ellipsoid has half axes of sqrt(5/12) of its edges.
TEST(SegmentSolid, OfKnownBodies) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(half_axes(3.0, diagonal(glm::dvec3(0.4 * 3.0 * 0.04)))[i], 0.2, 1e-15);
  const glm::dvec3 rod = half_axes(2.0, diagonal({0.06, 0.0, 0.06}));
  EXPECT_EQ(rod.x, 0.0);
  EXPECT_EQ(rod.z, 0.0);
  EXPECT_NEAR(rod.y, 0.6 * std::sqrt(5.0 / 12.0), 1e-15);
  const glm::dvec3 box = half_axes(12.0, diagonal({0.13, 0.10, 0.05}));
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(box[i], 0.1 * (i + 1) * std::sqrt(5.0 / 12.0), 1e-15);
}

TEST(SegmentSolid, OfWhatNoBodyHas) {
  EXPECT_EQ(half_axes(1.0, diagonal({5.0, 1.0, 1.0})).x, 0.0);
  EXPECT_EQ(half_axes(0.0, diagonal({1.0, 1.0, 1.0})), glm::dvec3(0.0));
}

}  // namespace
}  // namespace marey::test
