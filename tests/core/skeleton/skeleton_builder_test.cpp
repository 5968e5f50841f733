#include "core/skeleton/skeleton_builder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace marey {
namespace {

// Why a skeleton was refused; empty if it was not.
std::string refusal(SkeletonBuilder& builder) {
  const Result<Skeleton> result = builder.build();
  if (result) return {};
  EXPECT_EQ(result.error().code, DiagnosticCode::InvalidSkeleton);
  EXPECT_FALSE(result.error().message.empty());
  return result.error().message;
}

TEST(SkeletonBuilder, BuildsWhatTheBracesSay) {
  SkeletonBuilder builder;
  EXPECT_EQ(builder.open_joint("root"), 0);
  EXPECT_EQ(builder.open_joint("child", {1.0, 2.0, 3.0}), 1);
  EXPECT_EQ(builder.open_depth(), 2);
  EXPECT_EQ(builder.current_joint(), 1);
  builder.close_joint();
  EXPECT_EQ(builder.open_joint("sibling"), 2);
  builder.close_joint();
  builder.close_joint();
  EXPECT_EQ(builder.current_joint(), kNoParent);
  const Skeleton skeleton = builder.build().value();
  EXPECT_EQ(skeleton.parent(1), 0);
  EXPECT_EQ(skeleton.parent(2), 0);
  EXPECT_EQ(skeleton.offset(1), glm::dvec3(1.0, 2.0, 3.0));
  EXPECT_EQ(skeleton.subtree_end(0), 3);
}

TEST(SkeletonBuilder, LetsNamesRepeat) {
  SkeletonBuilder builder;
  for (int i = 0; i < 3; ++i) builder.open_joint("same");
  for (int i = 0; i < 3; ++i) builder.close_joint();
  EXPECT_EQ(builder.build().value().joint_count(), 3);
}

TEST(SkeletonBuilder, LearnsOffsetsLater) {
  SkeletonBuilder builder;
  builder.open_joint("root");
  const NodeIndex end_site = builder.add_end_site({0.0, 0.0, 0.0});
  builder.set_offset(0, {1.0, 0.0, 0.0});
  builder.set_offset(end_site, {0.0, 2.0, 0.0});
  builder.close_joint();
  const Skeleton skeleton = builder.build().value();
  EXPECT_EQ(skeleton.node(0).offset, glm::dvec3(1.0, 0.0, 0.0));
  EXPECT_EQ(skeleton.node(1).offset, glm::dvec3(0.0, 2.0, 0.0));
}

TEST(SkeletonBuilder, IsEmptyAfterBuilding) {
  SkeletonBuilder builder;
  builder.open_joint("root");
  builder.close_joint();
  EXPECT_TRUE(builder.build().has_value());
  EXPECT_FALSE(refusal(builder).empty());
  builder.open_joint("again");
  builder.close_joint();
  EXPECT_EQ(builder.build().value().name(0), "again");
}

TEST(SkeletonBuilder, RefusesWhatIsNoTree) {
  SkeletonBuilder builder;
  EXPECT_FALSE(refusal(builder).empty()) << "no joint";

  builder.open_joint("open");
  EXPECT_FALSE(refusal(builder).empty()) << "never closed";

  builder.open_joint("root");
  builder.close_joint();
  builder.close_joint();
  EXPECT_FALSE(refusal(builder).empty()) << "closed twice";

  builder.add_end_site({0.0, 0.0, 0.0});
  EXPECT_FALSE(refusal(builder).empty()) << "end site outside";

  builder.add_channel(ChannelKind::Xrotation);
  EXPECT_FALSE(refusal(builder).empty()) << "channel outside";
}

TEST(SkeletonBuilder, RefusesChannelsBehindAChild) {
  SkeletonBuilder builder;
  builder.open_joint("root");
  builder.open_joint("child");
  builder.close_joint();
  builder.add_channel(ChannelKind::Xrotation);
  builder.close_joint();
  EXPECT_FALSE(refusal(builder).empty());
}

TEST(SkeletonBuilder, RefusesOffsetsThatAreNotFinite) {
  for (double bad : {HUGE_VAL, -HUGE_VAL, std::nan("")}) {
    SkeletonBuilder builder;
    builder.open_joint("root");
    builder.add_end_site({0.0, bad, 0.0});
    builder.close_joint();
    EXPECT_FALSE(refusal(builder).empty()) << bad;
  }
}

}  // namespace
}  // namespace marey
