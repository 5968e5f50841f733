#include <fmt/format.h>

#include "core/editing/recipe.h"
#include "wasm/app/builtin_commands.h"
#include "wasm/app/command_args.h"
#include "wasm/app/faults.h"
#include "wasm/app/icons.h"

namespace marey::app {
namespace {

using nlohmann::json;

/// A step as `marey edit --do` takes it: {"do": "smooth sigma=2 joints=Left* frames=10:60"}.
json run_operation(Workspace& workspace, const json& args) {
  CommandArgs read(args);
  if (!read.has("do")) return command_error("Give the step as {\"do\": \"smooth sigma=2 joints=Left*\"}.");
  const std::string text = read.text("do", "");
  if (read.failed()) return read.error();
  const Result<RecipeStep> step = parse_recipe_step(text);
  if (!step) return command_error(step.error().message);
  const Clip& clip = workspace.session.document.clip();
  Result<BoundStep> bound = bind_step(*step, clip);
  if (!bound) return command_error(bound.error().message);
  if (!bound->other_file.empty()) {
    for (const auto& other : workspace.session.others) {
      if (other->file_name == bound->other_file) bound->values.other = &other->clip;
    }
    if (bound->values.other == nullptr) return command_error("Read " + bound->other_file + " first, by openOther().");
  }
  Result<OperationOutcome> outcome = make_operation_edit(clip, *bound->operation, bound->target, bound->values);
  if (!outcome) return command_error(outcome.error().message);
  const json answer = {{"changed", !outcome->edit.empty()}, {"name", outcome->edit.name}, {"notes", outcome->notes}};
  const Status status = workspace.session.apply(std::move(outcome->edit));
  return status ? answer : command_error(status.error().message);
}

// The figure hangs on its root from the shown frame on, and that is played. One that falls freely would only be gone.
json let_go(CommandRegistry& registry, Workspace& workspace) {
  Playback& playback = workspace.session.playback;
  json answer = run_operation(workspace, {{"do", fmt::format("let-go frame={} root=held", playback.frame() + 1)}});
  if (answer.contains("error")) return answer;
  workspace.notify(fmt::format("Let go, held at the root. {} Undo brings the motion back.", answer["notes"][0].get<std::string>()));
  playback.set_range({0, workspace.session.document.motion().frame_count()});
  playback.set_playing(true);
  registry.run("curve.fit");
  return answer;
}

}  // namespace

void add_operation_commands(CommandRegistry& registry, Workspace& workspace) {
  registry.add({.id = "edit.operation",
                .label = "Take a step of operations",
                .help = "Changes the clip by one operation, as marey edit does.",
                .run = [&workspace](const json& args) { return run_operation(workspace, args); },
                .blocked = [&workspace] { return needs_whole_clip(workspace); },
                .in_palette = false});
  registry.add({.id = "analysis.let_go",
                .label = "Let go and watch",
                .help = "From this frame on gravity alone moves the figure, held at its root, for 5 s. Undo brings the motion back.",
                .icon = icons::kPlay,
                .run = [&registry, &workspace](const json&) { return let_go(registry, workspace); },
                .blocked = [&workspace] { return needs_whole_clip(workspace); }});
}

}  // namespace marey::app
