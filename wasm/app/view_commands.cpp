#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "wasm/app/builtin_commands.h"
#include "wasm/app/command_args.h"
#include "wasm/app/icons.h"

namespace marey::app {
namespace {

using nlohmann::json;

constexpr std::array kScales_percent = {100, 110, 125, 150, 175, 200, 225, 250};

void add_scene_switches(CommandRegistry& registry, ViewOptions& options) {
  add_switch(registry, {.id = "view.grid", .label = "Ground grid", .help = "Draws the ground with a grid in file units.",
                        .shortcut = "G", .icon = icons::kGrid3x3}, options.show_grid);
  add_switch(registry, {.id = "view.shadow", .label = "Shadow", .help = "Draws the figure's shadow on the ground.",
                        .icon = icons::kContrast}, options.show_shadow);
  add_switch(registry, {.id = "view.names", .label = "Joint names", .help = "Writes its name beside each joint.",
                        .shortcut = "N", .icon = icons::kTag}, options.show_names);
  add_switch(registry, {.id = "view.strobe", .label = "Strobe", .help = "Shows poses before and after, as on one plate.",
                        .shortcut = "S", .icon = icons::kLayers}, options.show_strobe);
  add_switch(registry, {.id = "view.trails", .label = "Trails",
                        .help = "Draws the paths of the selected joints, or of all ends when none is selected.",
                        .shortcut = "T", .icon = icons::kRoute}, options.show_trails);
  add_switch(registry, {.id = "view.follow_root", .label = "Follow the root", .help = "Keeps the figure in the middle.",
                        .icon = icons::kVideo}, options.follow_root);
  add_switch(registry, {.id = "view.performance", .label = "Performance",
                        .help = "Shows what drawing takes: time, draw calls, memory.", .shortcut = "Shift+T",
                        .icon = icons::kGauge}, options.show_performance);
  add_switch(registry, {.id = "view.orthographic", .label = "Orthographic", .help = "Draws without perspective.",
                        .shortcut = "5", .icon = icons::kBox}, options.orthographic);
}

// A panel is a column or row on a wide page and a sheet on a narrow one.
void add_panel(CommandRegistry& registry, Workspace& workspace, Command command, bool ViewOptions::*shown, Sheet sheet) {
  Preferences& preferences = workspace.preferences;
  command.checked = [&preferences, shown, sheet] {
    return preferences.options.compact ? preferences.sheet == sheet : preferences.options.*shown;
  };
  command.run = [&preferences, shown, sheet, is_shown = command.checked](const json& args) -> json {
    CommandArgs read(args);
    const bool show = read.boolean("on", !is_shown());
    if (read.failed()) return read.error();
    if (preferences.options.compact) {
      preferences.sheet = show ? sheet : Sheet::None;
    } else {
      preferences.options.*shown = show;
    }
    return show;
  };
  registry.add(std::move(command));
}

void add_panels(CommandRegistry& registry, Workspace& workspace) {
  add_panel(registry, workspace, {.id = "view.outliner", .label = "Joints", .help = "Shows the tree of joints.",
                                  .shortcut = "Shift+J", .icon = icons::kListTree},
            &ViewOptions::show_outliner, Sheet::Joints);
  add_panel(registry, workspace, {.id = "view.inspector", .label = "Inspector",
                                  .help = "Shows the numbers of the selected joint and of the clip.",
                                  .shortcut = "Shift+I", .icon = icons::kSlidersHorizontal},
            &ViewOptions::show_inspector, Sheet::Inspector);
  add_panel(registry, workspace, {.id = "view.curves", .label = "Curves", .help = "Shows the curve editor.",
                                  .shortcut = "Shift+C", .icon = icons::kChartSpline},
            &ViewOptions::show_curves, Sheet::Curves);
  registry.add({.id = "view.problems",
                .label = "Problems",
                .help = "Shows what was noticed while the file was read.",
                .shortcut = "Shift+P",
                .icon = icons::kTriangleAlert,
                .run = [&workspace](const json&) -> json {
                  workspace.problems_wanted = true;
                  workspace.preferences.options.show_inspector = true;
                  workspace.preferences.sheet = Sheet::Inspector;
                  return nullptr;
                }});
}

void add_theme(CommandRegistry& registry, Workspace& workspace, ThemeChoice choice, std::string label, std::string help,
               const char* icon) {
  ThemeChoice& theme = workspace.preferences.theme;
  registry.add({.id = "view.theme." + std::string(theme_choice_name(choice)),
                .label = std::move(label),
                .help = std::move(help),
                .icon = icon,
                .run = [&theme, choice](const json&) -> json {
                  theme = choice;
                  return theme_choice_name(choice);
                },
                .checked = [&theme, choice] { return theme == choice; }});
}

int scale_percent(const ViewOptions& options) { return static_cast<int>(std::lround(options.interface_scale * 100.0f)); }

json set_scale(ViewOptions& options, int percent) {
  options.interface_scale = static_cast<float>(percent) / 100.0f;
  return percent;
}

json set_scale_from(ViewOptions& options, const json& args) {
  CommandArgs read(args);
  if (!read.has("percent")) return command_error("Give the scale as {\"percent\": number} from 100 to 250.");
  const int percent = read.whole("percent", 100, kScales_percent.front(), kScales_percent.back());
  return read.failed() ? read.error() : set_scale(options, percent);
}

int larger_step(const ViewOptions& options) {
  const auto next = std::upper_bound(kScales_percent.begin(), kScales_percent.end(), scale_percent(options));
  return next == kScales_percent.end() ? kScales_percent.back() : *next;
}

int smaller_step(const ViewOptions& options) {
  const auto here = std::lower_bound(kScales_percent.begin(), kScales_percent.end(), scale_percent(options));
  return here == kScales_percent.begin() ? kScales_percent.front() : *(here - 1);
}

void add_scale(CommandRegistry& registry, ViewOptions& options) {
  registry.add({.id = "view.scale.larger",
                .label = "Larger interface",
                .help = "Draws text and controls one step larger.",
                .icon = icons::kZoomIn,
                .run = [&options](const json&) { return set_scale(options, larger_step(options)); },
                .blocked = [&options] {
                  return scale_percent(options) < kScales_percent.back() ? "" : "250 % is the largest.";
                }});
  registry.add({.id = "view.scale.smaller",
                .label = "Smaller interface",
                .help = "Draws text and controls one step smaller.",
                .icon = icons::kZoomOut,
                .run = [&options](const json&) { return set_scale(options, smaller_step(options)); },
                .blocked = [&options] {
                  return scale_percent(options) > kScales_percent.front() ? "" : "100 % is the smallest.";
                }});
  registry.add({.id = "view.scale.reset",
                .label = "Interface at 100 %",
                .help = "Draws text and controls in their usual size.",
                .icon = icons::kRotateCcw,
                .run = [&options](const json&) { return set_scale(options, 100); }});
  registry.add({.id = "view.scale",
                .label = "Interface scale",
                .help = "Sets the size of text and controls in percent.",
                .run = [&options](const json& args) { return set_scale_from(options, args); },
                .in_palette = false});
}

void add_projector(CommandRegistry& registry, ViewOptions& options) {
  registry.add({.id = "view.projector",
                .label = "Projector mode",
                .help = "For a class: larger interface, thicker curves, higher contrast.",
                .icon = icons::kPresentation,
                .run = [&options](const json& args) -> json {
                  CommandArgs read(args);
                  const bool on = read.boolean("on", !options.projector);
                  if (read.failed()) return read.error();
                  options.projector = on;
                  set_scale(options, on ? 150 : 100);
                  return on;
                },
                .checked = [&options] { return options.projector; }});
}

}  // namespace

void add_switch(CommandRegistry& registry, Command command, bool& value) {
  command.run = [&value](const json& args) -> json {
    CommandArgs read(args);
    const bool on = read.boolean("on", !value);
    if (read.failed()) return read.error();
    return value = on;
  };
  command.checked = [&value] { return value; };
  registry.add(std::move(command));
}

void add_view_commands(CommandRegistry& registry, Workspace& workspace) {
  add_panels(registry, workspace);
  add_scene_switches(registry, workspace.preferences.options);
  add_theme(registry, workspace, ThemeChoice::System, "Theme of the system", "Follows the setting of this computer.",
            icons::kSettings2);
  add_theme(registry, workspace, ThemeChoice::Light, "Light theme", "Dark text on light ground.", icons::kSun);
  add_theme(registry, workspace, ThemeChoice::Dark, "Dark theme", "Light text on dark ground.", icons::kMoon);
  add_scale(registry, workspace.preferences.options);
  add_projector(registry, workspace.preferences.options);
}

}  // namespace marey::app
