#include "core/math/euler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <string>
#include <vector>

#include "core/base/index.h"
#include "core/math/angle.h"

namespace marey {
namespace {

Axis axis_named(char letter) { return static_cast<Axis>(letter - 'X'); }

EulerOrder order_named(const std::string& letters) {
  return {axis_named(letters[0]), axis_named(letters[1]), axis_named(letters[2])};
}

const std::vector<std::string> kOrders = {"XYZ", "XZY", "YXZ", "YZX", "ZXY", "ZYX",
                                          "XYX", "XZX", "YXY", "YZY", "ZXZ", "ZYZ"};

// Largest difference of the nine entries.
double distance(const glm::dmat3& a, const glm::dmat3& b) {
  double largest = 0.0;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(a[column][row] - b[column][row]));
  }
  return largest;
}

glm::dmat3 matrix_of(EulerOrder order, const glm::dvec3& angles_deg) {
  return glm::mat3_cast(rotation_from_euler(order, angles_deg));
}

class RandomAngles {
 public:
  explicit RandomAngles(unsigned seed) : random_(seed) {}
  glm::dvec3 next(double limit_deg) {
    std::uniform_real_distribution<double> angle(-limit_deg, limit_deg);
    return {angle(random_), angle(random_), angle(random_)};
  }

 private:
  std::mt19937 random_;
};

TEST(Euler, TurnsRightHanded) {
  const glm::dvec3 y_from_x = axis_rotation(Axis::Z, 90.0) * glm::dvec3(1.0, 0.0, 0.0);
  EXPECT_LT(glm::distance(y_from_x, glm::dvec3(0.0, 1.0, 0.0)), 1e-15);
  const glm::dvec3 z_from_y = axis_rotation(Axis::X, 90.0) * glm::dvec3(0.0, 1.0, 0.0);
  EXPECT_LT(glm::distance(z_from_y, glm::dvec3(0.0, 0.0, 1.0)), 1e-15);
  const glm::dvec3 x_from_z = axis_rotation(Axis::Y, 90.0) * glm::dvec3(0.0, 0.0, 1.0);
  EXPECT_LT(glm::distance(x_from_z, glm::dvec3(1.0, 0.0, 0.0)), 1e-15);
}

// Origin: theory sheet, section 1.5; equal to SciPy and transforms3d.
TEST(Euler, MatchesWorkedVectors) {
  struct Row {
    std::string order;
    glm::dvec3 turned;
    glm::dvec4 quaternion;  // w x y z
  };
  const std::vector<Row> rows = {
      {"XYZ", {1.625125186, 0.555602736, 3.324195200}, {0.943714364, 0.268535823, 0.144878125, 0.127679441}},
      {"XZY", {0.730904025, 0.683208837, 3.605413290}, {0.951548525, 0.239298338, 0.038134576, 0.189307857}},
      {"YXZ", {2.328159673, 0.987948638, 2.757468046}, {0.951548525, 0.189307857, 0.239298338, 0.038134576}},
      {"YZX", {2.035563851, 1.703325567, 2.637264079}, {0.943714364, 0.127679441, 0.268535823, 0.144878125}},
      {"ZXY", {0.839867657, 1.556811119, 3.297114111}, {0.943714364, 0.144878125, 0.127679441, 0.268535823}},
      {"ZYX", {1.067425379, 2.289059483, 2.760581414}, {0.951548525, 0.038134576, 0.189307857, 0.239298338}},
  };
  for (const Row& row : rows) {
    const glm::dquat q = rotation_from_euler(order_named(row.order), {30.0, 20.0, 10.0});
    EXPECT_LT(glm::distance(q * glm::dvec3(1.0, 2.0, 3.0), row.turned), 1e-9) << row.order;
    EXPECT_LT(glm::distance(glm::dvec4(q.w, q.x, q.y, q.z), row.quaternion), 1e-9) << row.order;
  }
}

TEST(Euler, MultipliesAnyListOfAxesFromLeftToRight) {
  const std::vector<Axis> axes = {Axis::Y, Axis::Y, Axis::X, Axis::Z, Axis::X};
  const std::vector<double> angles_deg = {10.0, -35.0, 120.0, 7.0, 400.0};
  glm::dmat3 product(1.0);
  for (std::size_t i = 0; i < axes.size(); ++i) product = product * glm::mat3_cast(axis_rotation(axes[i], angles_deg[i]));
  EXPECT_LT(distance(glm::mat3_cast(rotation_from_euler(axes, angles_deg)), product), 1e-15);
  EXPECT_EQ(rotation_from_euler(std::vector<Axis>{}, std::vector<double>{}), glm::dquat(1.0, 0.0, 0.0, 0.0));
}

TEST(Euler, KnowsItsTwelveOrders) {
  int found = 0;
  for (int i = 0; i < 27; ++i) {
    const std::vector<Axis> axes = {static_cast<Axis>(i / 9), static_cast<Axis>(i / 3 % 3), static_cast<Axis>(i % 3)};
    if (find_euler_order(axes)) ++found;
  }
  EXPECT_EQ(found, 12);
  EXPECT_FALSE(find_euler_order(std::vector<Axis>{Axis::X, Axis::Y}));
  EXPECT_FALSE(find_euler_order(std::vector<Axis>{Axis::X, Axis::Y, Axis::Z, Axis::X}));
}

TEST(Euler, ComesBackFromAnyRotation) {
  for (const std::string& name : kOrders) {
    const EulerOrder order = order_named(name);
    const double lowest_middle = order.first == order.third ? 0.0 : -90.0;
    RandomAngles random(5);
    for (int i = 0; i < 500; ++i) {
      const glm::dmat3 rotation = matrix_of(order, random.next(400.0));
      const glm::dvec3 found = euler_from_rotation(order, rotation);
      EXPECT_LT(distance(matrix_of(order, found), rotation), 4e-15) << name;
      EXPECT_GE(found.y, lowest_middle) << name;
      EXPECT_LE(found.y, lowest_middle + 180.0) << name;
    }
  }
}

TEST(Euler, FindsTheVeryAnglesNearThePreviousOnes) {
  for (const std::string& name : kOrders) {
    RandomAngles random(6);
    for (int i = 0; i < 500; ++i) {
      const glm::dvec3 angles_deg = random.next(1000.0);
      const glm::dvec3 previous_deg = angles_deg + random.next(20.0);
      const double from_lock = std::abs(std::remainder(angles_deg.y, 90.0));
      if (from_lock < 25.0) continue;
      const glm::dvec3 found = euler_near(order_named(name), matrix_of(order_named(name), angles_deg), previous_deg);
      EXPECT_LT(glm::distance(found, angles_deg), 1e-9) << name;
    }
  }
}

// Origin: theory sheet, section 1.4.
TEST(Euler, FollowsPreviousAnglesIntoTheSecondSolution) {
  const EulerOrder zxy = order_named("ZXY");
  const glm::dmat3 rotation = matrix_of(zxy, {10.0, 100.0, 20.0});
  EXPECT_LT(glm::distance(euler_from_rotation(zxy, rotation), glm::dvec3(-170.0, 80.0, -160.0)), 1e-12);
  EXPECT_LT(glm::distance(euler_near(zxy, rotation, {12.0, 95.0, 18.0}), glm::dvec3(10.0, 100.0, 20.0)), 1e-12);
}

TEST(Euler, KeepsCountOfWholeTurns) {
  const EulerOrder zxy = order_named("ZXY");
  const glm::dvec3 found = euler_near(zxy, matrix_of(zxy, {363.3, 0.0, 0.0}), {355.8, 0.0, 0.0});
  EXPECT_LT(glm::distance(found, glm::dvec3(363.3, 0.0, 0.0)), 1e-12);
}

TEST(Euler, KeepsTheThirdAngleInGimbalLock) {
  for (const std::string& name : kOrders) {
    const EulerOrder order = order_named(name);
    const bool proper = order.first == order.third;
    for (double middle_deg : proper ? std::vector{0.0, 180.0} : std::vector{90.0, -90.0}) {
      RandomAngles random(8);
      for (int i = 0; i < 100; ++i) {
        glm::dvec3 angles_deg = random.next(170.0);
        angles_deg.y = middle_deg;
        const glm::dmat3 rotation = matrix_of(order, angles_deg);
        EXPECT_EQ(euler_from_rotation(order, rotation).z, 0.0) << name;
        EXPECT_LT(distance(matrix_of(order, euler_from_rotation(order, rotation)), rotation), 1e-8) << name;
        EXPECT_LT(glm::distance(euler_near(order, rotation, angles_deg), angles_deg), 1e-6) << name;
      }
    }
  }
}

TEST(Euler, FindsTheAngleOfAHinge) {
  for (Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
    for (double angle_deg = -179.0; angle_deg < 180.0; angle_deg += 13.0) {
      const glm::dmat3 rotation = glm::mat3_cast(axis_rotation(axis, angle_deg));
      EXPECT_NEAR(hinge_angle_from_rotation(axis, rotation), angle_deg, 1e-12);
    }
  }
}

TEST(Euler, HingeAngleIsTheLeastSquaresOne) {
  const auto misfit = [](Axis axis, double angle_deg, const glm::dmat3& rotation) {
    const glm::dmat3 d = glm::mat3_cast(axis_rotation(axis, angle_deg)) - rotation;
    return glm::dot(d[0], d[0]) + glm::dot(d[1], d[1]) + glm::dot(d[2], d[2]);
  };
  RandomAngles random(9);
  for (int i = 0; i < 300; ++i) {
    const Axis axis = static_cast<Axis>(i % 3);
    const glm::dmat3 rotation = matrix_of(order_named("ZXY"), random.next(180.0));
    const double best = hinge_angle_from_rotation(axis, rotation);
    const double least = misfit(axis, best, rotation);
    for (double other = best - 180.0; other < best + 180.0; other += 7.0) {
      EXPECT_GE(misfit(axis, other, rotation), least - 1e-12);
    }
  }
}

TEST(NearestTurn, MovesByWholeTurnsOnly) {
  EXPECT_EQ(nearest_turn(3.3, 355.0), 363.3);
  EXPECT_EQ(nearest_turn(-170.0, 185.0), 190.0);
  EXPECT_EQ(nearest_turn(10.0, 20.0), 10.0);
  EXPECT_EQ(nearest_turn(0.0, -2535.0), -2520.0);
}

}  // namespace
}  // namespace marey
