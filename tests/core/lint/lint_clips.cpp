#include "tests/core/lint/lint_clips.h"

#include <gtest/gtest.h>

#include <cmath>

namespace marey::test {

using figures::channels;

Skeleton make_walker() {
  return figures::make_skeleton({{"Hips", kNoParent, {0.0, 0.0, 0.0}, channels("xyzZXY"), {}},
                                 {"Knee", 0, {0.0, -45.0, 0.0}, channels("ZXY"), {}},
                                 {"Foot", 1, {0.0, -45.0, 0.0}, channels("ZXY"), {{0.0, 0.0, 5.0}}},
                                 {"Chest", 0, {0.0, 5.0, 0.0}, channels("ZXY"), {{0.0, 40.0, 0.0}}}});
}

Clip make_moving_walker(int frame_count) {
  Clip clip;
  clip.skeleton = make_walker();
  clip.motion = Motion(clip.skeleton.channel_count(), frame_count, kFrameTime_s);
  for (ChannelIndex channel = 0; channel < clip.skeleton.channel_count(); ++channel) {
    const bool is_angle = is_rotation(clip.skeleton.channel(channel).kind);
    const double size = is_angle ? 4.0 : 0.5;
    const double rate = 0.05 + 0.003 * channel;
    auto samples = clip.motion.channel_samples(channel);
    for (FrameIndex frame = 0; frame < frame_count; ++frame) samples[idx(frame)] = size * std::sin(rate * frame + channel);
  }
  for (double& height : samples_of(clip, "Hips Yposition")) height += 90.0;
  return clip;
}

ChannelIndex find_channel(const Clip& clip, const std::string& label) {
  for (ChannelIndex channel = 0; channel < clip.skeleton.channel_count(); ++channel) {
    if (channel_label(clip.skeleton, channel) == label) return channel;
  }
  ADD_FAILURE() << "no channel " << label;
  return 0;
}

std::span<double> samples_of(Clip& clip, const std::string& label) {
  return clip.motion.channel_samples(find_channel(clip, label));
}

Clip make_still(const std::vector<figures::JointPlan>& joints) {
  Clip clip;
  clip.skeleton = figures::make_skeleton(joints);
  clip.motion = Motion(clip.skeleton.channel_count(), 0, kFrameTime_s);
  return clip;
}

std::string kinds_of(const LintReport& report) {
  std::string text;
  for (const Finding& finding : report.findings) text.append(text.empty() ? "" : " ").append(traits_of(finding.kind).id);
  return text;
}

Finding the_finding(const LintReport& report, FindingKind kind) {
  Finding found;
  int count = 0;
  for (const Finding& finding : report.findings) {
    if (finding.kind != kind) continue;
    found = finding;
    ++count;
  }
  EXPECT_EQ(count, 1) << traits_of(kind).id << " among: " << kinds_of(report);
  return found;
}

}  // namespace marey::test
