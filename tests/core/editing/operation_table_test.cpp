// What holds for every operation of the table, whatever it does.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <memory>
#include <set>
#include <string>

#include "core/editing/history.h"
#include "core/editing/layer_edits.h"
#include "core/editing/recipe.h"
#include "core/motion/key_curve_edits.h"
#include "tests/core/editing/operation_clips.h"

namespace marey::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::int64_t count_missing(const Clip& clip) {
  const auto samples = clip.motion.samples();
  return std::count_if(samples.begin(), samples.end(), [](double v) { return !std::isfinite(v); });
}

// Applies, undoes and redoes; a clip gets no more samples that are not finite.
void try_operation(Clip clip, const Operation& operation, const OperationTarget& target, const OperationValues& values) {
  SCOPED_TRACE(operation.id);
  const auto before = bits_of(clip);
  const std::int64_t missing = count_missing(clip);
  const auto outcome = make_operation_edit(clip, operation, target, values);
  ASSERT_EQ(bits_of(clip), before);
  if (!outcome) {
    EXPECT_FALSE(outcome.error().message.empty());
    return;
  }
  History history;
  const Status status = history.apply(clip, outcome->edit);
  ASSERT_TRUE(status.ok()) << status.error().message;
  EXPECT_LE(count_missing(clip), missing);
  const auto changed = bits_of(clip);
  EXPECT_EQ(history.undo_depth() == 0, changed == before) << "an edit that changes nothing";
  while (history.undo(clip)) {}
  ASSERT_EQ(bits_of(clip), before);
  while (history.redo(clip)) {}
  ASSERT_EQ(bits_of(clip), changed);
}

TEST(OperationTable, IsComplete) {
  std::set<std::string_view> ids;
  std::set<std::string_view> groups;
  std::string_view group;
  for (const Operation& operation : operations()) {
    SCOPED_TRACE(operation.id);
    EXPECT_TRUE(ids.insert(operation.id).second);
    EXPECT_EQ(find_operation(operation.id), &operation);
    EXPECT_FALSE(operation.label.empty());
    EXPECT_FALSE(operation.group.empty());
    EXPECT_TRUE(operation.group == group || groups.insert(operation.group).second) << "a group stands in two places";
    group = operation.group;
    EXPECT_TRUE(operation.help.ends_with('.'));
    const OperationValues values = initial_values(operation);
    for (std::size_t i = 0; i < operation.parameters.size(); ++i) {
      const OperationParameter& parameter = operation.parameters[i];
      SCOPED_TRACE(parameter.name);
      EXPECT_FALSE(parameter.label.empty());
      EXPECT_TRUE(parameter.help.ends_with('.'));
      EXPECT_EQ(find_parameter(operation, parameter.name), static_cast<int>(i));
      const auto words = target_words();
      EXPECT_EQ(std::find(words.begin(), words.end(), parameter.name), words.end());
      if (is_text(parameter.kind)) continue;
      EXPECT_TRUE(check_value(parameter, values.numbers[i]).ok());
      EXPECT_FALSE(check_value(parameter, kNan).ok());
      const bool is_choice = parameter.kind == ParameterKind::Choice;
      EXPECT_TRUE(!is_choice || parameter.most == static_cast<double>(parameter.choices.size()) - 1.0);
    }
  }
  EXPECT_GE(ids.size(), 30u);
  EXPECT_EQ(find_operation("juggle"), nullptr);
}

TEST(OperationTable, WorksOnClipsOfAnySize) {
  const Clip other = make_figure(12);
  for (const int frame_count : {0, 1, 2, 3, 40}) {
    for (const Clip& clip : {make_figure(frame_count), make_clip(1, frame_count)}) {
      for (const Operation& operation : operations()) {
        try_operation(clip, operation, whole_clip(clip), values_of(operation, {}, &other));
        if (HasFatalFailure()) return;
      }
    }
  }
}

TEST(OperationTable, TakesTheEndsOfItsRanges) {
  const Clip clip = make_figure(20);
  const Clip other = make_figure(12);
  for (const Operation& operation : operations()) {
    for (std::size_t i = 0; i < operation.parameters.size(); ++i) {
      for (const double end : {operation.parameters[i].least, operation.parameters[i].most}) {
        OperationValues values = values_of(operation, {}, &other);
        values.numbers[i] = end;
        try_operation(clip, operation, whole_clip(clip), values);
        if (HasFatalFailure()) return;
      }
    }
  }
}

TEST(OperationTable, SurvivesMissingSamples) {
  Random random(11);
  const Clip other = make_figure(12);
  for (int round = 0; round < 20; ++round) {
    Clip clip = make_figure(30);
    for (ChannelIndex channel = 0; channel < clip.motion.channel_count(); ++channel) {
      for (double& sample : clip.motion.channel_samples(channel)) {
        if (random.one_in(round < 18 ? 20 : 1)) sample = random.one_in(3) ? std::numeric_limits<double>::infinity() : kNan;
      }
    }
    for (const Operation& operation : operations()) {
      try_operation(clip, operation, make_random_target(random, clip), make_random_values(random, operation, &other));
      if (HasFatalFailure()) return;
    }
  }
}

// Two layers with keys on some channels; the upper one is locked.
Clip with_locked_layer(Clip clip, Random& random) {
  LayerStack stack;
  for (const char* name : {"Free", "Kept"}) {
    Layer layer;
    layer.name = name;
    layer.locked = stack.layers.size() == 1;
    if (random.one_in(3)) layer.mode = LayerMode::Override;
    for (int i = 0; i < 3; ++i) {
      KeyCurve curve;
      set_key(curve, random.below(clip.motion.frame_count() + 1), random.between(-30, 30));
      set_key(curve, random.between(0, 20), random.between(-30, 30));
      layer.curves[random.below(clip.motion.channel_count())] = std::make_shared<const KeyCurve>(std::move(curve));
    }
    stack.layers.push_back(std::move(layer));
  }
  History history;
  EXPECT_TRUE(history.apply(clip, make_stack_edit(clip, "Layers", std::move(stack))));
  return clip;
}

const Layer* find_locked(const Clip& clip) {
  const auto& layers = clip.stack.layers;
  const auto found = std::find_if(layers.begin(), layers.end(), [](const Layer& layer) { return layer.locked; });
  return found == layers.end() ? nullptr : &*found;
}

bool is_sample_operation(const Operation& operation) {
  return operation.reach != OperationReach::Frames && operation.reach != OperationReach::Clip &&
         operation.reach != OperationReach::Figure && operation.reach != OperationReach::Keys &&
         operation.reach != OperationReach::Layers;
}

TEST(OperationTable, WithoutWeightChangesNothing) {
  const Clip clip = make_figure(40);
  const Clip other = make_figure(50);
  OperationTarget target = whole_clip(clip);
  target.weight = 0.0;
  for (const Operation& operation : operations()) {
    if (!is_sample_operation(operation)) continue;
    const auto outcome = make_operation_edit(clip, operation, target, values_of(operation, {}, &other));
    ASSERT_TRUE(outcome) << operation.id;
    EXPECT_TRUE(outcome->edit.empty()) << operation.id;
  }
}

bool is_within(const Clip& clip, const Operation& operation, const OperationTarget& target, ChannelIndex channel) {
  const JointIndex joint = clip.skeleton.channel(channel).joint;
  const bool has_channel = std::binary_search(target.channels.begin(), target.channels.end(), channel);
  const bool has_joint = std::binary_search(target.joints.begin(), target.joints.end(), joint);
  if (operation.reach == OperationReach::Roots) return clip.skeleton.parent(joint) == kNoParent;
  return has_channel || (operation.reach == OperationReach::Joints && has_joint);
}

TEST(OperationTable, LeavesWhatIsOutsideOfTheTarget) {
  Random random(12);
  const Clip other = make_figure(50);
  for (int round = 0; round < 60; ++round) {
    const Clip clip = make_wild_figure(random, 40);
    for (const Operation& operation : operations()) {
      if (!is_sample_operation(operation)) continue;
      const OperationTarget target = within_clip(clip, make_random_target(random, clip));
      const auto outcome = make_operation_edit(clip, operation, target, make_random_values(random, operation, &other));
      if (!outcome) continue;
      for (const SamplesChange& change : outcome->edit.samples) {
        EXPECT_GE(change.first, target.frames.first) << operation.id;
        EXPECT_LE(change.first + size_of(change.values), target.frames.end()) << operation.id;
        EXPECT_TRUE(is_within(clip, operation, target, change.channel)) << operation.id;
      }
    }
  }
}

// The work grows with the frames and no faster: were it their square, this would not end.
TEST(OperationTable, TakesLongClips) {
  const Clip clip = make_clip_with_curve(std::vector<double>(100000, 1.0));
  Clip moving = clip;
  for (ChannelIndex channel = 0; channel < 6; ++channel) {
    const std::span<double> samples = moving.motion.channel_samples(channel);
    for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = 40.0 * std::sin(0.01 * static_cast<double>(i) + channel);
  }
  for (const Operation& operation : operations()) {
    try_operation(moving, operation, whole_clip(moving), values_of(operation, {}, &clip));
    if (HasFatalFailure()) return;
  }
}

TEST(OperationTable, RefusesValuesThatDoNotFit) {
  const Clip clip = make_figure(10);
  const Operation& smooth = *find_operation("smooth");
  const auto message_of = [&](const OperationValues& values) {
    const auto outcome = make_operation_edit(clip, smooth, whole_clip(clip), values);
    return outcome ? std::string() : outcome.error().message;
  };
  EXPECT_EQ(message_of({}), "'smooth' takes 1 value, not 0.");
  EXPECT_EQ(message_of(values_of(smooth, {{"sigma", 5000.0}})), "'sigma' is 0.1 to 1000 frames, not 5000.");
  const Operation& median = *find_operation("median");
  EXPECT_EQ(check_values(median, values_of(median, {{"window", 4.0}})).error().message,
            "'window' is an odd number from 1 to 301 frames, not 4.");
  const Operation& append = *find_operation("append");
  EXPECT_EQ(check_values(append, initial_values(append)).error().message, "'append' wants another clip as 'from'.");
}

// A layer that is locked stays as it is, or goes with all others where the frames or the figure are no longer the same.
TEST(OperationTable, LeavesALockedLayer) {
  Random random(14);
  const Clip other = make_figure(12);
  for (int round = 0; round < 40; ++round) {
    const Clip clip = with_locked_layer(make_figure(20), random);
    for (const Operation& operation : operations()) {
      if (operation.id == "layers-bake" || operation.id == "layer-lock") continue;
      SCOPED_TRACE(operation.id);
      const OperationTarget target = round == 0 ? whole_clip(clip) : make_random_target(random, clip);
      const OperationValues values = round == 0 ? values_of(operation, {}, &other) : make_random_values(random, operation, &other);
      try_operation(clip, operation, target, values);
      if (HasFatalFailure()) return;
      const auto outcome = make_operation_edit(clip, operation, target, values);
      if (!outcome) continue;
      Clip changed = clip;
      History history;
      ASSERT_TRUE(history.apply(changed, outcome->edit));
      const bool is_other_clip = changed.motion.frame_count() != clip.motion.frame_count() || !(changed.skeleton == clip.skeleton) ||
                                 changed.file_frames != clip.file_frames;
      if (is_other_clip && changed.stack.empty()) continue;
      const Layer* locked = find_locked(changed);
      ASSERT_NE(locked, nullptr);
      EXPECT_EQ(locked->curves, find_locked(clip)->curves);
      EXPECT_EQ(locked->weight, find_locked(clip)->weight);
      EXPECT_EQ(locked->mode, find_locked(clip)->mode);
    }
  }
}

// Random steps on a clip: undone to the start and done again to the end, whatever they were. Returns how many changed it.
int run_sequence(Random& random, Clip clip, const Clip& other, int most_steps) {
  History history(std::size_t{1} << 30);
  std::vector<std::vector<std::uint64_t>> states = {bits_of(clip)};
  for (int step = 0; step < most_steps; ++step) {
    const Operation& operation = operations()[idx(random.below(size_of(operations())))];
    const auto outcome =
        make_operation_edit(clip, operation, make_random_target(random, clip), make_random_values(random, operation, &other));
    if (!outcome || outcome->edit.empty() || clip.motion.frame_count() > 2000) continue;
    EXPECT_TRUE(history.apply(clip, outcome->edit)) << operation.id;
    states.push_back(bits_of(clip));
  }
  EXPECT_EQ(idx(history.undo_depth()) + 1, states.size());
  for (std::size_t i = states.size(); i-- > 1;) {
    EXPECT_TRUE(history.undo(clip));
    EXPECT_EQ(bits_of(clip), states[i - 1]);
  }
  for (std::size_t i = 1; i < states.size(); ++i) {
    EXPECT_TRUE(history.redo(clip));
    EXPECT_EQ(bits_of(clip), states[i]);
  }
  return size_of(states) - 1;
}

TEST(OperationTable, LongRandomSequencesAreUndoneAndRedone) {
  const Clip other = make_figure(9);
  int steps = 0;
  for (std::uint64_t seed = 0; seed < 800 && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    Clip clip = random.one_in(2) ? make_random_clip(random) : make_wild_figure(random, random.below(40));
    steps += run_sequence(random, std::move(clip), other, 60);
  }
  EXPECT_GT(steps, 15000);
}

// MAREY_SEQUENCES of them, 2000 if it is not set: npm test sets it for the native build.
TEST(OperationTable, ManyRandomSequencesAreUndoneAndRedone) {
  const char* wanted = std::getenv("MAREY_SEQUENCES");
  const int sequences = wanted == nullptr ? 2000 : std::atoi(wanted);
  const Clip other = make_figure(4);
  int steps = 0;
  for (int seed = 0; seed < sequences && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(static_cast<std::uint64_t>(seed) + 1'000'000);
    Clip clip = random.one_in(2) ? make_random_clip(random) : make_wild_figure(random, random.below(8));
    if (random.one_in(4) && clip.motion.channel_count() > 0) clip = with_locked_layer(std::move(clip), random);
    steps += run_sequence(random, std::move(clip), other, 8);
  }
  EXPECT_GT(steps, sequences);
  std::cout << sequences << " sequences with " << steps << " changes undone and redone\n";
}

}  // namespace
}  // namespace marey::test
