#include "core/editing/contact_edits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "core/editing/clip_operations.h"
#include "core/editing/history.h"
#include "tests/core/editing/generated_clips.h"

namespace marey::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr NodeIndex kFoot = 1;
constexpr NodeIndex kHand = 0;

class ContactEdits : public testing::Test {
 protected:
  Status say(std::vector<NodeIndex> nodes, FrameRange frames, std::optional<bool> touches) {
    return history.apply(clip, make_contact_edit(clip, nodes, frames, touches));
  }
  /// The frames of `removed` give way to as many new ones as there are file frames.
  Status replace(FrameRange removed, std::vector<FrameIndex> file_frames) {
    Edit edit;
    edit.name = "Replace";
    edit.frames = FramesChange{removed, Motion(clip.motion.channel_count(), size_of(file_frames), 0.01), std::move(file_frames)};
    return history.apply(clip, std::move(edit));
  }
  [[nodiscard]] const std::vector<OwnContact>& contacts() const { return clip.body.contacts; }

  Clip clip = make_clip_with_curve(std::vector<double>(20, 1.0));
  History history;
};

TEST_F(ContactEdits, AreNamedStepsThatAreUndone) {
  ASSERT_TRUE(say({kFoot}, {4, 3}, true));
  EXPECT_EQ(history.undo_name(), "Contact");
  ASSERT_TRUE(say({kFoot}, {5, 1}, false));
  EXPECT_EQ(history.undo_name(), "No contact");
  EXPECT_THAT(contacts(), ElementsAre(OwnContact{kFoot, 4, 4, true}, OwnContact{kFoot, 5, 5, false}, OwnContact{kFoot, 6, 6, true}));
  ASSERT_TRUE(say({kFoot}, {0, 20}, std::nullopt));
  EXPECT_EQ(history.undo_name(), "Contacts as detected");
  EXPECT_THAT(contacts(), IsEmpty());
  while (history.undo(clip)) continue;
  EXPECT_EQ(clip.body, BodyChoice{});
  while (history.redo(clip)) continue;
  EXPECT_THAT(contacts(), IsEmpty());
}

TEST_F(ContactEdits, JoinAndStandInOrder) {
  ASSERT_TRUE(say({kFoot, kHand}, {10, 5}, true));
  ASSERT_TRUE(say({kFoot}, {5, 5}, true));
  ASSERT_TRUE(say({kFoot}, {12, 8}, true));
  EXPECT_THAT(contacts(), ElementsAre(OwnContact{kHand, 10, 14, true}, OwnContact{kFoot, 5, 19, true}));
  ASSERT_TRUE(say({kFoot}, {7, 1}, std::nullopt));
  EXPECT_THAT(contacts(), ElementsAre(OwnContact{kHand, 10, 14, true}, OwnContact{kFoot, 5, 6, true}, OwnContact{kFoot, 8, 19, true}));
}

TEST_F(ContactEdits, OfFramesAndNodesThatThereAreNotAreRefused) {
  EXPECT_FALSE(say({kFoot}, {18, 3}, true));
  EXPECT_FALSE(say({kFoot}, {-1, 3}, true));
  EXPECT_FALSE(say({99}, {1, 3}, true));
  BodyChoice body;
  body.contacts = {{kFoot, 4, 8, true}, {kFoot, 8, 9, true}};
  EXPECT_FALSE(check_edit(clip, make_body_edit(clip, body)));
  body.contacts = {{kFoot, 9, 8, true}};
  EXPECT_FALSE(check_edit(clip, make_body_edit(clip, body)));
}

TEST_F(ContactEdits, MoveUpWithTheirFrames) {
  ASSERT_TRUE(say({kFoot}, {4, 6}, true));
  ASSERT_TRUE(history.apply(clip, make_remove_frames_edit({0, 3})));
  EXPECT_THAT(contacts(), ElementsAre(OwnContact{kFoot, 1, 6, true}));
  ASSERT_TRUE(history.apply(clip, make_remove_frames_edit({5, 4})));
  EXPECT_THAT(contacts(), ElementsAre(OwnContact{kFoot, 1, 4, true}));
  ASSERT_TRUE(history.apply(clip, make_remove_frames_edit({0, 6})));
  EXPECT_THAT(contacts(), IsEmpty());
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(history.undo(clip));
  EXPECT_THAT(contacts(), ElementsAre(OwnContact{kFoot, 4, 9, true}));
}

TEST_F(ContactEdits, FollowFramesThatComeInThePlaceOfAll) {
  ASSERT_TRUE(say({kFoot}, {4, 6}, true));
  std::vector<FrameIndex> twice;  // every frame with a new one behind it
  for (FrameIndex frame = 0; frame < 20; ++frame) twice.insert(twice.end(), {frame, kNewFrame});
  ASSERT_TRUE(replace({0, 20}, twice));
  EXPECT_THAT(contacts(), ElementsAre(OwnContact{kFoot, 8, 18, true}));
  std::vector<FrameIndex> middle(twice.begin() + 10, twice.begin() + 30);
  ASSERT_TRUE(replace({0, 40}, middle));
  EXPECT_THAT(contacts(), ElementsAre(OwnContact{kFoot, 0, 8, true}));
  ASSERT_TRUE(replace({3, 0}, {kNewFrame, kNewFrame}));
  EXPECT_THAT(contacts(), ElementsAre(OwnContact{kFoot, 0, 10, true}));
  ASSERT_TRUE(replace({0, 22}, {kNewFrame, kNewFrame}));
  EXPECT_THAT(contacts(), IsEmpty());
}

TEST_F(ContactEdits, FollowOtherTimesBetweenFramesThatStay) {
  ASSERT_TRUE(say({kFoot}, {4, 6}, true));
  // Every other frame, and of those some only by their times.
  ASSERT_TRUE(replace({0, 20}, {0, kNewFrame, kNewFrame, kNewFrame, kNewFrame, 10, kNewFrame, kNewFrame, kNewFrame, kNewFrame, 19}));
  EXPECT_THAT(contacts(), ElementsAre(OwnContact{kFoot, 2, 4, true}));
}

TEST_F(ContactEdits, StayInATrimOfFramesThatWereMade) {
  ASSERT_TRUE(say({kFoot}, {4, 6}, true));
  EXPECT_THAT(contacts_within(contacts(), {5, 3}), ElementsAre(OwnContact{kFoot, 0, 2, true}));
  EXPECT_THAT(contacts_within(contacts(), {0, 4}), IsEmpty());
  EXPECT_THAT(contacts_within(contacts(), {2, 10}), ElementsAre(OwnContact{kFoot, 2, 7, true}));
}

// Of frames that only go, each that stays keeps what was said of it.
TEST_F(ContactEdits, SayOfEachFrameWhatWasSaidOfIt) {
  std::mt19937 random(5);
  const auto below = [&](int end) { return std::uniform_int_distribution(0, end - 1)(random); };
  for (int round = 0; round < 200; ++round) {
    clip = make_clip_with_curve(std::vector<double>(30, 1.0));
    std::vector<int> said(30, 0);
    for (int i = 0; i < 4; ++i) {
      const FrameRange frames{below(25), 1 + below(5)};
      const bool touches = below(2) == 1;
      ASSERT_TRUE(say({kFoot}, frames, touches));
      std::fill_n(said.begin() + frames.first, frames.count, touches ? 1 : -1);
    }
    const FrameRange cut{below(20), 1 + below(9)};
    ASSERT_TRUE(history.apply(clip, make_remove_frames_edit(cut)));
    said.erase(said.begin() + cut.first, said.begin() + cut.end());
    std::vector<int> found(said.size(), 0);
    for (const OwnContact& contact : contacts()) {
      std::fill(found.begin() + contact.first, found.begin() + contact.last + 1, contact.touches ? 1 : -1);
    }
    ASSERT_EQ(found, said);
    ASSERT_TRUE(check_edit(clip, make_body_edit(clip, clip.body)));
    history = History();
  }
}

}  // namespace
}  // namespace marey::test
