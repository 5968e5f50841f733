#include <algorithm>

#include "core/editing/contact_edits.h"
#include "wasm/app/builtin_commands.h"
#include "wasm/app/command_args.h"
#include "wasm/views/analysis/contact_strip.h"

namespace marey::app {
namespace {

using nlohmann::json;

Reason without_points(const Workspace& workspace) {
  if (Reason reason = needs_whole_clip(workspace); *reason != '\0') return reason;
  if (Reason reason = needs_frames(workspace); *reason != '\0') return reason;
  const SupportKind support = workspace.analysis.support;
  if (support != SupportKind::Ground && support != SupportKind::Auto) return "The body does not stand on the ground: see Body, Support.";
  return workspace.session.selection.joints().empty() ? "Select a joint first." : "";
}

/// {"first": 10, "count": 5}; usually contact_frames(). Of the points at the selected joints and beneath them.
json correct_contacts(Workspace& workspace, const json& args, std::optional<bool> touches) {
  const Clip& clip = workspace.session.document.clip();
  const int frame_count = clip.motion.frame_count();
  const FrameRange usual = contact_frames(workspace.session);
  CommandArgs read(args);
  const int first = read.whole("first", usual.first, 0, frame_count - 1);
  const int count = read.whole("count", read.has("first") ? 1 : std::min(usual.count, frame_count - first), 1, frame_count - first);
  if (read.failed()) return read.error();
  std::vector<NodeIndex> nodes;
  for (const JointIndex joint : workspace.session.selection.joints()) {
    const std::vector<NodeIndex> points = find_contact_nodes(clip.skeleton, clip.skeleton.node_of(joint));
    nodes.insert(nodes.end(), points.begin(), points.end());
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  const Status status = workspace.session.apply(make_contact_edit(clip, nodes, {first, count}, touches));
  if (!status) return command_error(status.error().message);
  return {{"points", nodes.size()}, {"first", first}, {"count", count}};
}

const MotionEvent* find_event(const Workspace& workspace, bool ahead) {
  if (!workspace.analysis.is_of(workspace.clip_serial, workspace.session.document.revision())) return nullptr;
  const FrameIndex here = workspace.session.playback.frame();
  const MotionEvent* found = nullptr;
  for (const MotionEvent& event : workspace.analysis.events()) {
    if (ahead && event.frame > here) return &event;
    if (!ahead && event.frame < here) found = &event;
  }
  return found;
}

void add_event_command(CommandRegistry& registry, Workspace& workspace, Command command, bool ahead) {
  command.run = [&workspace, ahead](const json&) -> json {
    const MotionEvent* event = find_event(workspace, ahead);
    workspace.session.playback.set_position(event->frame);
    return {{"frame", event->frame}, {"event", describe(*event, workspace.session.document.skeleton())}};
  };
  command.blocked = [&workspace, ahead] {
    return find_event(workspace, ahead) != nullptr ? "" : "No event there. Show a plot of forces or torques first.";
  };
  registry.add(std::move(command));
}

}  // namespace

FrameRange contact_frames(const Session& session) {
  FrameRange frames;
  for (const SampleRun& run : session.selection.samples().runs()) frames = hull(frames, run.frames);
  if (frames.count > 0) return frames;
  const FrameRange range = session.playback.range();
  return range.count < session.document.motion().frame_count() ? range : FrameRange{session.playback.frame(), 1};
}

void add_contact_commands(CommandRegistry& registry, Workspace& workspace) {
  const auto add = [&](Command command, std::optional<bool> touches) {
    command.run = [&workspace, touches](const json& args) { return correct_contacts(workspace, args, touches); };
    command.blocked = [&workspace] { return without_points(workspace); };
    registry.add(std::move(command));
  };
  add({.id = "analysis.contact_on", .label = "Contact",
       .help = "What hangs on the selected joints touches the floor: in the selected samples, else the range, else this frame."}, true);
  add({.id = "analysis.contact_off", .label = "No contact",
       .help = "What hangs on the selected joints does not touch the floor: in the selected samples, else the range, else this frame."}, false);
  add({.id = "analysis.contact_auto", .label = "Contacts as detected",
       .help = "Forgets what was said of contacts of the selected joints: in the selected samples, else the range, else this frame."},
      std::nullopt);
  add_event_command(registry, workspace, {.id = "analysis.next_event", .label = "Next event", .help = "Goes to when a foot next touches or leaves the ground."}, true);
  add_event_command(registry, workspace, {.id = "analysis.previous_event", .label = "Previous event", .help = "Goes to when a foot last touched or left the ground."}, false);
}

}  // namespace marey::app
