#include "wasm/app/builtin_commands.h"
#include "wasm/app/icons.h"

namespace marey::app {
namespace {

void add_overlay(CommandRegistry& registry, Workspace& workspace, Command command, Overlay overlay) {
  command.run = [&workspace, overlay](const nlohmann::json&) -> nlohmann::json {
    workspace.overlay = overlay;
    return nullptr;
  };
  registry.add(std::move(command));
}

}  // namespace

void add_help_commands(CommandRegistry& registry, Workspace& workspace) {
  add_overlay(registry, workspace,
              {.id = "help.commands",
               .label = "Search commands…",
               .help = "Finds a command by its name and runs it.",
               .shortcut = "Ctrl+K",
               .icon = icons::kSearch,
               .in_palette = false},
              Overlay::Palette);
  add_overlay(registry, workspace,
              {.id = "help.shortcuts",
               .label = "Keyboard shortcuts…",
               .help = "Lists every shortcut.",
               .shortcut = "?",
               .icon = icons::kKeyboard},
              Overlay::Shortcuts);
  add_overlay(registry, workspace,
              {.id = "help.about",
               .label = "About Marey…",
               .help = "Version, licences and what happens to your files.",
               .icon = icons::kInfo},
              Overlay::About);
}

}  // namespace marey::app
