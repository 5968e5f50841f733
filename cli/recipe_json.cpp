#include "cli/recipe_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/json_text.h"
#include "core/base/number_text.h"

namespace marey::cli {
namespace {

using Json = nlohmann::ordered_json;

Error recipe_error(std::string message) {
  return {DiagnosticCode::InvalidArgument, {}, std::move(message), {}, {}};
}

std::optional<std::string> scalar_text(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_number_integer()) return value.dump();
  if (!value.is_number()) return std::nullopt;
  std::string text;
  append_number(value.get<double>(), {.decimals = 0}, text);
  return text;
}

bool is_pair(const Json& value) {
  return value.is_array() && value.size() == 2 && value[0].is_number() && value[1].is_number();
}

/// As it would stand behind "=" in a step; nothing for what cannot.
std::optional<std::string> value_text(const Json& value) {
  if (is_pair(value)) return fmt::format("{}:{}", *scalar_text(value[0]), *scalar_text(value[1]));
  if (!value.is_array()) return scalar_text(value);
  std::string text;
  for (const Json& part : value) {
    const auto item = is_pair(part) ? value_text(part) : scalar_text(part);
    if (!item) return std::nullopt;
    text += (text.empty() ? "" : ",") + *item;
  }
  return text;
}

Result<RecipeStep> read_step(const Json& entry, std::size_t number) {
  if (!entry.is_object() || !entry.contains("do") || !entry["do"].is_string()) {
    return recipe_error(fmt::format("Step {} is not an object with \"do\", such as {{\"do\": \"smooth\", \"sigma\": 2}}.", number));
  }
  RecipeStep step{entry["do"], {}};
  for (const auto& [name, value] : entry.items()) {
    if (name == "do") continue;
    const std::optional<std::string> text = value_text(value);
    if (!text) return recipe_error(fmt::format("Step {}: \"{}\" is no text, number, true, false or list of them.", number, name));
    step.words.push_back({name, *text, 0});
  }
  return step;
}

std::string_view kind_id(ParameterKind kind) {
  switch (kind) {
    case ParameterKind::Number: return "number";
    case ParameterKind::Whole: return "whole";
    case ParameterKind::Frame: return "frame";
    case ParameterKind::Choice: return "choice";
    case ParameterKind::Axis: return "axis";
    case ParameterKind::YesNo: return "yes_no";
    case ParameterKind::Points: return "points";
    case ParameterKind::File: return "file";
    case ParameterKind::Text: return "text";
  }
  return "";
}

std::string_view reach_id(OperationReach reach) {
  switch (reach) {
    case OperationReach::Channels: return "channels";
    case OperationReach::Joints: return "joints";
    case OperationReach::Roots: return "roots";
    case OperationReach::Frames: return "frames";
    case OperationReach::Clip: return "clip";
    case OperationReach::Figure: return "figure";
    case OperationReach::Keys: return "keys";
    case OperationReach::Layers: return "layers";
  }
  return "";
}

Json parameter_json(const OperationParameter& parameter) {
  Json json = {{"name", parameter.name}, {"label", parameter.label}, {"unit", parameter.unit}, {"help", parameter.help},
               {"kind", kind_id(parameter.kind)}};
  if (is_text(parameter.kind)) return json;
  json["initial"] = parameter.initial;
  json["least"] = parameter.least;
  json["most"] = parameter.most;
  if (!parameter.choices.empty()) json["choices"] = std::vector<std::string_view>(parameter.choices.begin(), parameter.choices.end());
  return json;
}

std::string text_of(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n'; }

}  // namespace

Result<std::vector<RecipeStep>> read_recipe(std::string_view json_text) {
  const Result<Json> json = parse_json<Json>(json_text, "The recipe");
  if (!json) return json.error();
  if (!json->is_array()) return recipe_error("The recipe is not a list of steps, such as [{\"do\": \"smooth\", \"sigma\": 2}].");
  std::vector<RecipeStep> steps;
  for (const Json& entry : *json) {
    Result<RecipeStep> step = read_step(entry, steps.size() + 1);
    if (!step) return step.error();
    steps.push_back(std::move(*step));
  }
  return steps;
}

std::string operations_json() {
  Json list = Json::array();
  for (const Operation& operation : operations()) {
    Json parameters = Json::array();
    for (const OperationParameter& parameter : operation.parameters) parameters.push_back(parameter_json(parameter));
    list.push_back({{"id", operation.id}, {"label", operation.label}, {"group", operation.group}, {"help", operation.help},
                    {"reach", reach_id(operation.reach)}, {"parameters", std::move(parameters)}});
  }
  return text_of({{"operations", std::move(list)}});
}

std::string steps_json(const std::vector<StepReport>& steps) {
  Json list = Json::array();
  for (const StepReport& step : steps) {
    list.push_back({{"do", step.operation}, {"changed", step.changed}, {"name", step.name}, {"notes", step.notes}});
  }
  return text_of({{"steps", std::move(list)}});
}

}  // namespace marey::cli
