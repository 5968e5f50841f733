// Memory that ends in the middle: at each allocation of an action in turn, the session is then as it was before.
#include <gtest/gtest.h>

#include <functional>
#include <new>
#include <string>
#include <tuple>

#include "core/bvh/reader.h"
#include "core/document/session.h"
#include "core/editing/clip_operations.h"
#include "core/editing/curve_operations.h"
#include "tests/core/bvh/bvh_texts.h"
#include "tests/core/document/failing_allocation.h"

namespace marey::test {
namespace {

constexpr GestureId kGesture = 7;

/// Joint names of a character set other than ASCII, so that reading them anew takes memory.
std::string clip_text() {
  std::string text = one_joint_file("6", "1 2 3\n4 5 6\n7 8 9\n10 11 12\n13 14 15\n16 17 18\n");
  return text.insert(text.find("ROOT ") + 5, "longer_than_any_small_buffer_\xd0\xaf_");
}

SampleSelection first_samples() {
  SampleSelection samples;
  samples.add(0, {1, 3});
  return samples;
}

Edit moved(const Clip& clip, double delta) { return make_move_edit(clip, first_samples(), delta, {}); }

/// With two steps to undo and one to redo.
Session edited_session() {
  Session session = Session::open(read_or_fail(clip_text()), "walk.bvh");
  EXPECT_TRUE(session.apply(moved(session.document.clip(), 1.0)));
  EXPECT_TRUE(session.apply(make_remove_frames_edit({2, 2})));
  EXPECT_TRUE(session.apply(moved(session.document.clip(), 2.0)));
  session.undo();
  return session;
}

/// Two steps to undo, the newest of which is the state of a gesture.
Session dragged_session() {
  Session session = Session::open(read_or_fail(clip_text()), "walk.bvh");
  EXPECT_TRUE(session.apply(moved(session.document.clip(), 1.0)));
  EXPECT_TRUE(session.apply_gesture(kGesture, [](const Clip& clip) { return moved(clip, 2.0); }));
  return session;
}

auto seen_of(const Session& session) {
  const Document& document = session.document;
  const History& history = document.history();
  const Changes changes = document.find_changes();
  return std::tuple(document.save_text(), document.skeleton().name(0), document.settings().metres_per_unit, history.undo_depth(),
                    history.redo_depth(), history.undo_name(), history.redo_name(), history.bytes(), document.is_dirty(),
                    changes.samples, changes.removed_frames, document.saved_samples(0).size());
}

std::string undone_to_the_start(Session& session) {
  while (session.undo()) continue;
  return session.document.save_text();
}

struct Action {
  std::string name;
  std::function<Session()> open;
  std::function<void(Session&)> act;
};

Status set_names(Session& session, CharacterSet set) {
  Edit edit;
  edit.name = "Read the names otherwise, which is a long name for a step";
  edit.settings = session.document.settings();
  edit.settings->names_in = set;
  return session.apply(std::move(edit));
}

std::vector<Action> actions() {
  return {
      {"edit", edited_session, [](Session& s) { EXPECT_TRUE(s.apply(moved(s.document.clip(), 5.0))); }},
      {"first_state_of_a_gesture", edited_session,
       [](Session& s) { EXPECT_TRUE(s.apply_gesture(kGesture, [](const Clip& clip) { return moved(clip, 5.0); })); }},
      {"next_state_of_a_gesture", dragged_session,
       [](Session& s) { EXPECT_TRUE(s.apply_gesture(kGesture, [](const Clip& clip) { return moved(clip, 5.0); })); }},
      {"last_state_of_a_gesture", dragged_session,
       [](Session& s) { EXPECT_TRUE(s.apply_gesture(kGesture, [](const Clip& clip) { return moved(clip, 0.0); })); }},
      {"removal_of_frames", edited_session, [](Session& s) { EXPECT_TRUE(s.apply(make_remove_frames_edit({0, 2}))); }},
      {"another_character_set", edited_session, [](Session& s) { EXPECT_TRUE(set_names(s, CharacterSet::Windows1251)); }},
      {"undo_of_a_removal", edited_session, [](Session& s) { EXPECT_TRUE(s.undo()); }},
      {"redo", edited_session, [](Session& s) { EXPECT_TRUE(s.redo()); }},
      {"redo_of_a_removal",
       [] {
         Session session = edited_session();
         session.undo();
         return session;
       },
       [](Session& s) { EXPECT_TRUE(s.redo()); }},
      {"cancelled_gesture", dragged_session, [](Session& s) { s.cancel_gesture(kGesture); }},
      {"saving", edited_session, [](Session& s) { EXPECT_FALSE(s.document.save_text().empty()); }},
  };
}

/// Whether the action came to its end with so many allocations.
bool act_with(int allocations, const Action& action, Session& session) {
  const FailingAllocation limit(allocations);
  try {
    action.act(session);
  } catch (const std::bad_alloc&) {
    return false;
  }
  return true;
}

class OutOfMemory : public testing::TestWithParam<Action> {};

TEST_P(OutOfMemory, LeavesTheSessionAsItWas) {
  int failures = 0;
  for (bool done = false; !done; failures += done ? 0 : 1) {
    ASSERT_LT(failures, 10'000);
    Session session = GetParam().open();
    const auto before = seen_of(session);
    done = act_with(failures, GetParam(), session);
    if (!done) {
      EXPECT_EQ(seen_of(session), before) << "allocation " << failures;
    }
    EXPECT_EQ(undone_to_the_start(session), clip_text()) << "allocation " << failures;
  }
  RecordProperty("failed_allocations", failures);
}

INSTANTIATE_TEST_SUITE_P(Actions, OutOfMemory, testing::ValuesIn(actions()), [](const auto& action) { return action.param.name; });

TEST(OutOfMemoryInReading, LeavesNothingBehindAtAnyAllocation) {
  const std::string text = clip_text();
  int failures = 0;
  for (bool done = false; !done; failures += done ? 0 : 1) {
    ASSERT_LT(failures, 10'000);
    const FailingAllocation limit(failures);
    try {
      Result<BvhClip> clip = read_bvh(text);
      if (clip) (void)Session::open(std::move(clip.value()), "a file name that is longer than any small buffer.bvh");
      done = true;
    } catch (const std::bad_alloc&) {
      continue;
    }
  }
  EXPECT_GT(failures, 20);
}

}  // namespace
}  // namespace marey::test
