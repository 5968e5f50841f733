#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include <memory>
#include <utility>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/operation_text.h"
#include "cli/recipe_json.h"
#include "cli/report.h"
#include "core/document/document.h"
#include "core/editing/name_match.h"

namespace marey::cli {
namespace {

struct EditOptions {
  Input input;
  std::string output;
  std::vector<std::string> steps;  ///< as --do has them
  std::string recipe;              ///< JSON file; empty: none
  bool with_report = false;        ///< print as JSON what was done
};

std::string at_column(const Error& error) {
  return error.place.column > 0 ? fmt::format(", column {}", error.place.column) : std::string();
}

/// What is wrong with a step, as one line.
void report_step(std::size_t number, const RecipeStep& step, const Error& error) {
  const std::string name = step.operation.empty() ? std::string() : fmt::format(" ({})", step.operation);
  report_usage_error(fmt::format("Step {}{}{}: {}", number, name, at_column(error), error.message));
}

/// The steps to take; nothing if they cannot be read, which has been reported.
std::optional<std::vector<RecipeStep>> read_steps(const EditOptions& options) {
  if (!options.recipe.empty()) {
    const std::optional<std::string> text = read_bytes(options.recipe);
    if (!text) return std::nullopt;
    Result<std::vector<RecipeStep>> steps = read_recipe(*text);
    if (steps) return std::move(*steps);
    report_error(options.recipe, steps.error());
    return std::nullopt;
  }
  std::vector<RecipeStep> steps;
  for (const std::string& text : options.steps) {
    Result<RecipeStep> step = parse_recipe_step(text);
    if (!step) {
      report_step(steps.size() + 1, {}, step.error());
      return std::nullopt;
    }
    steps.push_back(std::move(*step));
  }
  return steps;
}

/// The other clip that a step names; nothing if there is none.
std::optional<Clip> read_other(const EditOptions& options, const BoundStep& step) {
  if (step.other_file.empty()) return std::nullopt;
  Input input = options.input;
  input.file = step.other_file;
  std::optional<BvhClip> read = read_clip_for_use(input);
  return read ? std::optional(make_clip(std::move(*read))) : std::nullopt;
}

/// Takes one step; nothing if it cannot be taken, which has been reported.
std::optional<StepReport> take_step(const EditOptions& options, const RecipeStep& step, std::size_t number, Document& document) {
  Result<BoundStep> bound = bind_step(step, document.clip());
  if (!bound) {
    report_step(number, step, bound.error());
    return std::nullopt;
  }
  const std::optional<Clip> other = read_other(options, *bound);
  if (!bound->other_file.empty() && !other) return std::nullopt;
  bound->values.other = other ? &*other : nullptr;
  Result<OperationOutcome> outcome = make_operation_edit(document.clip(), *bound->operation, bound->target, bound->values);
  if (!outcome) {
    report_step(number, step, outcome.error());
    return std::nullopt;
  }
  StepReport report{step.operation, !outcome->edit.empty(), outcome->edit.name, std::move(outcome->notes)};
  if (const Status status = document.apply(std::move(outcome->edit)); !status) {
    report_step(number, step, status.error());
    return std::nullopt;
  }
  return report;
}

ExitCode run_edit(const EditOptions& options) {
  if (options.steps.empty() == options.recipe.empty()) {
    report_usage_error("Say what to do by --do, again and again, or by one --recipe.");
    return ExitCode::BadInput;
  }
  if (options.with_report && options.output == "-") {
    report_usage_error("--json wants standard output for itself; name a file to write.");
    return ExitCode::BadInput;
  }
  const auto steps = read_steps(options);
  if (!steps) return ExitCode::BadInput;
  std::optional<BvhClip> clip = read_clip_for_use(options.input);
  if (!clip) return ExitCode::BadInput;
  Document document(std::move(*clip), display_name(options.input.file));
  std::vector<StepReport> reports;
  for (const RecipeStep& step : *steps) {
    std::optional<StepReport> report = take_step(options, step, reports.size() + 1, document);
    if (!report) return ExitCode::BadInput;
    if (!options.with_report) {
      for (const std::string& note : report->notes) report_note(options.input.file, {}, fmt::format("{}: {}", step.operation, note));
    }
    reports.push_back(std::move(*report));
  }
  if (!write_bytes(options.output, document.save_text())) return ExitCode::BadInput;
  if (options.with_report && !write_bytes("-", steps_json(reports))) return ExitCode::BadInput;
  return ExitCode::Done;
}

/// Prints, and ends the program in the way that --help does.
void print_and_leave(const std::string& text) {
  if (!write_bytes("-", text)) throw CLI::RuntimeError(static_cast<int>(ExitCode::BadInput));
  throw CLI::Success();
}

void print_operation(const std::string& id) {
  const Operation* operation = find_operation(id);
  if (operation != nullptr) print_and_leave(operation_text(*operation));
  std::vector<std::string_view> ids;
  for (const Operation& known : operations()) ids.push_back(known.id);
  std::string message = fmt::format("'{}' is no operation.{}", id, suggestion(id, ids));
  message.pop_back();  // the usage goes on behind it
  throw CLI::ValidationError("--help-operation", message);
}

}  // namespace

void add_edit_command(CLI::App& program, ExitCode& exit_code) {
  const auto options = std::make_shared<EditOptions>();
  CLI::App* command = program.add_subcommand("edit", "Change a clip by one operation after the other");
  add_input(*command, options->input, "IN");
  command->add_option("OUT", options->output, "BVH file to write; - for standard output")->required();
  command
      ->add_option("--do", options->steps, "A step, such as 'smooth sigma=2 joints=Left* frames=10:60'; again and again")
      ->expected(1)
      ->take_all();
  command->add_option("--recipe", options->recipe, "JSON file with the steps; - for standard input");
  command->add_flag("--json", options->with_report, "Print what was done as JSON; with --list, the operations");
  command->add_flag_callback(
      "--list", [options] { print_and_leave(options->with_report ? operations_json() : operations_text()); },
      "List the operations");
  command->add_option_function<std::string>("--help-operation", print_operation, "Describe an operation and its parameters");
  command->callback([options, &exit_code] { exit_code = run_edit(*options); });
}

}  // namespace marey::cli
