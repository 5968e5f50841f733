#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

#include "core/document/document.h"
#include "tests/core/editing/generated_clips.h"

namespace marey::test {
namespace {

using Bits = std::vector<std::uint64_t>;

/// What a history should be: all states there were, complete.
struct Timeline {
  std::vector<Bits> states;
  std::vector<int> ids;  // tell equal states apart
  std::size_t present = 0;

  void push(Bits state, int id) {
    states.resize(present + 1);
    ids.resize(present + 1);
    states.push_back(std::move(state));
    ids.push_back(id);
    ++present;
  }
};

/// Drives a document and the timeline side by side and compares them after each step.
class EditRun {
 public:
  explicit EditRun(std::uint64_t seed) : random_(seed), document_(make_document(random_)) {
    timeline_.states = {bits_of(document_.clip())};
    timeline_.ids = {next_id_++};
    saved_id_ = timeline_.ids[0];
    saved_motion_ = document_.motion();
  }

  void step() {
    const std::uint64_t revision = document_.revision();
    const Bits before = bits_of(document_.clip());
    switch (random_.below(12)) {
      case 0:
      case 1:
      case 2:
        move(document_.undo(), -1);
        break;
      case 3:
      case 4:
        move(document_.redo(), +1);
        break;
      case 5:
        save();
        break;
      case 6:
      case 7:
        drag();
        break;
      default:
        apply();
        break;
    }
    ASSERT_EQ(document_.revision() == revision, steps_with_change_ == 0);
    ASSERT_EQ(document_.revision() - revision, steps_with_change_);
    steps_with_change_ = 0;
    expect_agreement();
    expect_ghosts();
  }

  void undo_all() {
    while (document_.undo()) --timeline_.present;
    expect_agreement();
    ASSERT_EQ(timeline_.present, 0u);
  }

  void redo_all() {
    while (document_.redo()) ++timeline_.present;
    expect_agreement();
    ASSERT_EQ(timeline_.present + 1, timeline_.states.size());
  }

 private:
  static Document make_document(Random& random) {
    Clip clip = make_random_clip(random);
    BvhClip read;
    read.skeleton = std::move(clip.skeleton);
    read.motion = std::move(clip.motion);
    return Document(std::move(read), "generated.bvh");
  }

  void move(bool moved, int direction) {
    const bool possible = direction < 0 ? timeline_.present > 0 : timeline_.present + 1 < timeline_.states.size();
    ASSERT_EQ(moved, possible);
    if (!moved) return;
    timeline_.present = direction < 0 ? timeline_.present - 1 : timeline_.present + 1;
    ++steps_with_change_;
  }

  void save() {
    document_.mark_saved();
    saved_id_ = timeline_.ids[timeline_.present];
    saved_motion_ = document_.motion();
  }

  // Bits after an edit of the present state, nothing if it is refused.
  std::optional<Bits> bits_after(const Edit& edit) const {
    if (!check_edit(document_.clip(), edit)) return std::nullopt;
    return bits_of(edited(document_.clip(), edit));
  }

  void apply() {
    const Edit edit = make_random_edit(random_, document_.clip());
    const std::optional<Bits> after = bits_after(edit);
    ASSERT_EQ(document_.apply(edit).ok(), after.has_value());
    if (!after || *after == timeline_.states[timeline_.present]) return;
    timeline_.push(*after, next_id_++);
    ++steps_with_change_;
  }

  void drag() {
    const GestureId gesture = ++last_gesture_;
    const Timeline before = timeline_;
    for (int i = random_.below(5); i >= 0; --i) {
      drag_on(gesture, before);
      if (random_.one_in(8)) save();
    }
    if (!random_.one_in(3)) return;
    if (timeline_.present != before.present) ++steps_with_change_;
    document_.cancel_gesture(gesture);
    timeline_ = before;
  }

  void drag_on(GestureId gesture, const Timeline& before) {
    std::optional<Bits> after;
    const Status status = document_.apply_gesture(gesture, [&](const Clip& clip) {
      EXPECT_EQ(bits_of(clip), before.states[before.present]);
      const Edit edit = random_.one_in(4) ? Edit{} : make_random_edit(random_, clip);
      after = bits_after(edit);
      return edit;
    });
    ASSERT_EQ(status.ok(), after.has_value());
    if (!after) return;
    const bool had_step = timeline_.present != before.present;
    timeline_ = before;
    const bool has_step = *after != before.states[before.present];
    if (has_step) timeline_.push(*after, next_id_++);
    if (has_step || had_step) ++steps_with_change_;
  }

  void expect_agreement() const {
    ASSERT_EQ(bits_of(document_.clip()), timeline_.states[timeline_.present]);
    const History& history = document_.history();
    ASSERT_EQ(idx(history.undo_depth()), timeline_.present);
    ASSERT_EQ(idx(history.redo_depth()), timeline_.states.size() - timeline_.present - 1);
    ASSERT_EQ(document_.is_dirty(), timeline_.ids[timeline_.present] != saved_id_);
    ASSERT_TRUE(document_.is_dirty() || document_.find_changes().empty()) << describe(document_.find_changes());
  }

  void expect_ghosts() const {
    if (document_.find_changes().figure) {
      for (ChannelIndex c = 0; c < saved_motion_.channel_count(); ++c) ASSERT_TRUE(document_.saved_samples(c).empty());
      return;
    }
    ASSERT_EQ(document_.motion().channel_count(), saved_motion_.channel_count());
    if (document_.motion().frame_count() != saved_motion_.frame_count()) {
      const Changes changes = document_.find_changes();
      ASSERT_EQ(changes.added_frames - changes.removed_frames,
                document_.motion().frame_count() - saved_motion_.frame_count());
      for (ChannelIndex c = 0; c < saved_motion_.channel_count(); ++c) ASSERT_TRUE(document_.saved_samples(c).empty());
      return;
    }
    if (document_.find_changes().removed_frames > 0) return;
    for (ChannelIndex channel = 0; channel < saved_motion_.channel_count(); ++channel) {
      const std::span<const double> ghost = document_.saved_samples(channel);
      const std::span<const double> shown = ghost.empty() ? document_.motion().channel_samples(channel) : ghost;
      const std::span<const double> expected = saved_motion_.channel_samples(channel);
      ASSERT_EQ(shown.size(), expected.size());
      if (shown.empty()) continue;
      ASSERT_EQ(std::memcmp(shown.data(), expected.data(), shown.size_bytes()), 0);
    }
  }

  Random random_;
  Document document_;
  Timeline timeline_;
  Motion saved_motion_;
  GestureId last_gesture_ = 0;
  int next_id_ = 0;
  int saved_id_ = 0;
  std::uint64_t steps_with_change_ = 0;
};

TEST(EditSequences, HistoryIsATimelineOfCompleteStates) {
  constexpr std::uint64_t kDocuments = 1000;
  constexpr int kSteps = 50;
  for (std::uint64_t seed = 0; seed < kDocuments; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    EditRun run(seed);
    for (int step = 0; step < kSteps; ++step) {
      run.step();
      if (HasFatalFailure()) return;
    }
    run.undo_all();
    run.redo_all();
    if (HasFailure()) return;
  }
}

TEST(EditSequences, WithLittleMemoryTheNewestStatesAreLeft) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    Clip clip = make_random_clip(random);
    const std::size_t max_bytes = idx(random.below(4000));
    History history(max_bytes);
    std::vector<Bits> states = {bits_of(clip)};
    for (int step = 0; step < 60; ++step) {
      const std::uint64_t revision = history.revision();
      const Status status = history.apply(clip, make_random_edit(random, clip));
      if (status && history.revision() != revision) states.push_back(bits_of(clip));
      ASSERT_TRUE(history.bytes() <= max_bytes || history.undo_depth() <= 1);
    }
    while (history.undo(clip)) {
      states.pop_back();
      ASSERT_EQ(bits_of(clip), states.back());
    }
  }
}

}  // namespace
}  // namespace marey::test
