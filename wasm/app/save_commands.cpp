#include <fmt/format.h>

#include "wasm/app/builtin_commands.h"
#include "wasm/app/command_args.h"
#include "wasm/app/icons.h"
#include "wasm/app/save_as.h"
#include "wasm/app/widgets.h"

namespace marey::app {
namespace {

using nlohmann::json;

json download(Workspace& workspace, const SaveAs& wanted) {
  Document& document = workspace.session.document;
  const std::string name = copy_name(document, wanted);
  const Result<Copy> copy = make_copy(document, wanted);
  if (!copy) return command_error(copy.error().message);
  workspace.backend.download(name, copy->bytes);
  if (is_whole(wanted)) document.mark_saved();
  workspace.notify("Downloaded " + ui::displayable(name) + ".");
  return {{"name", ui::displayable(name)}, {"bytes", copy->bytes.size()}, {"notes", copy->differences}};
}

/// {"form", "target", "decimals", "lineEnds", "first", "count"}.
json read_wanted(const Workspace& workspace, const json& args, SaveAs& wanted) {
  CommandArgs read(args);
  const std::string form = read.text("form", "bvh");
  const std::string target = read.text("target", "");
  const std::string line_ends = read.text("lineEnds", "");
  if (read.has("decimals")) wanted.options.decimals = read.whole("decimals", 6, 0, kMostSavedDecimals);
  const int frame_count = workspace.session.document.motion().frame_count();
  const bool wants_part = read.has("first") || read.has("count");
  if (wants_part && frame_count == 0) return command_error(needs_frames(workspace));
  if (wants_part) {
    const int first = read.whole("first", 0, 0, frame_count - 1);
    wanted.options.frames = {first, read.whole("count", frame_count - first, 1, frame_count - first)};
  }
  if (read.failed()) return read.error();
  if (form != "bvh" && form != "channels" && form != "positions") {
    return command_error("\"form\" is \"bvh\", \"channels\" or \"positions\".");
  }
  wanted.form = form == "bvh" ? SavedForm::Bvh : form == "channels" ? SavedForm::ChannelTable : SavedForm::PositionTable;
  if (!target.empty() && !(wanted.target = find_export_target(target))) {
    return command_error(fmt::format("There is no target \"{}\".", target));
  }
  if (!line_ends.empty() && line_ends != "lf" && line_ends != "crlf") return command_error("\"lineEnds\" is \"lf\" or \"crlf\".");
  if (!line_ends.empty()) wanted.options.line_end = line_ends == "lf" ? LineEnd::Lf : LineEnd::CrLf;
  return nullptr;
}

}  // namespace

void add_save_commands(CommandRegistry& registry, Workspace& workspace) {
  registry.add({.id = "file.save",
                .label = "Download",
                .help = "Saves the clip as a BVH file. What was not edited comes out unchanged.",
                .shortcut = "Ctrl+S",
                .icon = icons::kDownload,
                .run = [&workspace](const json&) { return download(workspace, {}); },
                .blocked = [&workspace] { return needs_whole_clip(workspace); }});
  registry.add({.id = "file.save_as",
                .label = "Download as…",
                .help = "Saves a copy for another program, as a table, with fewer decimals, or some of the frames.",
                .shortcut = "Ctrl+Shift+S",
                .icon = icons::kDownload,
                .run = [&workspace](const json& args) -> json {
                  if (args.is_null()) {
                    workspace.overlay = Overlay::SaveAs;
                    return nullptr;
                  }
                  SaveAs wanted;
                  json problem = read_wanted(workspace, args, wanted);
                  return problem.is_null() ? download(workspace, wanted) : problem;
                },
                .blocked = [&workspace] { return needs_whole_clip(workspace); }});
}

}  // namespace marey::app
