#include "core/document/curve_cache.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

#include "core/editing/clip_operations.h"
#include "core/editing/curve_operations.h"
#include "tests/core/editing/generated_clips.h"
#include "tests/support/same_elements.h"

namespace marey::test {
namespace {

constexpr int kFrames = 3000;

Document open_document() {
  BvhClip opened;
  Clip clip = make_clip(2, kFrames);
  opened.skeleton = clip.skeleton;
  opened.motion = clip.motion;
  return {std::move(opened), "walk.bvh"};
}

std::vector<ValueExtent> by_hand(std::span<const double> samples, const CurveColumns& columns) {
  CurvePyramid pyramid;
  pyramid.update(samples, {});
  std::vector<ValueExtent> extents(idx(columns.count));
  compute_column_extents(pyramid, samples, columns, extents);
  return extents;
}

class CurveCacheTest : public testing::Test {
 protected:
  CurveCacheTest() { cache.follow(document, 1); }

  void expect_present(const CurveColumns& columns, const char* what) {
    cache.follow(document, 1);
    for (ChannelIndex channel = 0; channel < document.motion().channel_count(); ++channel) {
      const auto expected = by_hand(document.motion().channel_samples(channel), columns);
      ASSERT_TRUE(test::same_elements(cache.columns(document, channel, columns), expected)) << what << ", channel " << channel;
    }
  }

  Status move(GestureId gesture, FrameRange frames, double delta) {
    return document.apply_gesture(gesture, [&](const Clip& before) {
      return make_move_edit(before, selected(kCurve, frames), delta, {4.0});
    });
  }

  Document document = open_document();
  CurveCache cache;
};

TEST_F(CurveCacheTest, FollowsEditsUndoAndRedo) {
  std::mt19937 random(11);
  const CurveColumns views[] = {{3.7, 0, 811}, {3.7, 100, 200}, {64.0, 0, 47}, {2.0, 700, 300}, {3.7, 90, 250}};
  for (int round = 0; round < 60; ++round) {
    const CurveColumns& columns = views[idx(static_cast<int>(random() % 5))];
    expect_present(columns, "before");
    const int first = static_cast<int>(random() % (kFrames - 40));
    ASSERT_TRUE(move(random() % 3 == 0 ? 5u : 0u, {first, static_cast<int>(random() % 40) + 1}, 0.25 * round - 5.0));
    if (random() % 4 == 0) document.undo();
    if (random() % 4 == 0) document.redo();
    expect_present(columns, "after an edit");
  }
}

TEST_F(CurveCacheTest, FollowsWhatWasMissed) {
  const CurveColumns columns{5.0, 0, 600};
  expect_present(columns, "before");
  for (int i = 0; i < 5; ++i) ASSERT_TRUE(move(0, {400 * i, 10}, 3.0));
  expect_present(columns, "after five edits");
  for (int i = 0; i < 40; ++i) ASSERT_TRUE(move(0, {50 * i, 10}, -2.0));
  expect_present(columns, "after forty edits");
}

TEST_F(CurveCacheTest, FollowsFramesThatGoAndComeBack) {
  const CurveColumns columns{5.0, 0, 600};
  expect_present(columns, "before");
  ASSERT_TRUE(document.apply(make_remove_frames_edit({100, 1000})));
  expect_present(columns, "without the frames");
  document.undo();
  expect_present(columns, "with the frames");
}

TEST_F(CurveCacheTest, AnEditOfOneKeyLooksAtItsFramesAlone) {
  const CurveColumns columns{50.0, 0, 60};
  expect_present(columns, "before");
  ASSERT_TRUE(move(3, {1500, 1}, 1e6));
  cache.follow(document, 1);
  const auto changed = document.history().changed_frames_since(document.revision() - 1);
  EXPECT_LE(changed.count, 10);
  const auto extents = cache.columns(document, kCurve, columns);
  EXPECT_TRUE(std::any_of(extents.begin() + 28, extents.begin() + 32, [](const ValueExtent& e) { return e.high > 1e5; }));
}

TEST_F(CurveCacheTest, ColumnsStayWhenPanningChangesTheLastDigitsOfTheirWidth) {
  const auto before = cache.columns(document, kCurve, {5.0, 0, 300});
  const std::vector<ValueExtent> kept(before.begin(), before.end());
  const auto after = cache.columns(document, kCurve, {5.0 * (1.0 + 1e-15), 20, 300});
  EXPECT_TRUE(std::equal(kept.begin() + 20, kept.end(), after.begin()));
}

TEST_F(CurveCacheTest, GhostsAreThoseOfTheLastSave) {
  const CurveColumns columns{5.0, 0, 600};
  for (const double delta : {1.0, 2.0}) {
    ASSERT_TRUE(move(0, {10, 500}, delta));
    cache.follow(document, 1);
    const auto expected = by_hand(document.saved_samples(kCurve), columns);
    EXPECT_TRUE(test::same_elements(cache.saved_columns(document, kCurve, columns), expected)) << delta;
    document.mark_saved();
  }
}

TEST_F(CurveCacheTest, AnotherClipIsAnotherClip) {
  const CurveColumns columns{5.0, 0, 600};
  expect_present(columns, "before");
  Document other = open_document();
  ASSERT_TRUE(other.apply(make_sample_edit(other.clip(), kCurve, 7, 123.0)));
  document = std::move(other);
  cache.follow(document, 2);
  const auto expected = by_hand(document.motion().channel_samples(kCurve), columns);
  EXPECT_TRUE(test::same_elements(cache.columns(document, kCurve, columns), expected));
}

}  // namespace
}  // namespace marey::test
