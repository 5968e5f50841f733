#include "core/editing/operation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/counted.h"
#include "core/editing/layer_edits.h"
#include "core/editing/operations/families.h"

namespace marey {
namespace {

std::vector<Operation> make_table() {
  std::vector<Operation> table;
  for (const std::span<const Operation> family : operation_families()) table.insert(table.end(), family.begin(), family.end());
  return table;
}

Error refusal(std::string message) { return {DiagnosticCode::InvalidArgument, {}, std::move(message), {}, {}}; }

// Whether there is anything to work on.
bool has_work(const Operation& operation, const OperationTarget& target) {
  if (operation.reach == OperationReach::Clip || operation.reach == OperationReach::Layers) return true;
  if (operation.reach == OperationReach::Keys) return !target.channels.empty();
  if (operation.reach == OperationReach::Figure) return !target.joints.empty();
  if (target.weight <= 0.0) return false;
  if (operation.reach == OperationReach::Frames || operation.reach == OperationReach::Roots) return target.frames.count > 0;
  return target.frames.count > 0 && !(target.channels.empty() && target.joints.empty());
}

std::size_t place_of(const OperationCall& call, std::string_view parameter) {
  return idx(std::max(find_parameter(call.operation, parameter), 0));
}

}  // namespace

double OperationCall::number(std::string_view parameter) const { return values.numbers[place_of(*this, parameter)]; }

std::string_view OperationCall::choice(std::string_view parameter) const {
  const std::size_t place = place_of(*this, parameter);
  return operation.parameters[place].choices[static_cast<std::size_t>(values.numbers[place])];
}

const std::string& OperationCall::text(std::string_view parameter) const { return values.texts[place_of(*this, parameter)]; }

std::span<const Operation> operations() {
  static const std::vector<Operation> table = make_table();
  return table;
}

const Operation* find_operation(std::string_view id) {
  const std::span<const Operation> table = operations();
  const auto found = std::find_if(table.begin(), table.end(), [id](const Operation& operation) { return operation.id == id; });
  return found == table.end() ? nullptr : &*found;
}

OperationValues initial_values(const Operation& operation) {
  OperationValues values;
  for (const OperationParameter& parameter : operation.parameters) values.numbers.push_back(parameter.initial);
  values.texts.resize(operation.parameters.size());
  return values;
}

int find_parameter(const Operation& operation, std::string_view name) {
  for (std::size_t i = 0; i < operation.parameters.size(); ++i) {
    if (operation.parameters[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

// "'sigma' is 0.1 to 1000 frames, not 5000."
Status check_value(const OperationParameter& parameter, double value) {
  const bool is_whole = parameter.kind != ParameterKind::Number;
  const bool fits = value >= parameter.least && value <= parameter.most && (!is_whole || value == std::floor(value)) &&
                    (!parameter.odd || std::fmod(value, 2.0) == 1.0);
  if (fits) return {};
  const std::string_view kind = parameter.odd ? "an odd number from " : is_whole ? "a whole number from " : "";
  const std::string unit = parameter.unit.empty() ? std::string() : fmt::format(" {}", parameter.unit);
  // People count frames from 1.
  const double shift = parameter.kind == ParameterKind::Frame ? 1.0 : 0.0;
  return refusal(fmt::format("'{}' is {}{} to {}{}, not {}.", parameter.name, kind, parameter.least + shift,
                             parameter.most + shift, unit, value + shift));
}

Status check_values(const Operation& operation, const OperationValues& values) {
  const std::size_t count = operation.parameters.size();
  if (values.numbers.size() != count || values.texts.size() != count) {
    return refusal(fmt::format("'{}' takes {}, not {}.", operation.id, counted(static_cast<std::int64_t>(count), "value"),
                               values.numbers.size()));
  }
  for (std::size_t i = 0; i < count; ++i) {
    const OperationParameter& parameter = operation.parameters[i];
    if (parameter.kind == ParameterKind::File && values.other == nullptr) {
      return refusal(fmt::format("'{}' wants another clip as '{}'.", operation.id, parameter.name));
    }
    if (is_text(parameter.kind)) continue;
    if (Status status = check_value(parameter, values.numbers[i]); !status) return status;
  }
  return {};
}

Result<OperationOutcome> make_operation_edit(const Clip& clip, const Operation& operation, const OperationTarget& target,
                                             const OperationValues& values) {
  if (Status status = check_values(operation, values); !status) return status.error();
  const OperationTarget within = within_clip(clip, target);
  if (!has_work(operation, within)) return OperationOutcome{};
  Result<OperationOutcome> outcome = operation.make({clip, within, operation, values});
  if (!outcome) return outcome;
  if (Status status = check_edit(clip, outcome->edit); !status) return status.error();
  const bool has_stack = outcome->edit.stack.has_value();
  Result<Edit> fitting = fit_to_layers(clip, reduced_to_changes(clip, std::move(outcome->edit)));
  if (!fitting) return fitting.error();
  outcome->edit = reduced_to_changes(clip, std::move(*fitting));
  const bool is_baked = !has_stack && outcome->edit.stack && outcome->edit.stack->empty();
  if (is_baked) outcome->notes.emplace_back("Layers and keys were baked, as they do not fit the new frames or figure.");
  return outcome;
}

}  // namespace marey
