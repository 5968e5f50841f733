#include "wasm/views/operations/operation_target_choice.h"

#include <fmt/format.h>

#include <array>

#include "core/base/counted.h"
#include "wasm/app/widgets.h"
#include "wasm/views/inspector/property_row.h"

namespace marey::app {

TargetKind narrowest_target(const Session& session) {
  if (!session.selection.samples().empty()) return TargetKind::Samples;
  return session.selection.joints().empty() ? TargetKind::Clip : TargetKind::Shown;
}

OperationTarget make_target(const Session& session, TargetKind kind) {
  const Clip& clip = session.document.clip();
  if (kind == TargetKind::Clip) return whole_clip(clip);
  if (kind == TargetKind::Shown) {
    return target_of(clip, session.selection.shown_channels(clip.skeleton), session.playback.range());
  }
  std::vector<ChannelIndex> channels;
  FrameRange frames;
  for (const SampleRun& run : session.selection.samples().runs()) {
    channels.push_back(run.channel);
    frames = hull(frames, run.frames);
  }
  return target_of(clip, std::move(channels), frames);
}

std::string describe(const OperationTarget& target) {
  const std::string channels = counted(size_of(target.channels), "channel");
  if (target.frames.count == 0) return channels;
  if (target.frames.count == 1) return fmt::format("{}, frame {}", channels, target.frames.first + 1);
  return fmt::format("{}, frames {} to {}", channels, target.frames.first + 1, target.frames.end());
}

bool draw_target_choice(ViewContext& context, TargetKind& kind) {
  static const std::array<ui::ChoiceOption, 3> kOptions = {
      ui::ChoiceOption{"operation.target.samples", "Selected samples"},
      ui::ChoiceOption{"operation.target.shown", "Shown curves"}, ui::ChoiceOption{"operation.target.clip", "Whole clip"}};
  const float width = inspector::begin_row(context, "On");
  int chosen = static_cast<int>(kind);
  const bool changed = ui::choice(context, "operation.target", "On",
                                  "What the operation works on. Shown curves: those of the selected joints, within the range.",
                                  kOptions, chosen, width);
  kind = static_cast<TargetKind>(chosen);
  inspector::end_row();
  return changed;
}

}  // namespace marey::app
