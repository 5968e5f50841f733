#include <gtest/gtest.h>

#include <numbers>

#include "core/skeleton/skeleton_builder.h"
#include "wasm/views/viewport/gizmo.h"
#include "wasm/views/viewport/joint_labels.h"
#include "wasm/views/viewport/overlay.h"
#include "wasm/views/viewport/strobe.h"
#include "wasm/views/viewport/trails.h"

namespace marey::app {
namespace {

TEST(ScaleBar, IsARoundLengthInUnitsAndMetres) {
  const ScaleBar bar = make_scale_bar(0.1, 120.0f, 0.055);
  EXPECT_EQ(bar.label, "10 units = 0.55 m");
  EXPECT_FLOAT_EQ(bar.width, 100.0f);
  EXPECT_EQ(make_scale_bar(0.009, 120.0f, 1.0).label, "1 unit = 1 m");
  EXPECT_EQ(make_scale_bar(0.5, 120.0f, 0.0005).label, "50 units = 2.5 cm");
  EXPECT_EQ(make_scale_bar(0.0005, 120.0f, 0.01).label, "0.05 units = 0.5 mm");
  for (double scale = 1e-6; scale < 1e6; scale *= 1.7) {
    const ScaleBar any = make_scale_bar(scale, 120.0f, 0.01);
    EXPECT_GT(any.width, 45.0f) << scale;
    EXPECT_LE(any.width, 120.01f) << scale;
  }
}

TEST(StrobeFrames, AreEveryNthOfTheRange) {
  EXPECT_EQ(find_strobe_frames({0, 23}, 4, 10, 60), (StrobeFrames{0, 4, 6}));
  EXPECT_EQ(find_strobe_frames({5, 1}, 4, 5, 60), (StrobeFrames{5, 4, 1}));
  EXPECT_EQ(find_strobe_frames({0, 0}, 4, 0, 60).count, 0);
}

TEST(StrobeFrames, UsuallyShowADozenPosesOrTwoEverySecond) {
  EXPECT_EQ(usual_strobe_distance(23, 1.0 / 30.0), 2);
  EXPECT_EQ(usual_strobe_distance(524, 1.0 / 120.0), 50);
  EXPECT_EQ(usual_strobe_distance(100'000, 1.0 / 120.0), 100);
  EXPECT_EQ(usual_strobe_distance(0, 0.0), 1);
}

TEST(StrobeFrames, OfALongClipAreThoseAroundThePresentFrame) {
  for (const int frame : {0, 123, 5000, 9999}) {
    const StrobeFrames frames = find_strobe_frames({0, 10000}, 10, frame, 60);
    EXPECT_EQ(frames.count, 60);
    EXPECT_EQ(frames.first % 10, 0);
    EXPECT_LE(frames.first, frame);
    EXPECT_GE(frames.first + 10 * (frames.count - 1), frame - 10);
    EXPECT_LT(frames.first + 10 * (frames.count - 1), 10000);
  }
}

TEST(TrailFrames, AreTheRangeOrAWindowOfIt) {
  EXPECT_EQ(find_trail_frames({3, 20}, 1.0 / 30.0, 10), (FrameRange{3, 20}));
  for (const int frame : {0, 5000, 9999}) {
    const FrameRange frames = find_trail_frames({0, 10000}, 1.0 / 120.0, frame);
    EXPECT_TRUE(frames.contains(frame));
    EXPECT_GE(frames.first, 0);
    EXPECT_LE(frames.end(), 10000);
    EXPECT_LE(frames.count, 721);
    EXPECT_GE(frames.count, 360);
  }
}

Skeleton make_hand_figure() {
  SkeletonBuilder builder;
  builder.open_joint("Hips");
  builder.open_joint("Head", {0, 70, 0});
  builder.add_end_site({0, 20, 0});
  builder.close_joint();
  builder.open_joint("LeftHand", {60, 50, 0});
  for (int finger = 0; finger < 5; ++finger) {
    builder.open_joint("Finger", {8, 2.0 * finger, 0});
    builder.add_end_site({4, 0, 0});
    builder.close_joint();
  }
  builder.close_joint();
  builder.open_joint("LeftFoot", {10, -80, 0});
  builder.add_end_site({0, -5, 15});
  builder.close_joint();
  builder.close_joint();
  return std::move(builder.build().value());
}

TEST(TrailNodes, AreOneEndOfEachLimbWhenNothingIsSelected) {
  const Skeleton skeleton = make_hand_figure();
  const std::vector<NodeIndex> nodes = find_trail_nodes(skeleton, Selection(skeleton));
  ASSERT_EQ(nodes.size(), 3u) << "head, one finger, foot";
  for (const NodeIndex node : nodes) EXPECT_TRUE(skeleton.node(node).is_end_site);
}

TEST(TrailNodes, AreTheSelectedJoints) {
  const Skeleton skeleton = make_hand_figure();
  Selection selection(skeleton);
  selection.select_only(2);
  selection.toggle(0);
  EXPECT_EQ(find_trail_nodes(skeleton, selection), (std::vector<NodeIndex>{skeleton.node_of(0), skeleton.node_of(2)}));
}

TEST(JointLabels, NeverOverlapAndStayInside) {
  std::vector<LabelWish> wishes;
  for (int i = 0; i < 200; ++i) {
    wishes.push_back({{static_cast<float>(i * 37 % 400), static_cast<float>(i * 53 % 300)}, {20.0f + static_cast<float>(i % 50), 14.0f}, i % 2 == 0});
  }
  std::vector<LabelPlace> places;
  place_labels(wishes, {0, 0}, {400, 300}, 9.0f, places);
  EXPECT_GT(places.size(), 40u);
  for (const LabelPlace& a : places) {
    const ImVec2 a_size = wishes[idx(a.wish)].size;
    EXPECT_GE(a.min.x, -0.5f);
    EXPECT_LE(a.min.x + a_size.x, 400.5f);
    for (const LabelPlace& b : places) {
      if (a.wish >= b.wish) continue;
      const ImVec2 b_size = wishes[idx(b.wish)].size;
      const bool apart = a.min.x + a_size.x <= b.min.x + 1.0f || b.min.x + b_size.x <= a.min.x + 1.0f ||
                         a.min.y + a_size.y <= b.min.y + 1.0f || b.min.y + b_size.y <= a.min.y + 1.0f;
      EXPECT_TRUE(apart) << a.wish << " and " << b.wish;
    }
  }
}

TEST(JointLabels, FirstComeFirstServed) {
  const std::vector<LabelWish> wishes(6, {{200, 150}, {60, 14}, false});
  std::vector<LabelPlace> places;
  place_labels(wishes, {0, 0}, {400, 300}, 9.0f, places);
  ASSERT_EQ(places.size(), 4u) << "right, left, above, below";
  EXPECT_EQ(places[0].wish, 0);
  EXPECT_GT(places[0].min.x, 200.0f);
}

TEST(AxisViews, FrontLooksFromTheFrontForEitherUpAxis) {
  EXPECT_STREQ(axis_view_from(Axis::Z, false, Axis::Y).name, "Front");
  EXPECT_STREQ(axis_view_from(Axis::Y, false, Axis::Y).name, "Top");
  EXPECT_STREQ(axis_view_from(Axis::Y, true, Axis::Z).name, "Front");
  EXPECT_STREQ(axis_view_from(Axis::Z, false, Axis::Z).name, "Top");
  EXPECT_STREQ(axis_view_from(Axis::X, false, Axis::Y).name, "Side");
}

TEST(AxisViews, TheEyeIsOnTheAxisThatNamesTheView) {
  for (const Axis up : {Axis::Y, Axis::Z}) {
    for (int i = 0; i < 6; ++i) {
      const auto axis = static_cast<Axis>(i / 2);
      const AxisView& from = axis_view_from(axis, i % 2 == 1, up);
      const CameraView view({{}, 1.0, from.yaw_rad, from.pitch_rad, 1.0}, up, {100, 100}, {});
      EXPECT_NEAR(view.axes().back[i / 2], i % 2 == 1 ? -1.0 : 1.0, 1e-12);
    }
  }
}

TEST(AxisViews, NamesTheView) {
  EXPECT_EQ(view_name({{}, 1.0, 0.0, 0.0, 0.0}), "Front, orthographic");
  EXPECT_EQ(view_name({{}, 1.0, 0.5, 0.1, 1.0}), "Perspective");
  EXPECT_EQ(find_axis_view({{}, 1.0, 2.0 * std::numbers::pi, 0.0, 1.0}), &kAxisViews[0]);
}

}  // namespace
}  // namespace marey::app
