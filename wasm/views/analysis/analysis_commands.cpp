#include <fmt/format.h>

#include <algorithm>

#include "core/biomechanics/body_model_json.h"
#include "wasm/app/builtin_commands.h"
#include "wasm/app/command_args.h"
#include "wasm/app/icons.h"
#include "wasm/app/widgets.h"
#include "wasm/views/analysis/plot_svg.h"
#include "wasm/views/analysis/plots_view.h"

namespace marey::app {
namespace {

using nlohmann::json;

constexpr float kPlotsShare = 0.56f;
constexpr int kPrintPixels = 2126;  // 180 mm at 300 dots an inch

Reason without_plots(const Workspace& workspace) {
  if (Reason reason = needs_whole_clip(workspace); *reason != '\0') return reason;
  if (Reason reason = needs_frames(workspace); *reason != '\0') return reason;
  return workspace.analysis.choices().empty() ? "Add a plot first." : "";
}

// The plots may be out of sight, and then they are those of an earlier moment.
const std::string& bring_up_to_date(Workspace& workspace) {
  Analysis& analysis = workspace.analysis;
  analysis.follow(workspace.session, workspace.clip_serial, true, workspace.preferences.options.shown_arrows, false);
  analysis.follow_body(workspace.session, workspace.clip_serial);
  return analysis.problem();
}

// "walk-plots.csv" beside "walk.bvh".
std::string companion_name(const Workspace& workspace, const char* ending) {
  const std::string name = download_name(workspace.session.document.file_name());
  return fmt::format("{}-{}", name.substr(0, name.size() - 4), ending);
}

json tell_download(Workspace& workspace, const std::string& name, std::size_t bytes) {
  workspace.notify("Downloaded " + ui::displayable(name) + ".");
  return {{"name", ui::displayable(name)}, {"bytes", bytes}};
}

json save_csv(Workspace& workspace) {
  const std::string text = write_plots_csv(workspace.session, workspace.analysis, workspace.session.document.save_text());
  const std::string name = companion_name(workspace, "plots.csv");
  workspace.backend.download(name, text);
  return tell_download(workspace, name, text.size());
}

json save_svg(Workspace& workspace) {
  const std::string text = write_plots_svg(workspace.session, workspace.analysis);
  const std::string name = companion_name(workspace, "plots.svg");
  workspace.backend.download(name, text);
  return tell_download(workspace, name, text.size());
}

json save_png(Workspace& workspace) {
  const std::string text = write_plots_svg(workspace.session, workspace.analysis);
  const std::string name = companion_name(workspace, "plots.png");
  workspace.backend.download_picture(name, text, kPrintPixels);
  workspace.notify("Painting " + ui::displayable(name) + ".");
  return {{"name", ui::displayable(name)}};
}

void add_downloads(CommandRegistry& registry, Workspace& workspace) {
  const auto add = [&](Command command, json (*save)(Workspace&)) {
    command.run = [&workspace, save](const json&) {
      const std::string& problem = bring_up_to_date(workspace);
      return problem.empty() ? save(workspace) : command_error(problem);
    };
    command.blocked = [&workspace] { return without_plots(workspace); };
    registry.add(std::move(command));
  };
  add({.id = "analysis.save_csv", .label = "Plots as a table", .help = "Downloads the plotted numbers, SI, as CSV with units, filter and file hash.",
       .icon = icons::kTable}, save_csv);
  add({.id = "analysis.save_svg", .label = "Plots as SVG", .help = "Downloads the plots as a drawing for print, 180 mm wide.",
       .icon = icons::kFileDown}, save_svg);
  add({.id = "analysis.save_png", .label = "Plots as PNG", .help = "Downloads the plots as a picture for print, 300 dots an inch.",
       .icon = icons::kImage}, save_png);
}

json save_model(Workspace& workspace) {
  Analysis& analysis = workspace.analysis;
  analysis.follow_body(workspace.session, workspace.clip_serial);
  if (analysis.body() == nullptr) return command_error(analysis.body_problem());
  const Result<std::string> text = write_body_model(analysis.body()->body.model, workspace.session.document.skeleton());
  if (!text) return command_error(text.error().message);
  const std::string name = companion_name(workspace, "body.json");
  workspace.backend.download(name, *text);
  return tell_download(workspace, name, text->size());
}

void add_model_commands(CommandRegistry& registry, Workspace& workspace) {
  registry.add({.id = "analysis.open_model",
                .label = "Open model…",
                .help = "Reads masses, centres and inertias of the segments from a JSON file, which \"Save model\" and marey analyse write.",
                .icon = icons::kFolderOpen,
                .run = [&workspace](const json&) -> json {
                  workspace.backend.ask_for_file(FileUse::BodyModel);
                  return nullptr;
                },
                .blocked = [&workspace] { return needs_whole_clip(workspace); }});
  registry.add({.id = "analysis.save_model",
                .label = "Save model",
                .help = "Downloads masses, centres and inertias of the segments as JSON.",
                .icon = icons::kFileDown,
                .run = [&workspace](const json&) { return save_model(workspace); },
                .blocked = [&workspace] { return needs_whole_clip(workspace); }});
}

json show_plots(Workspace& workspace) {
  Preferences& preferences = workspace.preferences;
  preferences.options.curves_page = CurvesPage::Plots;
  preferences.options.show_curves = true;
  preferences.sheet = Sheet::Curves;
  return nullptr;
}

// The figure above, and below it angle, velocity, acceleration and torque of the selected joint under one cursor.
json show_layout(Workspace& workspace) {
  show_plots(workspace);
  workspace.analysis.set_choices(Analysis::usual_choices());
  ViewOptions& options = workspace.preferences.options;
  options.plot_mode = PlotMode::OverTime;
  workspace.preferences.sizes.curves_height = std::round(kPlotsShare * ImGui::GetIO().DisplaySize.y);
  return nullptr;
}

// "torque:Body", "position:Hand+0/0.1/0@Hips"; without a joint, "angle" or "angle@world", that of the active one.
std::optional<PlotChoice> read_choice(const Skeleton& skeleton, const std::string& text) {
  const std::size_t end = text.find_first_of(":@");
  const Quantity* quantity = find_quantity(std::string_view(text).substr(0, end));
  if (quantity == nullptr) return std::nullopt;
  const auto asked = find_quantities(skeleton, std::span(&text, 1));
  if (asked && asked->size() == 1) {
    const AskedQuantity& one = asked->front();
    const std::size_t at = one.frame ? text.rfind('@') : std::string::npos;
    return PlotChoice{quantity, one.node == kNoParent ? std::string() : node_label(skeleton, one.node),
                      at == std::string::npos ? std::string() : text.substr(at + 1), one.point_m};
  }
  if (end == std::string::npos) return PlotChoice{quantity};
  if (text[end] == '@') return PlotChoice{quantity, {}, text.substr(end + 1)};
  return PlotChoice{quantity, text.substr(end + 1)};
}

/// {"quantities": ["torque:Body", "angle", "com"]}.
json set_plots(Workspace& workspace, const json& args) {
  if (!args.is_object() || !args.contains("quantities") || !args["quantities"].is_array()) {
    return command_error("Give the plots as {\"quantities\": [\"torque:Body\", \"angle\", \"com\"]}.");
  }
  std::vector<PlotChoice> choices;
  for (const json& text : args["quantities"]) {
    if (!text.is_string()) return command_error("Every quantity is a text.");
    const std::optional<PlotChoice> choice = read_choice(workspace.session.document.skeleton(), text.get<std::string>());
    if (!choice) return command_error(fmt::format("\"{}\" is not a quantity.", text.get<std::string>()));
    choices.push_back(*choice);
  }
  workspace.analysis.set_choices(std::move(choices));
  return show_plots(workspace);
}

/// {"derivative": "butterworth:6", "support": "pivot", "raw": true, "bands": true}.
json set_method(Workspace& workspace, const json& args) {
  Analysis& analysis = workspace.analysis;
  CommandArgs read(args);
  const std::string derivative = read.text("derivative", describe(analysis.derivation));
  const std::string support = read.text("support", "");
  const bool raw = read.boolean("raw", analysis.shows_raw);
  const bool bands = read.boolean("bands", analysis.shows_bands);
  if (read.failed()) return read.error();
  const Result<Derivation> derivation = parse_derivation(derivative);
  if (!derivation) return command_error(derivation.error().message);
  const SupportKind* kind = support.empty() ? &analysis.support : find_support_kind(support);
  if (kind == nullptr) return command_error("\"support\" is \"pivot\", \"flight\", \"ground\" or \"auto\".");
  analysis.derivation = *derivation;
  analysis.support = *kind;
  analysis.shows_raw = raw;
  analysis.shows_bands = bands;
  return {{"derivative", describe(*derivation)}, {"raw", raw}, {"bands", bands}};
}

void add_arrow_switches(CommandRegistry& registry, Workspace& workspace) {
  ShownArrows& shown = workspace.preferences.options.shown_arrows;
  const auto add = [&](Command command, bool& value) {
    command.blocked = [&workspace] { return needs_frames(workspace); };
    add_switch(registry, std::move(command), value);
  };
  const auto arrow = [&](BodyArrow kind) -> bool& { return shown.arrows[static_cast<int>(kind)]; };
  add({.id = "view.com", .label = "Centre of mass", .help = "Draws the centre of mass, its path and its place on the ground.",
       .icon = icons::kTarget}, shown.com);
  add({.id = "view.solids", .label = "Segments as solids", .help = "Draws each segment as the ellipsoid of even density with its mass and inertia."},
      workspace.preferences.options.show_solids);
  add({.id = "view.arrows.velocity", .label = "Velocity arrows", .help = "Draws the velocities of the selected joints, or of all."},
      arrow(BodyArrow::Velocity));
  add({.id = "view.arrows.acceleration", .label = "Acceleration arrows", .help = "Draws the accelerations of the selected joints, or of all."},
      arrow(BodyArrow::Acceleration));
  add({.id = "view.arrows.force", .label = "Joint force arrows", .help = "Draws the forces on the selected joints, or on all, from their parents."},
      arrow(BodyArrow::Force));
  add({.id = "view.arrows.torque", .label = "Joint torque arrows", .help = "Draws the torques on the selected joints, or on all, from their parents."},
      arrow(BodyArrow::Torque));
  add({.id = "view.arrows.angular_momentum", .label = "Angular momentum arrow", .help = "Draws the angular momentum about the centre of mass."},
      arrow(BodyArrow::AngularMomentum));
  add({.id = "view.arrows.reaction", .label = "Support reaction arrow", .help = "Draws the force of the ground or of the bar on the body."},
      arrow(BodyArrow::Reaction));
}

}  // namespace

void add_analysis_commands(CommandRegistry& registry, Workspace& workspace) {
  registry.add({.id = "analysis.layout",
                .label = "Analysis layout",
                .help = "Shows the figure with angle, velocity, acceleration and torque of the selected joint under one cursor.",
                .shortcut = "Shift+M",
                .icon = icons::kChartNoAxesCombined,
                .run = [&workspace](const json&) { return show_layout(workspace); },
                .blocked = [&workspace] { return needs_frames(workspace); }});
  registry.add({.id = "analysis.plots",
                .label = "Plot quantities",
                .help = "Plots the quantities of a list.",
                .run = [&workspace](const json& args) { return set_plots(workspace, args); },
                .blocked = [&workspace] { return needs_frames(workspace); },
                .in_palette = false});
  registry.add({.id = "analysis.method",
                .label = "Set the method",
                .help = "Sets how derivatives are made and what holds the body.",
                .run = [&workspace](const json& args) { return set_method(workspace, args); },
                .in_palette = false});
  add_downloads(registry, workspace);
  add_model_commands(registry, workspace);
  add_arrow_switches(registry, workspace);
  add_contact_commands(registry, workspace);
}

}  // namespace marey::app
