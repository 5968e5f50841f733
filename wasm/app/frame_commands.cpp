#include <algorithm>

#include "core/editing/clip_operations.h"
#include "wasm/app/builtin_commands.h"
#include "wasm/app/command_args.h"

namespace marey::app {
namespace {

using nlohmann::json;

json apply_removal(Workspace& workspace, FrameRange frames, std::string name) {
  Edit edit = make_remove_frames_edit(frames);
  if (!name.empty()) edit.name = std::move(name);
  const Status status = workspace.session.apply(std::move(edit));
  return status ? json(nullptr) : command_error(status.error().message);
}

json remove_frames(Workspace& workspace, const json& args) {
  CommandArgs read(args);
  const int frame_count = workspace.session.document.motion().frame_count();
  const int first = read.whole("first", 0, 0, frame_count - 1);
  const int count = read.whole("count", 1, 1, frame_count);
  if (!read.has("first") || !read.has("count")) {
    return command_error("Give the frames to leave out as {\"first\": number, \"count\": number}.");
  }
  return read.failed() ? read.error() : apply_removal(workspace, {first, count}, {});
}

/// Whether undoing the newest step brings back a frame of the opened file from `first` on.
bool undo_restores(const Document& document, FrameIndex first, bool and_later) {
  const Edit* edit = document.history().undo_edit();
  if (edit == nullptr || !edit->frames || edit->frames->file_frames.empty()) return false;
  const FrameIndex restored = edit->frames->file_frames.front();
  return restored == first || (and_later && restored > first);
}

/// First frame of the clip that the file does not declare; the frame count if there is none.
FrameIndex first_undeclared(const Document& document) {
  const std::vector<FrameIndex>& frames = document.clip().file_frames;
  const int frame_count = document.motion().frame_count();
  if (frames.empty()) return std::min(document.declared_frames(), frame_count);
  // Not sorted where frames were put in.
  const auto beyond = [&](FrameIndex frame) { return frame >= document.declared_frames(); };
  return static_cast<FrameIndex>(std::find_if(frames.begin(), frames.end(), beyond) - frames.begin());
}

bool keeps_declared_only(const Document& document) {
  return document.declared_frames() > 0 && first_undeclared(document) == document.motion().frame_count();
}

/// Two commands of which one takes frames away and the other, right afterwards, undoes it.
struct FrameChoice {
  Command keep;
  Command leave_out;
  std::function<bool()> is_left_out;
  std::function<bool()> can_undo;
  std::function<FrameRange()> frames;
  std::function<Reason()> missing;  ///< why there is nothing to leave out
};

void add_frame_choice(CommandRegistry& registry, Workspace& workspace, FrameChoice choice) {
  choice.keep.run = [&workspace](const json&) -> json {
    workspace.session.undo();
    return nullptr;
  };
  choice.keep.checked = [is_left_out = choice.is_left_out] { return !is_left_out(); };
  choice.keep.blocked = [is_left_out = choice.is_left_out, can_undo = choice.can_undo]() -> Reason {
    if (!is_left_out()) return "The frames are there.";
    return can_undo() ? "" : "Undo later changes first; undoing brings the frames back.";
  };
  choice.keep.in_palette = false;
  choice.leave_out.run = [&workspace, frames = choice.frames, name = choice.leave_out.label](const json&) {
    return apply_removal(workspace, frames(), name);
  };
  choice.leave_out.checked = choice.is_left_out;
  choice.leave_out.blocked = [&workspace, missing = choice.missing, is_left_out = choice.is_left_out]() -> Reason {
    if (!workspace.has_frames()) return needs_frames(workspace);
    if (workspace.session.is_partial) return needs_whole_clip(workspace);
    return is_left_out() ? "It is left out already." : missing();
  };
  registry.add(std::move(choice.keep));
  registry.add(std::move(choice.leave_out));
}

void add_frame_choices(CommandRegistry& registry, Workspace& workspace) {
  const auto document = [&workspace]() -> const Document& { return workspace.session.document; };
  FrameChoice first;
  first.keep = {.id = "clip.first_frame.keep", .label = "Keep frame 1", .help = "The first frame is part of the movement."};
  first.leave_out = {.id = "clip.first_frame.leave_out",
                     .label = "Leave out frame 1",
                     .help = "Takes the first frame away, which in many files is a reference pose."};
  first.is_left_out = [document] { return is_first_frame_left_out(document()); };
  first.can_undo = [document] { return undo_restores(document(), 0, false); };
  first.frames = [] { return FrameRange{0, 1}; };
  first.missing = [document] { return document().motion().frame_count() > 1 ? "" : "A clip keeps one frame at least."; };
  add_frame_choice(registry, workspace, std::move(first));

  FrameChoice declared;
  declared.keep = {.id = "clip.frames.all", .label = "Keep all frames", .help = "The frames beyond the declared count stay."};
  declared.leave_out = {.id = "clip.frames.declared",
                        .label = "As declared",
                        .help = "Takes away the frames beyond the count that the file declares."};
  declared.is_left_out = [document] { return keeps_declared_only(document()); };
  declared.can_undo = [document] { return undo_restores(document(), document().declared_frames(), true); };
  declared.frames = [document] {
    const FrameIndex begin = first_undeclared(document());
    return FrameRange{begin, document().motion().frame_count() - begin};
  };
  declared.missing = [document] { return document().declared_frames() > 0 ? "" : "The file holds as many frames as it declares."; };
  add_frame_choice(registry, workspace, std::move(declared));
}

}  // namespace

bool is_first_frame_left_out(const Document& document) {
  const std::vector<FrameIndex>& frames = document.clip().file_frames;
  return !frames.empty() && frames.front() > 0;
}

void add_frame_commands(CommandRegistry& registry, Workspace& workspace) {
  registry.add({.id = "clip.remove_frames",
                .label = "Leave out frames",
                .help = "Takes frames out of the clip; those behind them move up.",
                .run = [&workspace](const json& args) { return remove_frames(workspace, args); },
                .blocked = [&workspace] { return workspace.has_frames() ? needs_whole_clip(workspace) : needs_frames(workspace); },
                .in_palette = false});
  add_frame_choices(registry, workspace);
}

}  // namespace marey::app
