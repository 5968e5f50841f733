#include <fmt/format.h>

#include "wasm/app/builtin_commands.h"
#include "wasm/app/command_args.h"
#include "wasm/app/icons.h"

namespace marey::app {
namespace {

using nlohmann::json;

constexpr double kLeastUnit_m = 1e-6;
constexpr double kLargestUnit_m = 1000.0;
constexpr double kLeastFrameTime_s = 1e-6;
constexpr double kLargestFrameTime_s = 3600.0;

json apply_settings(Workspace& workspace, std::string name, const ClipSettings& settings) {
  if (settings == workspace.session.document.settings()) return nullptr;
  Edit edit;
  edit.name = std::move(name);
  edit.settings = settings;
  const Status status = workspace.session.apply(std::move(edit));
  return status ? json(nullptr) : command_error(status.error().message);
}

Reason blocked_rule(const Workspace& workspace, PositionRule rule) {
  if (const Reason missing = needs_whole_clip(workspace); *missing != '\0') return missing;
  if (rule != PositionRule::PerJoint || has_joints_that_add(workspace.session.document.skeleton())) return "";
  return "The file's position channels all speak for one meaning.";
}

void add_rule(CommandRegistry& registry, Workspace& workspace, PositionRule rule, std::string id, std::string label,
              std::string help) {
  registry.add({.id = std::move(id),
                .label = label,
                .help = std::move(help),
                .icon = icons::kMove3d,
                .run = [&workspace, rule, label](const json&) {
                  ClipSettings settings = workspace.session.document.settings();
                  settings.position_rule = rule;
                  return apply_settings(workspace, label, settings);
                },
                .blocked = [&workspace, rule] { return blocked_rule(workspace, rule); },
                .checked = [&workspace, rule] {
                  return workspace.has_clip() && workspace.session.document.settings().position_rule == rule;
                }});
}

void add_up_axis(CommandRegistry& registry, Workspace& workspace, Axis axis, std::string id, std::string label,
                 std::string help) {
  registry.add({.id = std::move(id),
                .label = label,
                .help = std::move(help),
                .icon = icons::kAxis3d,
                .run = [&workspace, axis, label](const json&) {
                  ClipSettings settings = workspace.session.document.settings();
                  settings.up_axis = axis;
                  return apply_settings(workspace, label, settings);
                },
                .blocked = [&workspace] { return needs_whole_clip(workspace); },
                .checked = [&workspace, axis] {
                  return workspace.has_clip() && workspace.session.document.settings().up_axis == axis;
                }});
}

/// Why another character set would change nothing.
Reason needs_names(const Workspace& workspace) {
  if (!workspace.has_clip()) return needs_whole_clip(workspace);
  const Document& document = workspace.session.document;
  if (document.style().encoding != TextEncoding::Bytes) return "The file is UTF-16: its letters are certain.";
  return telling_names(document.skeleton(), CharacterSet::Utf8, 1).empty()
             ? "The names are plain ASCII, the same in every character set."
             : "";
}

void add_names_in(CommandRegistry& registry, Workspace& workspace, CharacterSet set) {
  const CharacterSetTraits& traits = traits_of(set);
  registry.add({.id = fmt::format("clip.names_in.{}", traits.id),
                .label = fmt::format("Names in {}", traits.label),
                .help = fmt::format("Reads the letters of all names as {} ({}). The file keeps their bytes.", traits.label, traits.script),
                .icon = icons::kLanguages,
                .run = [&workspace, set](const json&) {
                  ClipSettings settings = workspace.session.document.settings();
                  settings.names_in = set;
                  return apply_settings(workspace, fmt::format("Read names as {}", traits_of(set).label), settings);
                },
                .blocked = [&workspace] { return needs_names(workspace); },
                .checked = [&workspace, set] {
                  return workspace.has_clip() && workspace.session.document.settings().names_in == set;
                }});
}

json set_unit(Workspace& workspace, const json& args) {
  CommandArgs read(args);
  if (!read.has("metres")) return command_error("Give the length of a file unit as {\"metres\": number}.");
  const double metres = read.number("metres", 1.0, kLeastUnit_m, kLargestUnit_m);
  if (read.failed()) return read.error();
  ClipSettings settings = workspace.session.document.settings();
  settings.metres_per_unit = metres;
  return apply_settings(workspace, "Set the length of a unit", settings);
}

json set_frame_time(Workspace& workspace, const json& args) {
  CommandArgs read(args);
  if (!read.has("seconds")) return command_error("Give the frame time as {\"seconds\": number}.");
  const double seconds = read.number("seconds", 1.0, kLeastFrameTime_s, kLargestFrameTime_s);
  if (read.failed()) return read.error();
  Edit edit;
  edit.name = "Set the frame time";
  edit.frame_time_s = seconds;
  const Status status = workspace.session.apply(std::move(edit));
  return status ? json(nullptr) : command_error(status.error().message);
}

}  // namespace

void add_clip_commands(CommandRegistry& registry, Workspace& workspace) {
  add_rule(registry, workspace, PositionRule::Replace, "clip.positions.replace", "Positions replace the offset",
           "A position channel is the joint's place in its parent's frame, as Blender reads it.");
  add_rule(registry, workspace, PositionRule::Add, "clip.positions.add", "Positions add to the offset",
           "A position channel is added to the joint's offset, as three.js reads it.");
  add_rule(registry, workspace, PositionRule::PerJoint, "clip.positions.per_joint", "Positions add where they rest at 0",
           "Joints whose position channels are all 0 in the file keep their offset; the others' channels replace it.");
  add_up_axis(registry, workspace, Axis::Y, "clip.up_axis.y", "Y is up", "The figure stands along the Y axis.");
  add_up_axis(registry, workspace, Axis::Z, "clip.up_axis.z", "Z is up", "The figure stands along the Z axis.");
  for (const CharacterSet set : kCharacterSets) add_names_in(registry, workspace, set);
  registry.add({.id = "clip.unit",
                .label = "Length of a unit",
                .help = "Sets how many metres a file unit is.",
                .run = [&workspace](const json& args) { return set_unit(workspace, args); },
                .blocked = [&workspace] { return needs_whole_clip(workspace); },
                .in_palette = false});
  registry.add({.id = "clip.frame_time",
                .label = "Frame time",
                .help = "Sets the seconds per frame.",
                .run = [&workspace](const json& args) { return set_frame_time(workspace, args); },
                .blocked = [&workspace] { return workspace.has_frames() ? needs_whole_clip(workspace) : needs_frames(workspace); },
                .in_palette = false});
}

}  // namespace marey::app
