#include "core/motion/key_curve.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace marey::test {
namespace {

Key key_at(double frame, double value, Interpolation interpolation = Interpolation::Bezier,
           HandleKind kind = HandleKind::AutoClamped) {
  Key key;
  key.frame = frame;
  key.value = value;
  key.interpolation = interpolation;
  key.left_kind = kind;
  key.right_kind = kind;
  return key;
}

double value_of(const KeyCurve& curve, double frame) { return KeyEvaluator(curve).value_at(frame); }

KeyCurve random_curve(std::mt19937& random) {
  std::uniform_real_distribution<double> step(0.01, 9.0);
  std::uniform_real_distribution<double> value(-180.0, 180.0);
  std::uniform_real_distribution<double> reach(0.0, 12.0);
  KeyCurve curve;
  double frame = value(random) / 20.0;
  const int count = 1 + static_cast<int>(random() % 8);
  for (int i = 0; i < count; ++i, frame += step(random)) {
    Key key = key_at(frame, value(random), static_cast<Interpolation>(random() % 3));
    key.left_kind = static_cast<HandleKind>(random() % 6);
    key.right_kind = static_cast<HandleKind>(random() % 6);
    key.left = {-reach(random), value(random)};
    key.right = {reach(random), value(random)};
    curve.keys.push_back(key);
  }
  curve.before = static_cast<Extrapolation>(random() % 5);
  curve.behind = static_cast<Extrapolation>(random() % 5);
  curve.weighted = random() % 2 == 0;
  return curve;
}

// What the Bezier definition gives, the parameter found by bisection alone.
double bezier_by_bisection(const KeySpan& span, double frame) {
  const auto cubic = [](double u, double a, double b, double c, double d) {
    const double v = 1.0 - u;
    return v * v * v * a + 3.0 * u * v * v * b + 3.0 * u * u * v * c + u * u * u * d;
  };
  const double end = span.start + span.length;
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 200; ++i) {
    const double u = 0.5 * (low + high);
    const double at = cubic(u, span.start, span.start + span.right.frames, end + span.left.frames, end);
    (at > frame ? high : low) = u;
  }
  return cubic(low, span.value, span.value + span.right.value, span.end_value + span.left.value, span.end_value);
}

TEST(KeyCurve, PassesThroughEveryKeyToTheBit) {
  std::mt19937 random(1);
  for (int i = 0; i < 5000; ++i) {
    const KeyCurve curve = random_curve(random);
    ASSERT_TRUE(check_key_curve(curve).ok());
    const KeyEvaluator evaluator(curve);
    for (const Key& key : curve.keys) EXPECT_EQ(evaluator.value_at(key.frame), key.value);
  }
}

TEST(KeyCurve, SamplesAreTheValuesAtWholeFrames) {
  std::mt19937 random(2);
  for (int i = 0; i < 2000; ++i) {
    const KeyEvaluator evaluator(random_curve(random));
    std::vector<double> values(60);
    evaluator.sample({-20, 60}, values);
    for (int frame = -20; frame < 40; ++frame) EXPECT_EQ(values[idx(frame + 20)], evaluator.value_at(frame));
  }
}

TEST(KeyCurve, SolvesTheParameterOfWeightedHandles) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  double largest = 0.0;
  for (int i = 0; i < 20000; ++i) {
    KeySpan span{0.0, 10.0, -20.0, 35.0, {}, {}, Interpolation::Bezier};
    span.right = {10.0 * part(random), 60.0 * part(random) - 30.0};
    span.left = {-10.0 * part(random), 60.0 * part(random) - 30.0};
    const double frame = 10.0 * part(random);
    largest = std::max(largest, std::abs(span.value_at(frame) - bezier_by_bisection(span, frame)));
  }
  EXPECT_LT(largest, 1e-9);
}

TEST(KeyCurve, EvenHandlesAreACubicOverTime) {
  // 1 + 2 t - 3 t^2 + t^3 between 0 and 3: its slopes are 2 and 11.
  KeyCurve curve;
  curve.keys = {key_at(0.0, 1.0), key_at(3.0, 7.0)};
  curve.keys[0].right_kind = curve.keys[1].left_kind = HandleKind::Free;
  curve.keys[0].right = {5.0, 10.0};
  curve.keys[1].left = {-0.5, -5.5};
  for (double t = 0.0; t <= 3.0; t += 0.125) EXPECT_NEAR(value_of(curve, t), 1.0 + t * (2.0 + t * (t - 3.0)), 1e-12) << t;
}

TEST(KeyCurve, StepsHoldAndLinesAreStraight) {
  KeyCurve curve;
  curve.keys = {key_at(0.0, 1.0, Interpolation::Stepped), key_at(2.0, 5.0, Interpolation::Linear), key_at(4.0, 6.0)};
  EXPECT_EQ(value_of(curve, 1.999), 1.0);
  EXPECT_EQ(value_of(curve, 2.0), 5.0);
  EXPECT_DOUBLE_EQ(value_of(curve, 2.5), 5.25);
}

TEST(KeyCurve, ClampedHandlesNeverLeaveTheRangeOfTheirKeys) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> value(-90.0, 90.0);
  for (int i = 0; i < 1000; ++i) {
    KeyCurve curve;
    double frame = 0.0;
    for (int key = 0; key < 6; ++key) curve.keys.push_back(key_at(frame += 0.2 + std::abs(value(random)), value(random)));
    const KeyEvaluator evaluator(curve);
    for (std::size_t key = 0; key + 1 < curve.keys.size(); ++key) {
      const auto [low, high] = std::minmax(curve.keys[key].value, curve.keys[key + 1].value);
      for (double u = 0.0; u < 1.0; u += 0.05) {
        const double at = evaluator.value_at(std::lerp(curve.keys[key].frame, curve.keys[key + 1].frame, u));
        EXPECT_GE(at, low - 1e-9);
        EXPECT_LE(at, high + 1e-9);
      }
    }
  }
}

TEST(KeyCurve, DerivedHandlesFollowTheNeighbours) {
  KeyCurve curve;
  curve.keys = {key_at(0.0, 0.0), key_at(3.0, 3.0), key_at(9.0, 27.0)};
  const auto slope_at_middle = [&](HandleKind kind) {
    curve.keys[1].right_kind = kind;
    const Handle handle = find_handles(curve, 1).right;
    EXPECT_DOUBLE_EQ(handle.frames, 2.0);
    return handle.value / handle.frames;
  };
  EXPECT_DOUBLE_EQ(slope_at_middle(HandleKind::Auto), 3.0);
  EXPECT_DOUBLE_EQ(slope_at_middle(HandleKind::AutoClamped), 3.0);
  EXPECT_DOUBLE_EQ(slope_at_middle(HandleKind::Linear), 4.0);
  EXPECT_DOUBLE_EQ(slope_at_middle(HandleKind::Flat), 0.0);
  curve.keys[2].value = -1.0;  // now the middle key is the highest
  EXPECT_DOUBLE_EQ(slope_at_middle(HandleKind::AutoClamped), 0.0);
}

TEST(KeyCurve, TimeNeverRunsBackwards) {
  KeyCurve curve;
  curve.weighted = true;
  curve.keys = {key_at(0.0, 0.0), key_at(1.0, 1.0)};
  curve.keys[0].right_kind = curve.keys[1].left_kind = HandleKind::Free;
  curve.keys[0].right = {50.0, 25.0};
  curve.keys[1].left = {-50.0, 0.0};
  EXPECT_EQ(find_handles(curve, 0).right, (Handle{1.0, 0.5}));
  double last = -1.0;
  for (double frame = 0.0; frame <= 1.0; frame += 1.0 / 256.0) {
    const double value = value_of(curve, frame);
    EXPECT_GE(value, last);
    last = value;
  }
}

struct Beyond {
  Extrapolation kind;
  double before;  // at frame -1
  double behind;  // at frame 5
};

class KeysBeyond : public testing::TestWithParam<Beyond> {};

TEST_P(KeysBeyond, GoOnAsTheyAreTold) {
  KeyCurve curve;
  curve.keys = {key_at(0.0, 10.0, Interpolation::Linear), key_at(4.0, 18.0)};
  curve.before = curve.behind = GetParam().kind;
  EXPECT_DOUBLE_EQ(value_of(curve, -1.0), GetParam().before);
  EXPECT_DOUBLE_EQ(value_of(curve, 5.0), GetParam().behind);
}

INSTANTIATE_TEST_SUITE_P(Kinds, KeysBeyond,
                         testing::Values(Beyond{Extrapolation::Hold, 10.0, 18.0}, Beyond{Extrapolation::Linear, 8.0, 20.0},
                                         Beyond{Extrapolation::Cycle, 16.0, 12.0},
                                         Beyond{Extrapolation::CycleOffset, 8.0, 20.0},
                                         Beyond{Extrapolation::Oscillate, 12.0, 16.0}));

TEST(KeyCurve, RefusesWhatIsNoCurve) {
  KeyCurve curve;
  EXPECT_FALSE(check_key_curve(curve).ok());
  curve.keys = {key_at(0.0, 1.0), key_at(0.0, 2.0)};
  EXPECT_EQ(check_key_curve(curve).error().code, DiagnosticCode::InvalidArgument);
  curve.keys[1].frame = 1.0;
  EXPECT_TRUE(check_key_curve(curve).ok());
  curve.keys[1].value = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(check_key_curve(curve).error().code, DiagnosticCode::NotFinite);
  curve.keys[1].value = 2.0;
  curve.keys[1].left.frames = 1.0;
  EXPECT_EQ(check_key_curve(curve).error().code, DiagnosticCode::InvalidArgument);
}

}  // namespace
}  // namespace marey::test
