#include <fmt/format.h>

#include <cctype>
#include <numeric>
#include <vector>

#include "wasm/app/builtin_commands.h"
#include "wasm/app/command_args.h"
#include "wasm/app/icons.h"
#include "wasm/app/widgets.h"

namespace marey::app {
namespace {

using nlohmann::json;

// "Undo" and "Move 12 samples" read as "Undo: move 12 samples".
SmallText with_step(std::string_view verb, std::string_view step) {
  if (step.empty()) return SmallText("{}", verb);
  const auto first = static_cast<char>(std::tolower(static_cast<unsigned char>(step[0])));
  return SmallText("{}: {}{}", verb, first, step.substr(1));
}

json take_step(Workspace& workspace, bool undo) {
  const History& history = workspace.session.document.history();
  const std::string name(undo ? history.undo_name() : history.redo_name());
  undo ? workspace.session.undo() : workspace.session.redo();
  workspace.notify(fmt::format("{}.", with_step(undo ? "Undone" : "Redone", name).view()));
  return name;
}

void add_history_commands(CommandRegistry& registry, Workspace& workspace) {
  const auto history = [&workspace]() -> const History& { return workspace.session.document.history(); };
  registry.add({.id = "edit.undo",
                .label = "Undo",
                .help = "Takes the last change of the clip back.",
                .shortcut = "Ctrl+Z",
                .icon = icons::kUndo2,
                .run = [&workspace](const json&) { return take_step(workspace, true); },
                .blocked = [history] { return history().undo_depth() > 0 ? "" : "There is nothing to undo."; },
                .live_label = [history] { return with_step("Undo", history().undo_name()); }});
  registry.add({.id = "edit.redo",
                .label = "Redo",
                .help = "Makes the change again that was last undone.",
                .shortcut = "Ctrl+Shift+Z, Ctrl+Y",
                .icon = icons::kRedo2,
                .run = [&workspace](const json&) { return take_step(workspace, false); },
                .blocked = [history] { return history().redo_depth() > 0 ? "" : "There is nothing to redo."; },
                .live_label = [history] { return with_step("Redo", history().redo_name()); }});
}

JointIndex first_child(const Skeleton& skeleton, JointIndex joint) {
  return joint + 1 < skeleton.subtree_end(joint) ? joint + 1 : kNoParent;
}

Reason needs_joint(const Workspace& workspace) {
  return workspace.session.selection.active_joint() == kNoParent ? "Select a joint first." : "";
}

json select_joint(Workspace& workspace, const json& args) {
  const Skeleton& skeleton = workspace.session.document.skeleton();
  CommandArgs read(args);
  if (!read.has("joint")) return command_error("Give the joint as {\"joint\": number}, counted from 0.");
  const JointIndex joint = read.whole("joint", 0, 0, skeleton.joint_count() - 1);
  const bool add = read.boolean("add", false);
  if (read.failed()) return read.error();
  Selection& selection = workspace.session.selection;
  add ? selection.toggle(joint) : selection.select_only(joint);
  return skeleton.name(joint);
}

void add_walk_commands(CommandRegistry& registry, Workspace& workspace) {
  const auto parent = [&workspace] {
    const Session& session = workspace.session;
    const JointIndex active = session.selection.active_joint();
    return active == kNoParent ? kNoParent : session.document.skeleton().parent(active);
  };
  const auto child = [&workspace] {
    const Session& session = workspace.session;
    const JointIndex active = session.selection.active_joint();
    return active == kNoParent ? kNoParent : first_child(session.document.skeleton(), active);
  };
  const auto add = [&](std::string id, std::string label, std::string help, std::string shortcut, const char* icon,
                       const auto& target, Reason no_target) {
    registry.add({.id = std::move(id),
                  .label = std::move(label),
                  .help = std::move(help),
                  .shortcut = std::move(shortcut),
                  .icon = icon,
                  .run = [&workspace, target](const json&) -> json {
                    workspace.session.selection.select_only(target());
                    return nullptr;
                  },
                  .blocked = [&workspace, target, no_target] {
                    const Reason reason = needs_joint(workspace);
                    return *reason != '\0' || target() != kNoParent ? reason : no_target;
                  }});
  };
  add("select.parent", "Select parent joint", "Selects the joint that carries the selected one.", "[", icons::kArrowUp,
      parent, "The root has no parent.");
  add("select.child", "Select child joint", "Selects the first joint that the selected one carries.", "]",
      icons::kArrowDown, child, "The joint has no child.");
}

}  // namespace

void add_edit_commands(CommandRegistry& registry, Workspace& workspace) {
  add_history_commands(registry, workspace);
  add_walk_commands(registry, workspace);
  registry.add({.id = "select.all",
                .label = "Select all joints",
                .help = "Selects every joint, so that the curve editor shows all curves.",
                .shortcut = "Alt+Shift+A",
                .icon = icons::kListTree,
                .run = [&workspace](const json&) -> json {
                  Session& session = workspace.session;
                  std::vector<JointIndex> joints(idx(session.document.skeleton().joint_count()));
                  std::iota(joints.begin(), joints.end(), 0);
                  session.selection.select_joints(joints);
                  return nullptr;
                },
                .blocked = [&workspace] { return needs_clip(workspace); }});
  registry.add({.id = "select.none",
                .label = "Deselect joints",
                .help = "Selects no joint.",
                .shortcut = "Alt+A",
                .icon = icons::kX,
                .run = [&workspace](const json&) -> json {
                  workspace.session.selection.clear_joints();
                  return nullptr;
                },
                .blocked = [&workspace] { return *needs_joint(workspace) == '\0' ? "" : "No joint is selected."; }});
  registry.add({.id = "select.joint",
                .label = "Select joint",
                .help = "Selects a joint by its number.",
                .run = [&workspace](const json& args) { return select_joint(workspace, args); },
                .blocked = [&workspace] { return needs_clip(workspace); },
                .in_palette = false});
}

}  // namespace marey::app
