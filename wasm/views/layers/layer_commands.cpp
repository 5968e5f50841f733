#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/base/counted.h"
#include "core/editing/key_edits.h"
#include "core/editing/layer_edits.h"
#include "core/motion/key_curve_edits.h"
#include "wasm/app/builtin_commands.h"
#include "wasm/app/command_args.h"
#include "wasm/app/icons.h"
#include "wasm/views/layers/layers_page.h"

namespace marey::app {
namespace {

using Json = nlohmann::json;

Reason without_layer(const Session& session) {
  return session.active_layer == kOwnKeys ? "Choose a layer first." : "";
}

Reason without_curves(const Workspace& workspace) {
  const Session& session = workspace.session;
  if (session.is_partial) return needs_whole_clip(workspace);
  const Reason reason = needs_frames(workspace);
  if (*reason != '\0') return reason;
  return session.selection.joints().empty() ? "Select a joint first." : "";
}

Json said(const Status& status) { return status ? Json(nullptr) : command_error(status.error().message); }

Json apply(Session& session, Result<Edit> edit) {
  return edit ? said(session.apply(std::move(*edit))) : command_error(edit.error().message);
}

Json add_layer(Session& session, const Json& args) {
  CommandArgs read(args);
  LayerStack stack = session.document.clip().stack;
  Layer layer;
  layer.name = free_layer_name(stack, read.text("name", ""));
  const std::string mode = read.text("mode", "additive");
  if (read.failed()) return read.error();
  if (mode != "additive" && mode != "override") return command_error("A layer's mode is additive or override, not " + mode + ".");
  if (mode == "override") layer.mode = LayerMode::Override;
  stack.layers.push_back(std::move(layer));
  const Status status = session.apply(make_stack_edit(session.document.clip(), "Add layer", std::move(stack)));
  if (status) session.active_layer = size_of(session.document.clip().stack.layers) - 1;
  return said(status);
}

// One place up or down; the active layer moves along.
Json move_layer(Session& session, int by) {
  LayerStack stack = session.document.clip().stack;
  const int to = session.active_layer + by;
  std::swap(stack.layers[idx(session.active_layer)], stack.layers[idx(to)]);
  const Status status = session.apply(make_stack_edit(session.document.clip(), "Move layer", std::move(stack)));
  if (status) session.active_layer = to;
  return said(status);
}

Reason without_place(const Session& session, int by) {
  const Reason reason = without_layer(session);
  if (*reason != '\0') return reason;
  const int to = session.active_layer + by;
  if (to < 0) return "The layer is the lowest.";
  return to >= size_of(session.document.clip().stack.layers) ? "The layer is the highest." : "";
}

Json choose_layer(Session& session, const Json& args) {
  CommandArgs read(args);
  const int layer = read.whole("layer", 0, 0, size_of(session.document.clip().stack.layers));
  if (read.failed()) return read.error();
  session.active_layer = layer - 1;
  return nullptr;
}

// Keys with the values that the curves have at the frame, so that they can be moved.
Json set_keys(Session& session) {
  const Clip& clip = session.document.clip();
  const FrameIndex frame = session.playback.frame();
  ChannelValues wanted;
  for (const ChannelIndex channel : session.selection.shown_channels(clip.skeleton)) {
    const bool has_keys = session.active_layer != kOwnKeys || clip.stack.keyed.contains(channel);
    if (has_keys) wanted[channel] = clip.motion.sample(channel, frame);
  }
  if (wanted.empty()) return command_error("These curves are samples. Make keys of them, or choose a layer.");
  const std::string name = fmt::format("Set {}", counted(static_cast<std::int64_t>(wanted.size()), "key"));
  return apply(session, make_pose_key_edit(clip, name, session.active_layer, frame, wanted));
}

Json delete_keys_here(Session& session) {
  const Clip& clip = session.document.clip();
  const double frame = session.playback.frame();
  std::map<ChannelIndex, KeyCurve> curves;
  for (const ChannelIndex channel : session.selection.shown_channels(clip.skeleton)) {
    const SharedKeys keys = find_keys(clip.stack, session.active_layer, channel);
    if (!keys || find_key_at(*keys, frame) < 0) continue;
    curves[channel] = *keys;
    delete_keys(curves[channel], frame, frame);
  }
  if (curves.empty()) return command_error("There are no keys at this frame.");
  return apply(session, make_keys_edit(clip, "Delete keys", session.active_layer, std::move(curves)));
}

void add_key_commands(CommandRegistry& registry, Workspace& workspace) {
  Session& session = workspace.session;
  registry.add({.id = "keys.set",
                .label = "Set keys",
                .help = "Sets keys on the active layer at this frame, for the curves that are shown.",
                .shortcut = "K",
                .icon = icons::kDiamondPlus,
                .run = [&session](const Json&) { return set_keys(session); },
                .blocked = [&workspace] { return without_curves(workspace); }});
  registry.add({.id = "keys.delete",
                .label = "Delete keys",
                .help = "Takes the keys of the active layer at this frame away, for the curves that are shown.",
                .shortcut = "Alt+K",
                .icon = icons::kDiamondMinus,
                .run = [&session](const Json&) { return delete_keys_here(session); },
                .blocked = [&workspace] { return without_curves(workspace); }});
}

void add_order_commands(CommandRegistry& registry, Session& session) {
  registry.add({.id = "layer.up",
                .label = "Layer up",
                .help = "Puts the active layer above the next one.",
                .icon = icons::kArrowUp,
                .run = [&session](const Json&) { return move_layer(session, 1); },
                .blocked = [&session] { return without_place(session, 1); }});
  registry.add({.id = "layer.down",
                .label = "Layer down",
                .help = "Puts the active layer below the next one.",
                .icon = icons::kArrowDown,
                .run = [&session](const Json&) { return move_layer(session, -1); },
                .blocked = [&session] { return without_place(session, -1); }});
}

}  // namespace

void add_layer_commands(CommandRegistry& registry, Workspace& workspace) {
  Session& session = workspace.session;
  registry.add({.id = "layer.add",
                .label = "Add layer",
                .help = "Puts an empty layer on top: its keys are added to what is beneath.",
                .icon = icons::kPlus,
                .run = [&session](const Json& args) { return add_layer(session, args); },
                .blocked = [&workspace] { return needs_whole_clip(workspace); }});
  registry.add({.id = "layer.delete",
                .label = "Delete layer",
                .help = "Takes the active layer and its keys away.",
                .icon = icons::kTrash2,
                .run = [&session](const Json&) { return apply(session, make_layer_deletion(session.document.clip(), session.active_layer)); },
                .blocked = [&session] { return without_layer(session); }});
  add_order_commands(registry, session);
  registry.add({.id = "layer.bake",
                .label = "Bake layers and keys",
                .help = "Keeps the samples as they are and lets layers and keys go.",
                .icon = icons::kLayers,
                .run = [&session](const Json&) { return said(session.apply(make_bake_edit(session.document.clip()))); },
                .blocked = [&session]() -> Reason {
                  return session.document.clip().stack.empty() ? "There are no layers and keys." : "";
                }});
  registry.add({.id = "layer.choose",
                .label = "Choose layer",
                .help = "Makes a layer the one that keys are set on; 0 for the channels themselves.",
                .run = [&session](const Json& args) { return choose_layer(session, args); },
                .in_palette = false});
  add_key_commands(registry, workspace);
}

}  // namespace marey::app
