#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/biomechanics/support.h"
#include "tests/core/biomechanics/body_fixtures.h"

namespace marey::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A hip of 40 kg on two legs without mass, which stands still on y = 0. Nodes: Hips, Left, its end, Right, its end.
Clip make_standing() {
  const Skeleton skeleton =
      figures::make_skeleton({{"Hips", kNoParent, glm::dvec3(0.0), figures::channels("xyzZXY"), {}},
                              {"Left", 0, glm::dvec3(0.2, 0, 0), figures::channels("ZXY"), {glm::dvec3(0, -1, 0)}},
                              {"Right", 0, glm::dvec3(-0.2, 0, 0), figures::channels("ZXY"), {glm::dvec3(0, -1, 0)}}});
  return make_moving(skeleton, 20, 30.0, [](FrameIndex, ChannelIndex channel) { return channel == 1 ? 1.0 : 0.0; });
}

Contacts detected(const Clip& clip) {
  const Result<BodyMotion> body = find_body_motion(clip, {}, clip.motion.frame_time_s(), 1.0);
  return find_contacts(*body, clip.skeleton, Axis::Y);
}

AnalysisRequest standing_request() {
  AnalysisRequest request;
  request.quantities = {"force:Left", "force:Right", "reaction", "cop"};
  request.model.emplace().segments = {{0, 40.0, {0.05, 0.3, 0.02}, symmetric_tensor(std::array{1.0, 1.0, 1.0, 0.0, 0.0, 0.0})}};
  request.support = SupportKind::Ground;
  return request;
}

TEST(OwnContacts, TakeThePlaceOfWhatWasFoundAndOfNothingElse) {
  const Clip clip = make_standing();
  const Contacts found = detected(clip);
  ASSERT_EQ(found.points.size(), 2u);
  const NodeIndex left = found.points[0].node;
  const NodeIndex right = found.points[1].node;
  const OwnContact own[] = {{left, 5, 10, false}, {right, 8, 8, false}, {right, 0, 12, false}, {right, 3, 9, true}};
  const Contacts corrected = apply_own_contacts(found, own);
  for (FrameIndex frame = 0; frame < 20; ++frame) {
    EXPECT_EQ(corrected.is_down(frame, 0), frame < 5 || frame > 10) << frame;
    EXPECT_EQ(corrected.is_down(frame, 1), frame > 12 || (frame >= 3 && frame <= 9)) << frame;
  }
  EXPECT_EQ(corrected.floor_m, found.floor_m);
}

TEST(OwnContacts, OfWhatThereIsNotArePassedOver) {
  const Contacts found = detected(make_standing());
  const OwnContact own[] = {{99, 0, 19, false}, {-1, 0, 19, false}, {0, 0, 19, false}, {found.points[0].node, -5, -1, false},
                            {found.points[0].node, 20, 90, false}};
  EXPECT_EQ(apply_own_contacts(found, own).down, found.down);
  EXPECT_THAT(apply_own_contacts({}, own).down, IsEmpty());
}

// The weight is 40 kg times 9.81 m/s2; a leg without mass passes on what its foot is given.
TEST(OwnContacts, ShareTheReaction) {
  const Clip clip = make_standing();
  AnalysisRequest request = standing_request();
  const AnalysisTable both = table_of(clip, request);
  EXPECT_LT(column_of(both, "force:Left.y[N]")[10], -100.0);
  EXPECT_LT(column_of(both, "force:Right.y[N]")[10], -100.0);
  request.contacts = {{both.contacts()->points[0].node, 8, 12, false}};
  const AnalysisTable one = table_of(clip, request);
  EXPECT_NEAR(column_of(one, "force:Left.y[N]")[10], 0.0, 1e-9);
  EXPECT_NEAR(column_of(one, "force:Right.y[N]")[10], -392.4, 1e-9);
  EXPECT_NEAR(column_of(one, "reaction.y[N]")[10], 392.4, 1e-9);
  EXPECT_DOUBLE_EQ(column_of(one, "force:Left.y[N]")[15], column_of(both, "force:Left.y[N]")[15]);
  EXPECT_FALSE(one.contacts()->is_down(10, 0));
  EXPECT_TRUE(one.contacts()->is_down(13, 0));
}

TEST(OwnContacts, TurnGroundIntoFlightAndBack) {
  Clip clip = make_standing();
  for (FrameIndex frame = 0; frame < 20; ++frame) clip.motion.channel_samples(0)[idx(frame)] = 0.001 * frame;
  AnalysisRequest request = standing_request();
  request.support = SupportKind::Auto;
  const AnalysisTable on = table_of(clip, request);
  EXPECT_NEAR(column_of(on, "reaction.y[N]")[10], 392.4, 1e-6);
  for (const ContactPoint& point : on.contacts()->points) request.contacts.push_back({point.node, 0, 19, false});
  const AnalysisTable off = table_of(clip, request);
  EXPECT_EQ(column_of(off, "reaction.y[N]")[10], 0.0);
  request.support = SupportKind::Pivot;
  EXPECT_EQ(table_of(clip, request).contacts(), nullptr);
}

TEST(OwnContacts, AreMadeByNames) {
  const Skeleton skeleton = make_standing().skeleton;
  EXPECT_THAT(find_contact_nodes(skeleton, kNoParent), ElementsAre(2, 4));
  EXPECT_THAT(find_contact_nodes(skeleton, 0), ElementsAre(2, 4));
  EXPECT_THAT(find_contact_nodes(skeleton, 3), ElementsAre(4));
  EXPECT_THAT(find_contact_nodes(skeleton, 4), ElementsAre(4));
  EXPECT_THAT(find_contact_nodes(skeleton, 77), IsEmpty());
  const auto make = [&](std::string_view label, FrameIndex first, FrameIndex last) {
    return make_own_contacts(skeleton, label, first, last, false);
  };
  EXPECT_THAT(*make("Right", 2, 5), ElementsAre(OwnContact{4, 2, 5, false}));
  EXPECT_THAT(*make("Left_end", 2, 2), ElementsAre(OwnContact{2, 2, 2, false}));
  EXPECT_THAT(*make("Hips", 0, 1), ElementsAre(OwnContact{2, 0, 1, false}, OwnContact{4, 0, 1, false}));
  EXPECT_FALSE(make("Tail", 2, 5));
  EXPECT_FALSE(make("Left", 5, 2));
  EXPECT_FALSE(make("Left", -1, 2));
}

}  // namespace
}  // namespace marey::test
