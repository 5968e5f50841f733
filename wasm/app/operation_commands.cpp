#include "core/editing/recipe.h"
#include "wasm/app/builtin_commands.h"
#include "wasm/app/command_args.h"
#include "wasm/app/faults.h"

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
    const OtherClip* other = workspace.session.other.get();
    if (other == nullptr || other->file_name != bound->other_file) {
      return command_error("Read " + bound->other_file + " first, by openOther().");
    }
    bound->values.other = &other->clip;
  }
  Result<OperationOutcome> outcome = make_operation_edit(clip, *bound->operation, bound->target, bound->values);
  if (!outcome) return command_error(outcome.error().message);
  const json answer = {{"changed", !outcome->edit.empty()}, {"name", outcome->edit.name}, {"notes", outcome->notes}};
  const Status status = workspace.session.apply(std::move(outcome->edit));
  return status ? answer : command_error(status.error().message);
}

}  // namespace

void add_operation_commands(CommandRegistry& registry, Workspace& workspace) {
  registry.add({.id = "edit.operation",
                .label = "Take a step of operations",
                .help = "Changes the clip by one operation, as marey edit does.",
                .run = [&workspace](const json& args) { return run_operation(workspace, args); },
                .blocked = [&workspace] { return needs_whole_clip(workspace); },
                .in_palette = false});
}

}  // namespace marey::app
