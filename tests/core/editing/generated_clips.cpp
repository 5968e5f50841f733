#include "tests/core/editing/generated_clips.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "core/editing/clip_operations.h"
#include "core/editing/curve_operations.h"
#include "core/editing/figure_draft.h"
#include "core/skeleton/skeleton_builder.h"

namespace marey::test {
namespace {

constexpr double kFrameTimeS = 1.0 / 30.0;

double make_special_number(Random& random) {
  using Limits = std::numeric_limits<double>;
  const double numbers[] = {Limits::quiet_NaN(),  Limits::infinity(), -Limits::infinity(), -0.0,
                            Limits::denorm_min(), Limits::max()};
  return numbers[random.below(6)];
}

double make_number(Random& random) {
  return random.one_in(40) ? make_special_number(random) : random.between(-180, 180);
}

Edit make_random_samples_edit(Random& random, const Clip& clip) {
  Edit edit;
  edit.name = "Replace";
  for (int i = random.below(4); i >= 0; --i) {
    const int length = random.below(clip.motion.frame_count() + 2);
    SamplesChange change{random.below(clip.motion.channel_count() + 1) - (random.one_in(30) ? 1 : 0),
                         random.below(clip.motion.frame_count() - length + 2),
                         {}};
    for (int k = 0; k < length; ++k) change.values.push_back(make_number(random));
    edit.samples.push_back(std::move(change));
  }
  return edit;
}

Edit make_random_settings_edit(Random& random, const Clip& clip) {
  ClipSettings settings = clip.settings;
  settings.up_axis = static_cast<Axis>(random.below(3));
  settings.position_rule = random.one_in(2) ? PositionRule::Add : PositionRule::Replace;
  settings.metres_per_unit = make_number(random);
  return make_settings_edit(clip, settings);
}

// Another name, a channel less or more, or an end site less.
Edit make_random_figure_edit(Random& random, const Clip& clip) {
  FigureDraft draft = take_apart(clip);
  NodeDraft& node = draft.nodes[idx(random.below(size_of(draft.nodes)))];
  if (random.one_in(3)) node.name_bytes = "K" + std::to_string(random.below(3));
  if (random.one_in(3) && !node.channels.empty()) node.channels.pop_back();
  if (random.one_in(3) && !node.is_end_site) {
    node.channels.push_back({ChannelKind::Zrotation, {}, std::vector<double>(idx(clip.motion.frame_count()), make_number(random))});
  }
  if (random.one_in(3) && draft.nodes.back().is_end_site) draft.nodes.pop_back();
  Edit edit;
  edit.name = "Change figure";
  edit.figure = put_together(clip, std::move(draft)).value();
  if (random.one_in(20)) edit.figure->motion = Motion();
  return edit;
}

}  // namespace

Clip make_clip(int joint_count, int frame_count) {
  SkeletonBuilder builder;
  builder.open_joint("Hips");
  for (int kind = 0; kind < 3; ++kind) builder.add_channel(static_cast<ChannelKind>(kind));
  for (int joint = 0; joint < joint_count; ++joint) {
    if (joint > 0) builder.open_joint("Joint" + std::to_string(joint), {0, 10, 0});
    builder.add_channel(ChannelKind::Zrotation);
    builder.add_channel(ChannelKind::Xrotation);
    builder.add_channel(ChannelKind::Yrotation);
  }
  builder.add_end_site({0, 10, 0});
  for (int joint = 0; joint < joint_count; ++joint) builder.close_joint();
  Clip clip;
  clip.skeleton = builder.build().value();
  clip.motion = Motion(clip.skeleton.channel_count(), frame_count, kFrameTimeS);
  return clip;
}

Clip make_clip_with_curve(const std::vector<double>& curve) {
  Clip clip = make_clip(1, size_of(curve));
  std::copy(curve.begin(), curve.end(), clip.motion.channel_samples(kCurve).begin());
  return clip;
}

Clip make_random_clip(Random& random) {
  SkeletonBuilder builder;
  const int joint_count = 1 + random.below(6);
  for (int joint = 0; joint < joint_count; ++joint) {
    while (builder.open_depth() > 1 && random.one_in(3)) builder.close_joint();
    std::string name = "J";
    name += std::to_string(random.below(3));
    builder.open_joint(std::move(name), {random.between(-9, 9), 0, random.between(-9, 9)});
    for (int i = random.below(5); i > 0; --i) builder.add_channel(static_cast<ChannelKind>(random.below(9)));
  }
  if (random.one_in(2)) builder.add_end_site({1, 2, 3});
  while (builder.open_depth() > 0) builder.close_joint();
  Clip clip;
  clip.skeleton = builder.build().value();
  const int frame_count = random.one_in(4) ? random.below(3) : random.below(41);
  std::vector<double> samples(idx(clip.skeleton.channel_count()) * idx(frame_count));
  for (double& sample : samples) sample = make_number(random);
  clip.motion = Motion(clip.skeleton.channel_count(), frame_count, kFrameTimeS, std::move(samples));
  return clip;
}

SampleSelection make_random_selection(Random& random, const Clip& clip) {
  SampleSelection selection;
  for (int i = random.below(5); i > 0; --i) {
    const FrameRange frames{random.below(clip.motion.frame_count() + 4) - 2, random.below(12)};
    selection.add(random.below(clip.motion.channel_count() + 1), frames);
  }
  return selection;
}

Edit make_random_edit(Random& random, const Clip& clip) {
  const SampleSelection selection = make_random_selection(random, clip);
  switch (random.below(11)) {
    case 0:
      return make_move_edit(clip, selection, make_number(random), {random.between(-1, 9)});
    case 1:
      return make_value_edit(clip, selection, make_number(random));
    case 2:
      return make_scale_edit(clip, selection, random.between(-2, 2), compute_selection_mean(clip, selection));
    case 3:
      return make_smooth_edit(clip, selection, random.between(-1, 6));
    case 4:
      return make_sample_edit(clip, random.below(clip.motion.channel_count() + 1), 0, make_number(random));
    case 5:
      return make_offset_edit(clip, random.below(clip.skeleton.node_count() + 1), {1, make_number(random), 2});
    case 6:
      return make_random_settings_edit(random, clip);
    case 7:
      return make_frame_time_edit(random.between(-0.01, 0.1));
    case 8:
      return make_remove_frames_edit({random.below(clip.motion.frame_count() + 2) - 1, random.below(5)});
    case 9:
      return make_random_figure_edit(random, clip);
    default:
      return make_random_samples_edit(random, clip);
  }
}

std::vector<double> samples_of(const Clip& clip, ChannelIndex channel) {
  const std::span<const double> samples = clip.motion.channel_samples(channel);
  return {samples.begin(), samples.end()};
}

Clip edited(Clip clip, Edit edit) {
  const Status status = check_edit(clip, edit);
  EXPECT_TRUE(status.ok()) << (status ? "" : status.error().message);
  if (status) swap_edit(clip, edit);
  return clip;
}

SampleSelection selected(ChannelIndex channel, FrameRange frames) {
  SampleSelection selection;
  selection.add(channel, frames);
  return selection;
}

}  // namespace marey::test
