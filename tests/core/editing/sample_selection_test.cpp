#include "core/editing/sample_selection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "tests/core/editing/generated_clips.h"

namespace marey::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr int kChannels = 3;
constexpr int kFrames = 24;

using Samples = std::set<std::pair<ChannelIndex, FrameIndex>>;

Samples samples_in(const SampleSelection& selection) {
  Samples samples;
  for (ChannelIndex channel = -1; channel <= kChannels; ++channel) {
    for (FrameIndex frame = -4; frame < kFrames + 12; ++frame) {
      if (selection.contains(channel, frame)) samples.insert({channel, frame});
    }
  }
  return samples;
}

void expect_canonical(const SampleSelection& selection) {
  const std::vector<SampleRun>& runs = selection.runs();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    ASSERT_GT(runs[i].frames.count, 0);
    if (i == 0) continue;
    ASSERT_LE(runs[i - 1].channel, runs[i].channel);
    ASSERT_TRUE(runs[i - 1].channel < runs[i].channel || runs[i - 1].frames.end() < runs[i].frames.first);
  }
}

TEST(SampleSelection, IsASetOfSamples) {
  Random random(3);
  for (int round = 0; round < 200; ++round) {
    SampleSelection selection;
    Samples model;
    for (int step = 0; step < 40; ++step) {
      const ChannelIndex channel = random.below(kChannels);
      const FrameRange frames{random.below(kFrames), random.below(8) - 1};
      const bool adds = random.below(5) < 3;
      if (adds) selection.add(channel, frames);
      if (!adds) selection.remove(channel, frames);
      for (FrameIndex frame = frames.first; frame < frames.end(); ++frame) {
        if (adds) model.insert({channel, frame});
        if (!adds) model.erase({channel, frame});
      }
      expect_canonical(selection);
      ASSERT_EQ(samples_in(selection), model);
      ASSERT_EQ(selection.count(), std::ssize(model));
      ASSERT_EQ(selection.empty(), model.empty());
    }
    std::set<ChannelIndex> channels;
    for (const auto& [channel, frame] : model) channels.insert(channel);
    EXPECT_EQ(selection.channels(), std::vector<ChannelIndex>(channels.begin(), channels.end()));
  }
}

TEST(SampleSelection, NeighboursBecomeOneRun) {
  SampleSelection selection;
  selection.add(1, {10, 5});
  selection.add(1, {20, 5});
  selection.add(0, {15, 5});
  EXPECT_THAT(selection.runs(), ElementsAre(SampleRun{0, {15, 5}}, SampleRun{1, {10, 5}}, SampleRun{1, {20, 5}}));
  selection.add(1, {15, 5});
  EXPECT_THAT(selection.runs(), ElementsAre(SampleRun{0, {15, 5}}, SampleRun{1, {10, 15}}));
}

TEST(SampleSelection, RemovingFromTheMiddleLeavesTwoRuns) {
  SampleSelection selection;
  selection.add(0, {0, 10});
  selection.remove(0, {4, 2});
  EXPECT_THAT(selection.runs(), ElementsAre(SampleRun{0, {0, 4}}, SampleRun{0, {6, 4}}));
  selection.remove(0, {0, 10});
  EXPECT_THAT(selection.runs(), IsEmpty());
}

TEST(SampleSelection, ABoxOverALongCaptureIsOneRunPerChannel) {
  SampleSelection selection;
  for (ChannelIndex channel = 0; channel < 60; ++channel) selection.add(channel, {0, 1'000'000});
  EXPECT_EQ(selection.runs().size(), 60u);
  EXPECT_EQ(selection.count(), 60'000'000);
}

TEST(SampleSelection, NothingIsAddedByAnEmptyRange) {
  SampleSelection selection;
  selection.add(0, {5, 0});
  selection.add(0, {5, -3});
  EXPECT_TRUE(selection.empty());
  selection.add(0, {5, 1});
  selection.remove(0, {5, 0});
  EXPECT_EQ(selection.count(), 1);
}

}  // namespace
}  // namespace marey::test
