// Operations on recorded figures, whatever their channels, names and units.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "core/bvh/reader.h"
#include "core/document/document.h"
#include "core/editing/mirror_pairing.h"
#include "tests/core/editing/operation_clips.h"
#include "tests/support/files.h"

namespace marey::test {
namespace {

constexpr int kFrames = 60;

/// The first frames of each recorded file that can be read.
std::vector<std::pair<std::string, Clip>> recorded_clips() {
  std::vector<std::pair<std::string, Clip>> clips;
  for (const std::string& path : recorded_bvh_files()) {
    const auto text = read_shared_file(path);
    Result<BvhClip> read = text ? read_bvh(*text) : Result<BvhClip>(Error{});
    if (!read || read->motion.frame_count() == 0) continue;
    read->motion = read->motion.frames_of({0, std::min(kFrames, read->motion.frame_count())});
    clips.emplace_back(path, Document(std::move(*read), path).clip());
  }
  return clips;
}

double tolerance_of(const Clip& clip) {
  double largest = 1.0;
  for (const double value : positions_of(clip)) largest = std::max(largest, std::abs(value));
  return 1e-9 * largest;
}

bool is_finite(const Clip& clip) {
  const auto samples = clip.motion.samples();
  return std::all_of(samples.begin(), samples.end(), [](double v) { return std::isfinite(v); });
}

TEST(RecordedOperations, ThatDescribeAnewMoveNoPoint) {
  int files = 0;
  double worst = 0.0;
  for (const auto& [path, clip] : recorded_clips()) {
    if (!is_finite(clip)) continue;
    ++files;
    const std::vector<double> before = positions_of(clip);
    const double tolerance = tolerance_of(clip);
    for (const Clip& changed : {after(clip, "change-order", {{"order", 2.0}}), after(clip, "unroll"), after(clip, "solve-angles")}) {
      const double move = largest_difference(positions_of(changed), before);
      EXPECT_LT(move, tolerance) << path;
      worst = std::max(worst, move / tolerance);
    }
    const Axis up = clip.settings.up_axis;
    const Clip turned = after(clip, "up-axis", {{"to", up == Axis::Z ? 1.0 : 2.0}});
    EXPECT_EQ(bits_of(after(turned, "up-axis", {{"to", static_cast<double>(up)}})), bits_of(clip)) << path;
  }
  if (files == 0) GTEST_SKIP() << "no recorded files";
  std::printf("%d files described anew; the farthest move is %.1e of the largest coordinate\n", files, 1e-9 * worst);
}

TEST(RecordedOperations, MirrorTwiceIsTheStart) {
  int files = 0;
  int symmetric = 0;
  for (const auto& [path, clip] : recorded_clips()) {
    ++files;
    const Clip twice = after(after(clip, "mirror"), "mirror");
    EXPECT_LT(largest_difference(positions_of(twice), positions_of(clip)), tolerance_of(clip)) << path;
    const MirrorPairing pairing = find_mirror_pairs(clip.skeleton);
    symmetric += find_unsymmetric_joints(clip.skeleton, pairing, find_lateral_axis(clip.skeleton, pairing, clip.settings.up_axis)).empty() ? 1 : 0;
  }
  if (files == 0) GTEST_SKIP() << "no recorded files";
  std::printf("%d files mirrored, %d of them to an image without a fault\n", files, symmetric);
}

TEST(RecordedOperations, AllOfThemGiveWhatCanBeWrittenAndRead) {
  int files = 0;
  int made = 0;
  for (const auto& [path, clip] : recorded_clips()) {
    ++files;
    for (const Operation& operation : operations()) {
      const auto outcome = make_operation_edit(clip, operation, whole_clip(clip), values_of(operation, {}, &clip));
      if (!outcome || outcome->edit.empty()) continue;
      ++made;
      BvhClip read;
      read.skeleton = clip.skeleton;
      read.motion = clip.motion;
      Document document(std::move(read), path);
      ASSERT_TRUE(document.apply(outcome->edit)) << path << " " << operation.id;
      const Result<BvhClip> again = read_bvh(document.save_text());
      ASSERT_TRUE(again) << path << " " << operation.id;
      EXPECT_TRUE(same_numbers(again->skeleton, again->motion, document.skeleton(), document.motion())) << path << " " << operation.id;
    }
  }
  if (files == 0) GTEST_SKIP() << "no recorded files";
  std::printf("%d files, %d edits written and read back\n", files, made);
}

}  // namespace
}  // namespace marey::test
