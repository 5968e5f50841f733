#include "wasm/app/builtin_commands.h"
#include "wasm/app/icons.h"
#include "wasm/app/samples.h"
#include "wasm/app/widgets.h"

namespace marey::app {
namespace {

using nlohmann::json;

Command make_sample_command(const Sample& sample, Workspace& workspace) {
  Command command;
  command.id = "file.sample." + std::string(sample.id);
  command.label = "Open sample: " + std::string(sample.title);
  command.help = std::string(sample.summary) + ".";
  command.icon = icons::kShapes;
  command.run = [&workspace, id = sample.id](const json&) -> json {
    workspace.overlay = Overlay::None;
    workspace.preferences.welcome_seen = true;
    workspace.backend.load_sample(id);
    return nullptr;
  };
  return command;
}

Command make_stop_command(Workspace& workspace) {
  return {.id = "file.cancel_loading",
          .label = "Stop reading the file",
          .help = "Gives up the file that is being read. What was open before comes back.",
          .icon = icons::kX,
          .run = [&workspace](const json&) -> json {
            const std::string name = ui::displayable(workspace.loading->file_name());
            workspace.cancel_loading();
            workspace.notify("Reading " + name + " was stopped.");
            return nullptr;
          },
          .blocked = [&workspace] { return workspace.loading ? "" : "No file is being read."; }};
}

void add_opening_commands(CommandRegistry& registry, Workspace& workspace) {
  registry.add({.id = "file.open",
                .label = "Open…",
                .help = "Opens a BVH file, a CSV table, or a model of the body in JSON from this computer. Dropping it anywhere on the page does the same.",
                .shortcut = "Ctrl+O",
                .icon = icons::kFolderOpen,
                .run = [&workspace](const json&) -> json {
                  workspace.backend.ask_for_file();
                  return nullptr;
                }});
  registry.add({.id = "file.open_other",
                .label = "Choose another clip…",
                .help = "Reads a clip that plots show beside the open one, and that operations can join to it.",
                .icon = icons::kFolderOpen,
                .run = [&workspace](const json&) -> json {
                  workspace.backend.ask_for_file(FileUse::OtherClip);
                  return nullptr;
                },
                .blocked = [&workspace] { return needs_whole_clip(workspace); }});
}

}  // namespace

std::string download_name(std::string_view file_name) {
  const std::size_t dot = file_name.rfind('.');
  const std::string_view stem = file_name.substr(0, dot == 0 ? std::string_view::npos : dot);
  return (stem.empty() ? std::string("clip") : std::string(stem)) + ".bvh";
}

Reason needs_clip(const Workspace& workspace) { return workspace.has_clip() ? "" : "Open a file first."; }

Reason needs_whole_clip(const Workspace& workspace) {
  return workspace.session.is_partial ? "The file is still being read." : needs_clip(workspace);
}

Reason needs_frames(const Workspace& workspace) {
  if (!workspace.has_clip()) return needs_clip(workspace);
  return workspace.has_frames() ? "" : "This clip has no frames.";
}

void add_file_commands(CommandRegistry& registry, Workspace& workspace) {
  add_opening_commands(registry, workspace);
  registry.add(make_stop_command(workspace));
  add_save_commands(registry, workspace);
  registry.add({.id = "file.previous",
                .label = "Go back to the other file",
                .help = "Shows the file again that was open before, with the changes that were not downloaded.",
                .icon = icons::kUndo2,
                .run = [&workspace](const json&) -> json {
                  workspace.go_back();
                  workspace.notify("This is " + ui::displayable(workspace.session.document.file_name()) + " again.");
                  return nullptr;
                },
                .blocked = [&workspace] { return workspace.previous ? "" : "No other file has unsaved changes."; }});
  registry.add({.id = "file.samples",
                .label = "Samples…",
                .help = "Shows the clips that come with Marey.",
                .icon = icons::kShapes,
                .run = [&workspace](const json&) -> json {
                  workspace.overlay = Overlay::Welcome;
                  return nullptr;
                }});
  for (const Sample& sample : kSamples) registry.add(make_sample_command(sample, workspace));
}

}  // namespace marey::app
