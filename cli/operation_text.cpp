#include "cli/operation_text.h"

#include <fmt/format.h>

#include <iterator>

namespace marey::cli {
namespace {

// "0.1 to 1000 frames, 2 by default", "cubic or linear, cubic by default".
std::string range_text(const OperationParameter& parameter) {
  const std::string unit = parameter.unit.empty() ? std::string() : fmt::format(" {}", parameter.unit);
  const auto choice = static_cast<std::size_t>(parameter.initial);
  switch (parameter.kind) {
    case ParameterKind::Choice:
      return fmt::format("{}; {} by default", fmt::join(parameter.choices, ", "), parameter.choices[choice]);
    case ParameterKind::Axis: return fmt::format("x, y, z; {} by default", "xyz"[choice]);
    case ParameterKind::YesNo: return fmt::format("yes, no; {} by default", choice == 1 ? "yes" : "no");
    case ParameterKind::Frame: return fmt::format("a frame from 1; {} by default", parameter.initial + 1.0);
    case ParameterKind::Points: return "FRAME:FRAME,FRAME:FRAME...";
    case ParameterKind::File: return "a BVH file";
    case ParameterKind::Text: return "a text";
    case ParameterKind::Number:
    case ParameterKind::Whole: break;
  }
  const std::string_view kind = parameter.odd ? "odd, " : parameter.kind == ParameterKind::Whole ? "whole, " : "";
  return fmt::format("{}{} to {}{}; {} by default", kind, parameter.least, parameter.most, unit, parameter.initial);
}

// What else a step may say.
std::string_view target_text(OperationReach reach) {
  switch (reach) {
    case OperationReach::Channels:
    case OperationReach::Joints: return "joints, channels, frames, blend-in, blend-out, weight";
    case OperationReach::Roots: return "frames, blend-in, blend-out, weight";
    case OperationReach::Frames: return "frames";
    case OperationReach::Figure: return "joints";
    case OperationReach::Keys: return "joints, channels, frames";
    case OperationReach::Clip:
    case OperationReach::Layers: break;
  }
  return "";
}

}  // namespace

std::string operations_text() {
  std::string out;
  std::string_view group;
  for (const Operation& operation : operations()) {
    if (operation.group != group) fmt::format_to(std::back_inserter(out), "{}{}\n", out.empty() ? "" : "\n", operation.group);
    group = operation.group;
    fmt::format_to(std::back_inserter(out), "  {:<16} {}\n", operation.id, operation.help);
  }
  return out;
}

std::string operation_text(const Operation& operation) {
  std::string out = fmt::format("{}: {}\n", operation.id, operation.help);
  for (const OperationParameter& parameter : operation.parameters) {
    fmt::format_to(std::back_inserter(out), "  {:<16} {}: {}\n  {:<16} {}\n", parameter.name, parameter.label,
                   range_text(parameter), "", parameter.help);
  }
  const std::string_view target = target_text(operation.reach);
  if (!target.empty()) fmt::format_to(std::back_inserter(out), "  also: {}\n", target);
  return out;
}

}  // namespace marey::cli
