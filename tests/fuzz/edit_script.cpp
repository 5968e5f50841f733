#include "tests/fuzz/edit_script.h"

#include <limits>

#include "core/editing/clip_operations.h"
#include "core/editing/curve_operations.h"

namespace marey::test {
namespace {

/// Mostly numbers like those of clips; now and then one that must not get in, or hardly may.
double take_number(InputBytes& script) {
  using Limits = std::numeric_limits<double>;
  constexpr double kSpecial[] = {Limits::quiet_NaN(), Limits::infinity(), -0.0, Limits::denorm_min(), Limits::max(),
                                 -Limits::max(), 1e300, 0.1 + 0.2};
  const int byte = script.take_byte();
  return byte >= 240 ? kSpecial[byte % 8] : (byte - 120) * 0.375 + script.take_byte() * 1e-3;
}

SampleSelection take_selection(InputBytes& script, const Clip& clip) {
  SampleSelection selection;
  for (int runs = script.take_below(4); runs > 0; --runs) {
    const int channel = script.take_near(clip.motion.channel_count());
    const int first = script.take_near(clip.motion.frame_count());
    const FrameRange frames{first, script.take_below(9)};
    if (script.take_below(4) == 0) {
      selection.remove(channel, frames);
    } else {
      selection.add(channel, frames);
    }
  }
  return selection;
}

Edit take_samples_edit(InputBytes& script, const Clip& clip) {
  Edit edit;
  edit.name = "Replace";
  for (int changes = script.take_below(3); changes >= 0; --changes) {
    SamplesChange change{script.take_near(clip.motion.channel_count()), script.take_near(clip.motion.frame_count()), {}};
    for (int count = script.take_below(6); count > 0; --count) change.values.push_back(take_number(script));
    edit.samples.push_back(std::move(change));
  }
  return edit;
}

Edit take_frames_edit(InputBytes& script, const Clip& clip) {
  Edit edit;
  edit.name = "Insert";
  const int first = script.take_near(clip.motion.frame_count());
  const int inserted = script.take_below(4);
  Motion motion(clip.motion.channel_count(), inserted, 1.0);
  if (inserted > 0 && motion.channel_count() > 0) motion.channel_samples(0)[0] = take_number(script);
  edit.frames = FramesChange{{first, script.take_below(3)}, std::move(motion), {}};
  for (int frame = 0; frame < inserted; ++frame) edit.frames->file_frames.push_back(frame);
  return edit;
}

Edit take_settings_edit(InputBytes& script, const Clip& clip) {
  ClipSettings settings = clip.settings;
  settings.up_axis = static_cast<Axis>(script.take_below(3));
  settings.position_rule = static_cast<PositionRule>(script.take_below(size_of(kPositionRuleIds)));
  settings.metres_per_unit = take_number(script);
  settings.names_in = kCharacterSets[idx(script.take_below(size_of(kCharacterSets)))];
  return make_settings_edit(clip, settings);
}

Edit take_curve_edit(InputBytes& script, const Clip& clip) {
  const SampleSelection selection = take_selection(script, clip);
  switch (script.take_below(4)) {
    case 0: {
      const double delta = take_number(script);
      return make_move_edit(clip, selection, delta, {take_number(script)});
    }
    case 1: return make_value_edit(clip, selection, take_number(script));
    case 2: return make_scale_edit(clip, selection, take_number(script), compute_selection_mean(clip, selection));
    default: return make_smooth_edit(clip, selection, take_number(script));
  }
}

Edit take_offset_edit(InputBytes& script, const Clip& clip) {
  const NodeIndex node = script.take_near(clip.skeleton.node_count());
  const double x = take_number(script);
  return make_offset_edit(clip, node, {x, 1.0, take_number(script)});
}

}  // namespace

Edit take_edit(InputBytes& script, const Clip& clip) {
  const int frame_count = clip.motion.frame_count();
  switch (script.take_below(9)) {
    case 0: return take_samples_edit(script, clip);
    case 1: return take_offset_edit(script, clip);
    case 2: return take_settings_edit(script, clip);
    case 3: return make_frame_time_edit(take_number(script));
    case 4: return take_frames_edit(script, clip);
    case 5: {
      const FrameIndex first = script.take_near(frame_count);
      return make_remove_frames_edit({first, script.take_below(4)});
    }
    case 6: {
      const ChannelIndex channel = script.take_near(clip.motion.channel_count());
      const FrameIndex frame = script.take_near(frame_count);
      return make_sample_edit(clip, channel, frame, take_number(script));
    }
    default: return take_curve_edit(script, clip);
  }
}

}  // namespace marey::test
