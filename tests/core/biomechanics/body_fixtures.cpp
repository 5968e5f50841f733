#include "tests/core/biomechanics/body_fixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

namespace marey::test {

Clip make_gymnast() {
  Clip clip;
  clip.skeleton = figures::make_gymnast();
  clip.motion = figures::make_giant_swing();
  clip.settings.metres_per_unit = 0.055;
  return clip;
}

BodyModel make_gymnast_model() {
  constexpr std::array kUnits = {10.0, 12.0, 16.0};
  constexpr std::array kMass = {0.0988, 0.5040, 0.3972};
  constexpr std::array kCentre = {0.5315, 0.3158, 0.2899};
  constexpr std::array kRadius = {0.2789, 0.4435, 0.2536};
  BodyModel model;
  model.metres_per_unit = 0.055;
  for (std::size_t i = 0; i < 3; ++i) {
    const double length = 0.055 * kUnits[i];
    const double mass = 70.0 * kMass[i];
    const double moment = mass * kRadius[i] * length * kRadius[i] * length;
    const std::array moments = {moment, 0.0, moment, 0.0, 0.0, 0.0};
    model.segments.push_back({static_cast<JointIndex>(i), mass, {0.0, kCentre[i] * length, 0.0}, symmetric_tensor(moments)});
  }
  return model;
}

BodyModel make_random_model(const Skeleton& skeleton, unsigned seed) {
  std::mt19937 generator(seed);
  const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(generator); };
  BodyModel model;
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    // Four masses in space, which have some tensor about their centre.
    Segment segment;
    segment.joint = joint;
    std::array<glm::dvec3, 4> points;
    for (glm::dvec3& point : points) point = {between(-0.2, 0.2), between(-0.2, 0.2), between(-0.2, 0.2)};
    const glm::dvec3 centre = 0.25 * (points[0] + points[1] + points[2] + points[3]);
    segment.mass_kg = between(0.5, 20.0);
    segment.com_m = centre;
    for (const glm::dvec3& point : points) {
      const glm::dvec3 arm = point - centre;
      segment.inertia_kgm2 += 0.25 * segment.mass_kg * (glm::dot(arm, arm) * glm::dmat3(1.0) - glm::outerProduct(arm, arm));
    }
    model.segments.push_back(segment);
  }
  return model;
}

const std::vector<double>& column_of(const AnalysisTable& table, std::string_view name) {
  static const std::vector<double> kNone;
  const auto found = std::find_if(table.columns.begin(), table.columns.end(), [&](const AnalysisColumn& c) { return c.name == name; });
  EXPECT_NE(found, table.columns.end()) << name;
  return found == table.columns.end() ? kNone : found->values;
}

AnalysisTable table_of(const Clip& clip, const AnalysisRequest& request) {
  Result<AnalysisTable> table = analyse(clip, request);
  EXPECT_TRUE(table) << (table ? "" : table.error().message);
  return table ? std::move(*table) : AnalysisTable{};
}

}  // namespace marey::test
