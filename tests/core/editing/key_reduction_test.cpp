#include "core/editing/key_reduction.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "core/motion/curve_deviation.h"
#include "tests/support/random.h"

namespace marey::test {
namespace {

using testing::ElementsAre;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr std::array kAllInterpolations = {Interpolation::Stepped, Interpolation::Linear, Interpolation::Bezier};
using Samples = std::vector<double>;

KeyCurve reduce(const Samples& samples, double tolerance, Interpolation interpolation = Interpolation::Bezier,
                FrameIndex first_frame = 0) {
  return reduce_to_keys(samples, first_frame, {.tolerance = tolerance, .interpolation = interpolation});
}

Samples evaluated(const KeyCurve& curve, const Samples& samples, FrameIndex first_frame = 0) {
  Samples values(samples.size());
  KeyEvaluator(curve).sample({first_frame, size_of(samples)}, values);
  return values;
}

std::vector<double> frames_of(const KeyCurve& curve) {
  std::vector<double> frames;
  for (const Key& key : curve.keys) frames.push_back(key.frame);
  return frames;
}

bool has_same_bits(double a, double b) { return a == b && std::signbit(a) == std::signbit(b); }

// Paper A, Fig. 4: the angles of a gymnast on the high bar in degrees, 23 frames.
struct GymnastChannel {
  std::string name;
  Samples angles;
  std::array<int, 4> linear_keys;  // for 0.5, 1, 2 and 5 degrees: theory.md, section 9, by dynamic programming
};
constexpr std::array kGymnastTolerances = {0.5, 1.0, 2.0, 5.0};

std::vector<GymnastChannel> gymnast() {
  return {{"arms",
           {16.6,  27.8,  39.6,  52.7,  67.5,  84.1,  102.3, 121.9, 142.9, 164.8, 186.3, 205.5,
            222.1, 237.3, 253.8, 272.9, 293.4, 312.2, 327.2, 338.7, 347.8, 355.8, 363.3},
           {17, 12, 8, 5}},
          {"shoulder",
           {7.0,  6.2,  5.5,  4.7,  3.9,  3.2,  2.8,  2.7,  2.9, 3.9, 6.4, 11.8,
            20.6, 31.0, 38.2, 38.1, 31.3, 21.5, 12.7, 6.6, 3.5, 3.0, 4.1},
           {16, 13, 9, 6}},
          {"hip",
           {-2.7, 0.2, 2.0, 0.8,  -5.0, -15.8, -28.2, -36.5, -37.2, -31.4, -22.3, -11.1,
            -0.8, 3.9, 2.2, -2.3, -5.4, -5.5,  -3.1,  -0.3,  1.6,   2.3,   1.9},
           {20, 16, 13, 7}}};
}

Samples make_samples(int count, const std::function<double(int)>& value) {
  Samples samples(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) samples[idx(i)] = value(i);
  return samples;
}

// 120 Hz, degrees.
Samples make_movement(int count, double noise, Random& random) {
  std::array<double, 4> phases{};
  for (double& phase : phases) phase = random.between(0, 6.28);
  return make_samples(count, [&](int frame) {
    const double t = frame / 120.0 * 2.0 * std::numbers::pi;
    return 30.0 * std::sin(0.5 * t + phases[0]) + 12.0 * std::sin(1.1 * t + phases[1]) +
           6.0 * std::sin(2.3 * t + phases[2]) + 2.0 * std::sin(5.0 * t + phases[3]) + random.between(-noise, noise);
  });
}

// Movements, walks, noise, steps, spikes, slopes and constants of any size, some with missing samples.
Samples make_any_curve(Random& random) {
  const int kind = static_cast<int>(random.between(0, 8));
  const int count = random.between(0, 1) < 0.1 ? static_cast<int>(random.between(1, 4))
                                               : static_cast<int>(random.between(4, 120));
  const double scale = random.between(0, 1) < 0.2 ? std::pow(10.0, random.between(-12, 12)) : 1.0;
  const double rate = random.between(0.01, 1.0);
  const double noise = random.between(0, 1) < 0.5 ? 0.0 : random.between(0, 0.5);
  double walk = random.between(-50, 50);
  Samples samples = make_samples(count, [&](int i) {
    const double jitter = random.between(-noise, noise);
    const double rare = random.between(0, 1) < 0.05 ? random.between(-90, 90) : 0.0;
    switch (kind) {
      case 0: return walk += random.between(-2, 2);
      case 1: return 40.0 * std::sin(rate * i) + jitter;
      case 2: return walk += rare;
      case 3: return rare + jitter;
      case 4: return random.between(-1, 1);
      case 5: return rate * i + jitter;
      case 6: return std::floor(random.between(-2, 2));
      default: return walk;
    }
  });
  const bool has_gaps = random.between(0, 1) < 0.2;
  for (double& value : samples) value = has_gaps && random.between(0, 1) < 0.2 ? kNan : value * scale;
  return samples;
}

// By trying all pairs with the evaluator itself.
int least_linear_keys(const Samples& samples, double tolerance) {
  std::vector<int> least(samples.size(), size_of(samples) + 1);
  least[0] = 1;
  for (int to = 1; to < size_of(samples); ++to) {
    for (int from = 0; from < to; ++from) {
      KeySpan span{static_cast<double>(from), static_cast<double>(to - from), samples[idx(from)], samples[idx(to)], {}, {},
                   Interpolation::Linear};
      bool holds = true;
      for (int i = from + 1; i < to && holds; ++i) holds = std::abs(span.value_at(i) - samples[idx(i)]) <= tolerance;
      if (holds) least[idx(to)] = std::min(least[idx(to)], least[idx(from)] + 1);
    }
  }
  return least.back();
}

TEST(KeyReduction, LinearKeysOfTheGymnastAreTheFewestPossible) {
  for (const GymnastChannel& channel : gymnast()) {
    for (std::size_t i = 0; i < kGymnastTolerances.size(); ++i) {
      const KeyCurve curve = reduce(channel.angles, kGymnastTolerances[i], Interpolation::Linear);
      EXPECT_EQ(size_of(curve.keys), channel.linear_keys[i]) << channel.name << " " << kGymnastTolerances[i];
    }
  }
}

TEST(KeyReduction, BezierKeysOfTheGymnastAreFewerStill) {
  const std::array<std::array<int, 4>, 3> expected = {{{5, 4, 4, 3}, {5, 4, 4, 3}, {6, 5, 4, 4}}};
  for (std::size_t c = 0; c < 3; ++c) {
    const GymnastChannel channel = gymnast()[c];
    for (std::size_t i = 0; i < kGymnastTolerances.size(); ++i) {
      const KeyCurve curve = reduce(channel.angles, kGymnastTolerances[i]);
      EXPECT_EQ(size_of(curve.keys), expected[c][i]) << channel.name << " " << kGymnastTolerances[i];
      EXPECT_LT(size_of(curve.keys), channel.linear_keys[i]);
      EXPECT_LE(find_deviation(channel.angles, evaluated(curve, channel.angles)).largest, kGymnastTolerances[i]);
    }
  }
}

TEST(KeyReduction, LinearKeysAreTheFewestPossible) {
  Random random(31);
  for (int i = 0; i < 1500; ++i) {
    Samples samples = make_any_curve(random);
    for (double& value : samples) value = std::isfinite(value) ? value : 0.0;
    // Whole numbers as well, where errors are often exactly the tolerance.
    if (i % 2 == 0) {
      for (double& value : samples) value = std::round(value);
    }
    const double tolerance = i % 3 == 0 ? 0.5 * std::round(random.between(0, 6)) : std::pow(10.0, random.between(-3, 2));
    if (tolerance == 0.0) continue;
    ASSERT_EQ(size_of(reduce(samples, tolerance, Interpolation::Linear).keys), least_linear_keys(samples, tolerance)) << i;
  }
}

TEST(KeyReduction, IsNeverOverItsToleranceAndNeverTakesMoreKeysForALargerOne) {
  Random random(32);
  for (int i = 0; i < 4000; ++i) {
    const Samples samples = make_any_curve(random);
    const FrameIndex first_frame = static_cast<FrameIndex>(random.between(-50, 1000));
    std::vector<double> tolerances(6);
    for (double& tolerance : tolerances) tolerance = std::pow(10.0, random.between(-6, 3));
    std::sort(tolerances.begin(), tolerances.end());
    tolerances.insert(tolerances.begin(), 0.0);
    for (const Interpolation interpolation : kAllInterpolations) {
      std::size_t before = samples.size();
      for (const double tolerance : tolerances) {
        const KeyCurve curve = reduce(samples, tolerance, interpolation, first_frame);
        ASSERT_TRUE(check_key_curve(curve).ok());
        ASSERT_LE(find_deviation(samples, evaluated(curve, samples, first_frame)).largest, tolerance) << i;
        ASSERT_LE(curve.keys.size(), before) << i << " " << tolerance;
        before = curve.keys.size();
      }
    }
  }
}

TEST(KeyReduction, BezierNeverTakesMoreKeysThanLinear) {
  Random random(33);
  for (int i = 0; i < 1000; ++i) {
    const Samples samples = make_any_curve(random);
    const double tolerance = std::pow(10.0, random.between(-2, 2));
    ASSERT_LE(reduce(samples, tolerance).keys.size(), reduce(samples, tolerance, Interpolation::Linear).keys.size());
  }
}

TEST(KeyReduction, KeysAreSamplesAndTheEndsAreAmongThem) {
  Random random(34);
  const Samples samples = make_movement(400, 0.05, random);
  for (const Interpolation interpolation : kAllInterpolations) {
    const KeyCurve curve = reduce(samples, 0.5, interpolation, 17);
    EXPECT_EQ(curve.keys.front().frame, 17);
    EXPECT_EQ(curve.keys.back().frame, 17 + 399);
    for (const Key& key : curve.keys) {
      EXPECT_EQ(key.value, samples[static_cast<std::size_t>(key.frame - 17)]);
      EXPECT_EQ(key.interpolation, interpolation);
    }
  }
}

TEST(KeyReduction, WithoutToleranceLosesNoBit) {
  Random random(35);
  for (int i = 0; i < 2000; ++i) {
    Samples samples = make_any_curve(random);
    for (double& value : samples) value = i % 4 == 0 && random.between(0, 1) < 0.3 ? -0.0 : value;
    for (const Interpolation interpolation : kAllInterpolations) {
      const Samples values = evaluated(reduce(samples, 0.0, interpolation), samples);
      for (std::size_t k = 0; k < samples.size(); ++k) {
        ASSERT_TRUE(!std::isfinite(samples[k]) || has_same_bits(values[k], samples[k])) << i << " " << k;
      }
    }
  }
}

TEST(KeyReduction, WithoutToleranceJoinsEqualValues) {
  Samples samples(300, 0.1);
  for (int i = 100; i < 200; ++i) samples[idx(i)] = -7.3;
  EXPECT_THAT(frames_of(reduce(samples, 0.0, Interpolation::Linear)), ElementsAre(0, 99, 100, 199, 200, 299));
  EXPECT_EQ(reduce(samples, 0.0).keys.size(), 6U);
  EXPECT_THAT(frames_of(reduce(samples, 0.0, Interpolation::Stepped)), ElementsAre(0, 100, 200, 299));
}

TEST(KeyReduction, AToleranceThatIsNoNumberOrBelowZeroCountsAsZero) {
  const Samples samples = {1, 4, 2, 8, 5, 7};
  for (const double tolerance : {kNan, -3.0}) EXPECT_EQ(reduce(samples, tolerance), reduce(samples, 0.0));
  EXPECT_EQ(reduce(samples, std::numeric_limits<double>::infinity()).keys.size(), 2U);
}

TEST(KeyReduction, SamplesThatAreNotFiniteAreBridged) {
  const double infinity = std::numeric_limits<double>::infinity();
  const Samples samples = {kNan, 1, 2, kNan, -infinity, 5, 6, 7, infinity};
  for (const Interpolation interpolation : {Interpolation::Linear, Interpolation::Bezier}) {
    const KeyCurve curve = reduce(samples, 1e-9, interpolation, 10);
    EXPECT_THAT(frames_of(curve), ElementsAre(11, 17));
    EXPECT_NEAR(KeyEvaluator(curve).value_at(14), 4.0, 1e-12);
  }
}

TEST(KeyReduction, WithoutAnyFiniteSampleThereIsOneKeyWithValueZero) {
  for (const Samples& samples : {Samples{}, Samples{kNan}, Samples(5, kNan)}) {
    const KeyCurve curve = reduce(samples, 1.0, Interpolation::Linear, 3);
    ASSERT_EQ(curve.keys.size(), 1U);
    EXPECT_EQ(curve.keys[0].frame, 3);
    EXPECT_EQ(curve.keys[0].value, 0.0);
  }
}

TEST(KeyReduction, FewSamplesAreFewKeys) {
  for (const Interpolation interpolation : kAllInterpolations) {
    EXPECT_THAT(frames_of(reduce({4}, 0.1, interpolation, 7)), ElementsAre(7));
    EXPECT_THAT(frames_of(reduce({4, 9}, 0.1, interpolation)), ElementsAre(0, 1));
    EXPECT_THAT(frames_of(reduce({4, 4.05, 4}, 0.1, interpolation)), ElementsAre(0, 2));
  }
  EXPECT_THAT(frames_of(reduce({4, 9, 4}, 0.1, Interpolation::Linear)), ElementsAre(0, 1, 2));
  EXPECT_THAT(frames_of(reduce({4, 9, 4}, 0.1)), ElementsAre(0, 2));
}

TEST(KeyReduction, HugeAndTinyValuesStayWithinTheTolerance) {
  Random random(36);
  for (const double scale : {1e308, 1.7e308, 1e300, 1e154, 1e-154, 1e-308, 5e-324}) {
    for (int i = 0; i < 60; ++i) {
      const Samples samples = make_samples(40, [&](int) { return scale * random.between(-1, 1); });
      const double tolerance = i % 2 == 0 ? scale * std::pow(10.0, random.between(-3, 0)) : 1.0;
      for (const Interpolation interpolation : kAllInterpolations) {
        const KeyCurve curve = reduce(samples, tolerance, interpolation);
        ASSERT_TRUE(check_key_curve(curve).ok()) << scale;
        ASSERT_LE(find_deviation(samples, evaluated(curve, samples)).largest, tolerance) << scale;
      }
    }
  }
}

TEST(KeyReduction, ACubicIsTwoKeys) {
  const Samples samples = make_samples(200, [](int i) { return 3.0 + 0.5 * i - 0.02 * i * i + 0.0001 * i * i * i; });
  const KeyCurve curve = reduce(samples, 1e-6);
  EXPECT_THAT(frames_of(curve), ElementsAre(0, 199));
  const HandlePair handles = find_handles(curve, 0);
  EXPECT_NEAR(handles.right.frames, 199.0 / 3.0, 1e-12);
  EXPECT_NEAR(handles.right.value / handles.right.frames, 0.5, 1e-7);
}

TEST(KeyReduction, BothSlopesOfAlignedKeysAreEqual) {
  Random random(37);
  const Samples samples = make_movement(1000, 0.0, random);
  const KeyCurve curve = reduce(samples, 0.1);
  int aligned = 0;
  for (int i = 0; i < size_of(curve.keys); ++i) {
    const Key& key = curve.keys[idx(i)];
    EXPECT_EQ(key.left_kind, key.right_kind);
    if (key.left_kind != HandleKind::Aligned) continue;
    ++aligned;
    const HandlePair handles = find_handles(curve, i);
    const double slope = handles.right.value / handles.right.frames;
    EXPECT_NEAR(handles.left.value / handles.left.frames, slope, 1e-12 * (1.0 + std::abs(slope)));
  }
  EXPECT_GT(aligned, size_of(curve.keys) / 3);
}

TEST(KeyReduction, LongCurvesTakeFewKeysWhereFewWillDo) {
  for (const Interpolation interpolation : {Interpolation::Linear, Interpolation::Bezier}) {
    EXPECT_EQ(reduce(make_samples(30000, [](int i) { return 0.01 * i; }), 1e-3, interpolation).keys.size(), 2U);
    EXPECT_EQ(reduce(Samples(30000, 4.0), 0.0, interpolation).keys.size(), 2U);
    const Samples step = make_samples(30000, [](int i) { return i < 12345 ? 0.0 : 1.0; });
    EXPECT_LE(reduce(step, 0.1, interpolation).keys.size(), 6U);
  }
  const Samples ramp = make_samples(30000, [](int i) { return 0.1 * i; });
  EXPECT_LE(reduce(ramp, 0.0, Interpolation::Linear).keys.size(), 400U);
  EXPECT_EQ(evaluated(reduce(ramp, 0.0), ramp), ramp);
  const Samples wave = make_samples(30000, [](int i) { return 40.0 * std::sin(i * (std::numbers::pi / 5000.0)); });
  EXPECT_LE(reduce(wave, 2.0).keys.size(), 8U);
}

TEST(KeyReduction, LongCurvesStayWithinTheirToleranceToo) {
  Random random(38);
  const Samples samples = make_movement(6000, 0.05, random);
  for (const Interpolation interpolation : {Interpolation::Linear, Interpolation::Bezier}) {
    std::size_t before = samples.size();
    for (const double tolerance : {0.02, 0.05, 0.2, 1.0, 8.0, 30.0}) {
      const KeyCurve curve = reduce(samples, tolerance, interpolation);
      EXPECT_LE(find_deviation(samples, evaluated(curve, samples)).largest, tolerance);
      EXPECT_LE(curve.keys.size(), before);
      before = curve.keys.size();
    }
  }
}

}  // namespace
}  // namespace marey::test
