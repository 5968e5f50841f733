#include "core/kinematics/block_kernels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/base/bits.h"
#include "core/kinematics/block_kernel_templates.h"
#include "core/math/lanes.h"
#include "tests/support/random.h"

namespace marey {
namespace {

using test::Random;

void fill(BlockColumn& column, Random& random) {
  for (double& value : column) value = 2.0 * random.unit() - 1.0;
}

template <class Columns>
Columns random_columns(Random& random) {
  Columns columns;
  auto* parts = reinterpret_cast<BlockColumn*>(&columns);
  for (std::size_t i = 0; i < sizeof columns / sizeof(BlockColumn); ++i) fill(parts[i], random);
  return columns;
}

template <class Columns>
bool same_entries(const Columns& a, const Columns& b, int count) {
  const auto* parts_of_a = reinterpret_cast<const BlockColumn*>(&a);
  const auto* parts_of_b = reinterpret_cast<const BlockColumn*>(&b);
  for (std::size_t i = 0; i < sizeof a / sizeof(BlockColumn); ++i) {
    for (int k = 0; k < count; ++k) {
      if (!same_bits(parts_of_a[i][idx(k)], parts_of_b[i][idx(k)])) return false;
    }
  }
  return true;
}

struct HalfTurns {
  BlockColumn sines;
  BlockColumn cosines;
};

/// Angles of all sizes, with those that need care.
std::vector<double> angles(Random& random, int count) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double odd[] = {0.0, -0.0, 90.0, -360.0, 1e15, -1e300, kInfinity, std::nan("")};
  std::vector<double> result;
  for (int i = 0; i < count; ++i) {
    result.push_back(random.one_in(40) ? odd[random.below(8)] : std::ldexp(random.unit() - 0.5, random.below(16)));
  }
  return result;
}

TEST(BlockKernels, GiveTheSineAndCosineOfEachHalfAngle) {
  Random random(1);
  for (int count = 1; count <= kMostBlockFrames; ++count) {
    const std::vector<double> angles_deg = angles(random, count);
    HalfTurns found;
    block_kernels().find_half_turns(angles_deg.data(), count, found.sines, found.cosines);
    for (int i = 0; i < count; ++i) {
      const SinCos<double> expected = sincos_deg(0.5 * angles_deg[idx(i)]);
      const bool both_nan = std::isnan(expected.sine) && std::isnan(found.sines[idx(i)]) && std::isnan(found.cosines[idx(i)]);
      const bool same = same_bits(found.sines[idx(i)], expected.sine) && same_bits(found.cosines[idx(i)], expected.cosine);
      ASSERT_TRUE(both_nan || same) << angles_deg[idx(i)];
    }
  }
}

TEST(BlockKernels, GiveTheSameBitsWhateverTheWidthOfTheRegisters) {
  const BlockKernels& best = block_kernels();
  const BlockKernels& plain = block_kernels_detail::kKernels<Lanes, LaneBits>;
  if (best.place == plain.place) GTEST_SKIP() << "this processor has no wider registers";
  Random random(2);
  for (int round = 0; round < 200; ++round) {
    const int count = 1 + random.below(kMostBlockFrames);
    const auto half = random_columns<HalfTurns>(random);
    const auto from = random_columns<QuaternionColumns>(random);
    const auto origin = random_columns<PositionColumns>(random);
    const auto local = random_columns<PositionColumns>(random);
    const auto axis = static_cast<Axis>(random.below(3));
    QuaternionColumns turned[2];
    PositionColumns placed[2];
    for (int i = 0; i < 2; ++i) {
      const BlockKernels& kernels = i == 0 ? best : plain;
      kernels.turn(axis, half.sines, half.cosines, from, count, turned[i]);
      kernels.place(from, origin, local, count, placed[i]);
    }
    ASSERT_TRUE(same_entries(turned[0], turned[1], count));
    ASSERT_TRUE(same_entries(placed[0], placed[1], count));
  }
}

}  // namespace
}  // namespace marey
