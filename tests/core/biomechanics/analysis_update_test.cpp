#include "core/biomechanics/analysis_update.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/biomechanics/body_fixtures.h"

namespace marey::test {
namespace {

constexpr double kRate_hz = 60.0;

/// Two ball joints that tumble about a travelling root, in metres.
Clip make_clip(int frames) {
  const Skeleton skeleton = figures::make_skeleton({{"Hips", kNoParent, glm::dvec3(0.0), figures::channels("xyzZXY"), {}},
                                                    {"Arm", 0, {0.3, 0.2, -0.1}, figures::channels("YXZ"), {glm::dvec3(0.4, 0, 0)}}});
  return make_moving(skeleton, frames, kRate_hz, [](FrameIndex frame, ChannelIndex channel) {
    const double t = frame / kRate_hz;
    return channel < 3 ? 0.1 * std::sin(2.0 * t + channel) : 200.0 * std::sin((0.5 + 0.1 * channel) * t + channel);
  });
}

void bend(Clip& clip, FrameRange frames, double by) {
  for (ChannelIndex channel = 0; channel < clip.motion.channel_count(); ++channel) {
    const auto samples = clip.motion.channel_samples(channel);
    for (FrameIndex f = frames.first; f < frames.end(); ++f) {
      samples[idx(f)] += (channel < 3 ? 0.02 : 1.0) * by * std::sin(0.4 * (f - frames.first + 1) + channel);
    }
  }
}

double scale_of(const AnalysisColumn& column) {
  double scale = 0.0;
  for (const double value : column.values) scale = std::max(scale, std::isfinite(value) ? std::abs(value) : 0.0);
  return scale;
}

void expect_alike(const AnalysisTable& found, const AnalysisTable& expected, double within, const std::string& what) {
  ASSERT_EQ(found.columns.size(), expected.columns.size());
  for (std::size_t c = 0; c < found.columns.size(); ++c) {
    const double most = within * scale_of(expected.columns[c]) + 1e-12;
    for (std::size_t i = 0; i < expected.columns[c].values.size(); ++i) {
      const double a = found.columns[c].values[i];
      const double b = expected.columns[c].values[i];
      ASSERT_EQ(std::isnan(a), std::isnan(b)) << what << " " << found.columns[c].name << " " << i;
      if (std::isnan(b)) continue;
      ASSERT_NEAR(a, b, most) << what << " " << found.columns[c].name << ", frame " << i;
    }
  }
}

TEST(AnalysisUpdate, IsTheWholeAnalysisOfTheChangedClip) {
  const std::vector<std::string> quantities = {"position:*", "velocity:*", "path_length:*", "angle:*", "plane_angle:Arm", "angular_acceleration:*",
                                               "torque:*", "power:*", "work:*", "com", "energy", "position:Arm_end@Hips", "rotation_axis:Arm"};
  for (const auto& [method, within] : {std::pair("central", 1e-9), std::pair("savgol:7,3", 1e-9), std::pair("butterworth:6", 2e-5)}) {
    for (const FrameRange changed : {FrameRange{0, 3}, FrameRange{1, 1}, FrameRange{300, 40}, FrameRange{595, 5}, FrameRange{0, 600}}) {
      Clip clip = make_clip(600);
      AnalysisRequest request;
      request.quantities = quantities;
      request.model = make_random_model(clip.skeleton, 3);
      request.support = SupportKind::Flight;
      request.derivation = *parse_derivation(method);
      AnalysisTable table = table_of(clip, request);
      bend(clip, changed, 3.0);
      ASSERT_TRUE(update_analysis(clip, request, changed, table));
      expect_alike(table, table_of(clip, request), within, std::string(method) + " from " + std::to_string(changed.first));
    }
  }
}

// A new table says where the body touches; one that is brought up to date goes by the former word.
TEST(AnalysisUpdate, KeepsWhatHoldsTheBody) {
  Clip clip = make_clip(200);
  AnalysisRequest request;
  request.quantities = {"reaction", "torque:*", "cop"};
  request.model = make_random_model(clip.skeleton, 3);
  AnalysisTable table = table_of(clip, request);
  const SettledSupport before = *table.support;
  bend(clip, {50, 20}, 0.5);
  ASSERT_TRUE(update_analysis(clip, request, {50, 20}, table));
  request.settled = before;
  expect_alike(table, table_of(clip, request), 1e-9, "settled");
}

TEST(AnalysisUpdate, LeavesTheTableWhereNoSamplesChanged) {
  Clip clip = make_clip(100);
  AnalysisRequest request;
  request.quantities = {"velocity:Arm"};
  AnalysisTable table = table_of(clip, request);
  const AnalysisTable before = table;
  clip.settings.metres_per_unit *= 10.0;
  EXPECT_TRUE(update_analysis(clip, request, {}, table));
  expect_alike(table, before, 0.0, "nothing changed");
}

TEST(AnalysisUpdate, LeavesTheTableWhereItIsRefused) {
  Clip clip = make_clip(100);
  AnalysisRequest request;
  request.quantities = {"velocity:Arm"};
  AnalysisTable table = table_of(clip, request);
  const AnalysisTable before = table;
  clip.motion.channel_samples(0)[40] = std::nan("");
  EXPECT_FALSE(update_analysis(clip, request, {40, 1}, table));
  expect_alike(table, before, 0.0, "refused");
  EXPECT_FALSE(can_update_analysis(*parse_derivation("gcv")));
  EXPECT_TRUE(can_update_analysis(*parse_derivation("butterworth:6")));
}

}  // namespace
}  // namespace marey::test
