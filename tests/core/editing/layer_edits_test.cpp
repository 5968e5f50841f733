#include "core/editing/layer_edits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "core/editing/history.h"
#include "core/editing/key_edits.h"
#include "core/math/euler.h"
#include "core/motion/euler_channels.h"
#include "core/motion/sampling.h"
#include "tests/core/editing/operation_clips.h"

namespace marey::test {
namespace {

SharedKeys keys_of(std::initializer_list<std::pair<double, double>> points) {
  KeyCurve curve;
  for (const auto& [frame, value] : points) {
    Key key;
    key.frame = frame;
    key.value = value;
    curve.keys.push_back(key);
  }
  return std::make_shared<const KeyCurve>(std::move(curve));
}

SharedKeys random_keys(Random& random, int frame_count, double most) {
  KeyCurve curve;
  double frame = 0.0;
  const int count = 1 + random.below(4);
  for (int i = 0; i < count; ++i) {
    Key key;
    frame += 0.5 + random.between(0.0, frame_count / 3.0);
    key.frame = frame;
    key.value = random.between(-most, most);
    key.interpolation = static_cast<Interpolation>(random.below(3));
    curve.keys.push_back(key);
  }
  return std::make_shared<const KeyCurve>(std::move(curve));
}

Layer random_layer(Random& random, const Clip& clip) {
  Layer layer;
  layer.name = "Layer";
  layer.mode = random.one_in(3) ? LayerMode::Override : LayerMode::Additive;
  layer.sums_angles = random.one_in(4);
  layer.muted = random.one_in(4);
  layer.solo = random.one_in(8);
  if (random.one_in(2)) layer.weight = random_keys(random, clip.motion.frame_count(), 1.5);
  const int count = random.below(5);
  for (int i = 0; i < count; ++i) {
    layer.curves[random.below(clip.motion.channel_count())] = random_keys(random, clip.motion.frame_count(), 60.0);
  }
  return layer;
}

LayerStack random_stack(Random& random, const Clip& clip) {
  LayerStack stack = clip.stack;
  const int change = random.below(5);
  if (change == 0 || stack.layers.empty()) {
    stack.layers.push_back(random_layer(random, clip));
  } else if (change == 1) {
    stack.layers.erase(stack.layers.begin() + random.below(size_of(stack.layers)));
  } else if (change == 2) {
    stack.layers[idx(random.below(size_of(stack.layers)))] = random_layer(random, clip);
  } else if (change == 3) {
    stack.keyed[random.below(clip.motion.channel_count())] = random_keys(random, clip.motion.frame_count(), 60.0);
  } else {
    stack.keyed.clear();
    std::reverse(stack.layers.begin(), stack.layers.end());
  }
  return stack;
}

// The result as it would be made anew from what is beneath.
void expect_agreement(const Clip& clip) {
  ChannelSamples samples;
  const std::vector<ChannelIndex> layered = layered_channels(clip.skeleton, clip.stack);
  for (const ChannelIndex channel : layered) samples[channel] = *clip.stack.beneath.at(channel);
  lay_on(clip.skeleton, clip.stack, 0, size_of(clip.stack.layers), {0, clip.motion.frame_count()}, samples);
  for (const auto& [channel, values] : samples) {
    const auto result = clip.motion.channel_samples(channel);
    EXPECT_TRUE(std::equal(values.begin(), values.end(), result.begin())) << channel_label(clip.skeleton, channel);
  }
  EXPECT_EQ(clip.stack.beneath.size(), layered.size());
}

Clip with_stack(Clip clip, LayerStack stack) {
  History history;
  EXPECT_TRUE(history.apply(clip, make_stack_edit(clip, "Layers", std::move(stack))).ok());
  return clip;
}

double angle_between(const glm::dquat& a, const glm::dquat& b) {
  return glm::degrees(2.0 * std::asin(std::min(1.0, glm::length(glm::dvec3((glm::inverse(a) * b).x, (glm::inverse(a) * b).y,
                                                                             (glm::inverse(a) * b).z)))));
}

TEST(Layers, SwitchedOffGiveTheOriginalToTheBit) {
  Random random(21);
  for (int round = 0; round < 200; ++round) {
    const Clip original = make_wild_figure(random, 30);
    LayerStack stack;
    for (int i = 0; i < 3; ++i) stack.layers.push_back(random_layer(random, original));
    const Clip layered = with_stack(original, stack);
    for (Layer& layer : stack.layers) layer.muted = true;
    EXPECT_EQ(bits_of(with_stack(layered, stack)), bits_of(with_stack(original, stack)));
    const Clip without = with_stack(layered, {});
    EXPECT_EQ(bits_of(without), bits_of(original));
    EXPECT_TRUE(without.stack.beneath.empty());
  }
}

// Whatever is done to the stack in whatever order, the samples are what comes of it, and undo leads back.
TEST(Layers, AgreeWithTheSamplesAfterAnyEdits) {
  Random random(22);
  for (int round = 0; round < 300; ++round) {
    Clip clip = make_wild_figure(random, 20);
    const auto start = bits_of(clip);
    History history;
    for (int step = 0; step < 12; ++step) {
      ASSERT_TRUE(history.apply(clip, make_stack_edit(clip, "Layers", random_stack(random, clip))).ok());
      expect_agreement(clip);
      if (testing::Test::HasFailure()) return;
    }
    const auto end = bits_of(clip);
    const LayerStack last = clip.stack;
    while (history.undo(clip)) expect_agreement(clip);
    EXPECT_EQ(bits_of(clip), start);
    EXPECT_TRUE(clip.stack.empty());
    while (history.redo(clip)) {}
    EXPECT_EQ(bits_of(clip), end);
    EXPECT_TRUE(clip.stack == last);
  }
}

TEST(Layers, TurnJointsInTheirOwnAxes) {
  Random random(23);
  const Clip original = make_wild_figure(random, 10);
  const JointIndex joint = 1;
  const EulerChannels euler = *find_euler_channels(original.skeleton, joint);
  LayerStack stack;
  stack.layers.emplace_back();
  const glm::dvec3 turn(20.0, -35.0, 50.0);
  for (int c = 0; c < 3; ++c) stack.layers[0].curves[euler.channels[c]] = keys_of({{0.0, turn[c]}});
  const Clip layered = with_stack(original, stack);
  stack.layers[0].weight = keys_of({{0.0, 0.25}});
  const Clip quarter = with_stack(original, stack);
  for (FrameIndex frame = 0; frame < 10; ++frame) {
    const glm::dquat before = joint_rotation(original.skeleton, original.motion, joint, frame);
    const glm::dquat added = rotation_from_euler(euler.order, turn);
    EXPECT_LT(angle_between(before * added, joint_rotation(layered.skeleton, layered.motion, joint, frame)), 1e-10);
    const double whole = angle_between(glm::dquat(1.0, 0.0, 0.0, 0.0), added);
    EXPECT_NEAR(angle_between(before, joint_rotation(quarter.skeleton, quarter.motion, joint, frame)), 0.25 * whole, 1e-9);
  }
}

TEST(Layers, InPlaceGiveTheirOwnAngles) {
  const Clip original = make_figure(10);
  const EulerChannels euler = *find_euler_channels(original.skeleton, 1);
  LayerStack stack;
  stack.layers.emplace_back();
  stack.layers[0].mode = LayerMode::Override;
  stack.layers[0].curves[euler.channels[1]] = keys_of({{2.0, 12.0}, {6.0, -40.0}});
  const Clip layered = with_stack(original, stack);
  EXPECT_EQ(layered.motion.sample(euler.channels[1], 2), 12.0);
  EXPECT_EQ(layered.motion.sample(euler.channels[1], 6), -40.0);
  for (const int c : {0, 2}) {
    const auto before = original.motion.channel_samples(euler.channels[c]);
    EXPECT_TRUE(std::equal(before.begin(), before.end(), layered.motion.channel_samples(euler.channels[c]).begin()));
  }
}

TEST(Layers, PositionsAreSumsAndBlends) {
  const Clip original = make_figure(5);
  LayerStack stack;
  stack.layers.resize(2);
  stack.layers[0].curves[0] = keys_of({{0.0, 3.0}});
  stack.layers[1].mode = LayerMode::Override;
  stack.layers[1].weight = keys_of({{0.0, 0.5}});
  stack.layers[1].curves[0] = keys_of({{0.0, 100.0}});
  const Clip layered = with_stack(original, stack);
  for (FrameIndex frame = 0; frame < 5; ++frame) {
    EXPECT_NEAR(layered.motion.sample(0, frame), 0.5 * (original.motion.sample(0, frame) + 3.0) + 50.0, 1e-12);
  }
}

TEST(Layers, SoloSilencesTheOthers) {
  const Clip original = make_figure(5);
  LayerStack stack;
  stack.layers.resize(3);
  for (int i = 0; i < 3; ++i) stack.layers[idx(i)].curves[0] = keys_of({{0.0, i == 0 ? 1.0 : i == 1 ? 10.0 : 100.0}});
  stack.layers[1].solo = true;
  stack.layers[2].solo = true;
  stack.layers[2].muted = true;
  EXPECT_NEAR(with_stack(original, stack).motion.sample(0, 0), original.motion.sample(0, 0) + 10.0, 1e-12);
}

// What people see is what they asked for; what is beneath takes it up, and only in the frames that changed.
TEST(Layers, EditsOfSamplesReachWhatIsBeneath) {
  Random random(24);
  int absorbed = 0;
  for (int round = 0; round < 300; ++round) {
    Clip clip = make_wild_figure(random, 25);
    LayerStack stack;
    for (int i = 0; i < 2; ++i) {
      stack.layers.push_back(random_layer(random, clip));
      if (!random.one_in(4)) stack.layers.back().mode = LayerMode::Additive;
    }
    clip = with_stack(std::move(clip), stack);
    const Clip before = clip;
    Edit edit;
    const ChannelIndex channel = random.below(clip.motion.channel_count());
    edit.samples.push_back({channel, 5, {1.5, -20.0, 33.25}});
    History history;
    if (!history.apply(clip, edit).ok()) {
      EXPECT_EQ(bits_of(clip), bits_of(before));
      continue;
    }
    ++absorbed;
    EXPECT_EQ(clip.motion.sample(channel, 6), -20.0);
    for (const auto& [moved, samples] : clip.stack.beneath) {
      for (const FrameIndex frame : {0, 4, 8, 24}) {
        EXPECT_EQ((*samples)[idx(frame)], (*before.stack.beneath.at(moved))[idx(frame)]);
      }
    }
    // Made anew from what is beneath, the pose is the one asked for.
    Clip anew = clip;
    ChannelSamples samples;
    for (const auto& [moved, beneath] : clip.stack.beneath) samples[moved] = *beneath;
    lay_on(clip.skeleton, clip.stack, 0, size_of(clip.stack.layers), {0, 25}, samples);
    for (const auto& [moved, values] : samples) std::copy(values.begin(), values.end(), anew.motion.channel_samples(moved).begin());
    EXPECT_LT(largest_difference(positions_of(anew), positions_of(clip)), 1e-9);
    history.undo(clip);
    EXPECT_EQ(bits_of(clip), bits_of(before));
    EXPECT_TRUE(clip.stack == before.stack);
  }
  EXPECT_GT(absorbed, 150);
}

TEST(Layers, InPlaceRefuseEditsOfWhatTheyHide) {
  LayerStack stack;
  stack.layers.emplace_back();
  stack.layers[0].mode = LayerMode::Override;
  stack.layers[0].curves[0] = keys_of({{0.0, 3.0}});
  Clip clip = with_stack(make_figure(5), stack);
  Edit edit;
  edit.samples.push_back({0, 0, {1.0}});
  History history;
  const Status status = history.apply(clip, edit);
  ASSERT_FALSE(status.ok());
  EXPECT_NE(status.error().message.find("Hips Xposition"), std::string::npos) << status.error().message;
}

TEST(Layers, AreBakedWhereFramesOrFigureChange) {
  LayerStack stack;
  stack.layers.emplace_back();
  stack.layers[0].curves[0] = keys_of({{0.0, 3.0}});
  const Clip clip = with_stack(make_figure(12), stack);
  for (const char* operation : {"trim", "change-order"}) {
    OperationTarget target = whole_clip(clip);
    target.frames = {2, 5};
    const OperationOutcome outcome = outcome_of(clip, operation, target);
    ASSERT_EQ(outcome.notes.size(), 1u) << operation;
    Clip changed = clip;
    History history;
    ASSERT_TRUE(history.apply(changed, outcome.edit).ok());
    EXPECT_TRUE(changed.stack.empty());
    history.undo(changed);
    EXPECT_EQ(bits_of(changed), bits_of(clip));
  }
}

TEST(Layers, SetKeysSoThatTheResultIsWhatWasWanted) {
  Random random(25);
  int set = 0;
  for (int round = 0; round < 500; ++round) {
    Clip clip = make_wild_figure(random, 20);
    LayerStack stack;
    for (int i = 0; i < 3; ++i) stack.layers.push_back(random_layer(random, clip));
    clip = with_stack(std::move(clip), stack);
    const int layer = random.below(3);
    const FrameIndex frame = random.below(20);
    const ChannelIndex channel = random.below(clip.motion.channel_count());
    ChannelValues wanted;
    for (const ChannelIndex moved : channels_moved_with(clip.skeleton, channel)) wanted[moved] = random.between(-80.0, 80.0);
    Result<Edit> edit = make_pose_key_edit(clip, "Key", layer, frame, wanted);
    if (!edit) continue;
    ++set;
    Clip keyed = clip;
    History history;
    ASSERT_TRUE(history.apply(keyed, *edit).ok());
    expect_agreement(keyed);
    for (const auto& entry : wanted) clip.motion.channel_samples(entry.first)[idx(frame)] = entry.second;
    const JointIndex joint = clip.skeleton.channel(channel).joint;
    EXPECT_LT(angle_between(joint_rotation(keyed.skeleton, keyed.motion, joint, frame),
                            joint_rotation(clip.skeleton, clip.motion, joint, frame)), 1e-6);
    if (wanted.size() == 1) {
      EXPECT_NEAR(keyed.motion.sample(channel, frame), wanted.begin()->second, 1e-9);
    }
  }
  EXPECT_GT(set, 150);
}

TEST(Layers, LockedKeepTheirKeys) {
  const Clip original = make_figure(5);
  LayerStack stack;
  stack.layers.emplace_back();
  stack.layers[0].name = "Fix";
  stack.layers[0].locked = true;
  const Clip clip = with_stack(original, stack);
  const auto edit = make_pose_key_edit(clip, "Key", 0, 1, {{0, 2.0}});
  ASSERT_FALSE(edit);
  EXPECT_NE(edit.error().message.find("\"Fix\" is locked"), std::string::npos);
}

TEST(Keys, OfAChannelItselfAreItsSamples) {
  LayerStack stack;
  stack.keyed[0] = keys_of({{0.0, 1.0}, {4.0, 9.0}});
  Clip clip = with_stack(make_figure(5), stack);
  EXPECT_EQ(clip.motion.sample(0, 4), 9.0);
  History history;
  const auto edit = make_pose_key_edit(clip, "Key", kOwnKeys, 2, {{0, -7.0}});
  ASSERT_TRUE(edit);
  ASSERT_TRUE(history.apply(clip, *edit).ok());
  EXPECT_EQ(clip.motion.sample(0, 2), -7.0);
  EXPECT_EQ(find_keys(clip.stack, kOwnKeys, 0)->keys.size(), 3u);
  EXPECT_FALSE(make_pose_key_edit(clip, "Key", kOwnKeys, 2, {{1, -7.0}}));
  Edit samples;
  samples.samples.push_back({0, 1, {5.0}});
  ASSERT_TRUE(history.apply(clip, samples).ok());
  EXPECT_TRUE(clip.stack.empty()) << "samples take the place of keys";
  EXPECT_EQ(clip.motion.sample(0, 2), -7.0);
}

// The layer that turns the joint needs all of its angles, the one that sums them has a key for one.
TEST(Layers, SetKeysOnASumBesideATurn) {
  const Clip original = make_clip(3, 12);
  const ChannelIndex channel = original.skeleton.first_channel(1);
  ASSERT_EQ(channels_moved_with(original.skeleton, channel).size(), 3u);
  for (const bool sum_is_above : {true, false}) {
    LayerStack stack;
    for (const bool sums : {!sum_is_above, sum_is_above}) {
      Layer& layer = stack.layers.emplace_back();
      layer.name = sums ? "Sum" : "Turn";
      layer.sums_angles = sums;
      layer.curves[channel] = keys_of({{0.0, 10.0}, {11.0, -20.0}});
    }
    const Clip clip = with_stack(original, stack);
    const double wanted = clip.motion.sample(channel, 5) + 7.0;
    const auto edit = make_pose_key_edit(clip, "Key", sum_is_above ? 1 : 0, 5, {{channel, wanted}});
    ASSERT_TRUE(edit) << edit.error().message;
    Clip changed = clip;
    History history;
    ASSERT_TRUE(history.apply(changed, *edit));
    EXPECT_NEAR(changed.motion.sample(channel, 5), wanted, 1e-9) << sum_is_above;
  }
}

TEST(LayerEdits, AChangeOfALockedLayerIsRefusedButForItsSwitches) {
  Clip clip = make_clip(3, 10);
  LayerStack stack;
  stack.layers.emplace_back().name = "Fix";
  stack.layers[0].locked = true;
  clip = with_stack(std::move(clip), stack);
  EXPECT_FALSE(make_layer_edit(clip, "Mode", 0, [](Layer& layer) { layer.mode = LayerMode::Override; }));
  EXPECT_FALSE(make_layer_deletion(clip, 0));
  EXPECT_EQ(make_layer_deletion(clip, 0).error().message, "The layer \"Fix\" is locked. Unlock it to change it.");
  EXPECT_TRUE(make_layer_edit(clip, "Mute", 0, [](Layer& layer) { layer.muted = true; }));
  EXPECT_TRUE(make_layer_edit(clip, "Name", 0, [](Layer& layer) { layer.name = "Other"; }));
  EXPECT_TRUE(make_layer_edit(clip, "Unlock", 0, [](Layer& layer) { layer.locked = false; }));
}

TEST(LayerEdits, FindsAFreeName) {
  LayerStack stack;
  EXPECT_EQ(free_layer_name(stack), "Layer 1");
  for (const char* name : {"Layer 1", "Fix"}) stack.layers.emplace_back().name = name;
  EXPECT_EQ(free_layer_name(stack), "Layer 2");
  EXPECT_EQ(free_layer_name(stack, "Fix"), "Fix 2");
  EXPECT_EQ(free_layer_name(stack, "Arms"), "Arms");
}

}  // namespace
}  // namespace marey::test
