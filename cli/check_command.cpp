#include <fmt/format.h>

#include <iterator>
#include <memory>

#include "cli/channel_limits.h"
#include "cli/clip_json.h"
#include "cli/commands.h"
#include "cli/files.h"
#include "cli/lint_report.h"
#include "cli/report.h"
#include "core/base/counted.h"
#include "core/document/document.h"

namespace marey::cli {
namespace {

struct CheckOptions {
  Input input;
  std::string limits_file;
};

/// The violations of the limits in a file, none without a file. Failure is reported.
std::optional<std::vector<Violation>> check_limits(const std::string& limits_file, const BvhClip& clip) {
  if (limits_file.empty()) return std::vector<Violation>();
  const std::optional<std::string> text = read_bytes(limits_file);
  if (!text) return std::nullopt;
  const Result<std::vector<ChannelLimit>> limits = read_limits(*text);
  if (!limits) {
    report_error(limits_file, limits.error());
    return std::nullopt;
  }
  Result<std::vector<Violation>> violations = find_violations(clip.skeleton, clip.motion, *limits);
  if (!violations) {
    report_error(limits_file, violations.error());
    return std::nullopt;
  }
  return std::move(*violations);
}

std::string verdict(const std::string& file, const BvhClip& clip, const std::vector<Violation>& violations) {
  std::string out;
  for (const Violation& violation : violations) {
    fmt::format_to(std::back_inserter(out), "{}: {}\n", display_name(file),
                   violation_sentence(clip.skeleton, violation));
  }
  const auto found = [&clip](Severity severity) { return clip.diagnostics.count(severity); };
  fmt::format_to(std::back_inserter(out), "{}: {}, {}, {}\n", display_name(file),
                 counted(found(Severity::Error), "error"), counted(found(Severity::Warning), "warning"),
                 counted(size_of(violations), "limit violation"));
  return out;
}

ExitCode run_check(const CheckOptions& options) {
  const std::string& file = options.input.file;
  const std::optional<BvhClip> clip = read_clip(options.input);
  if (!clip) return ExitCode::BadInput;
  const std::optional<std::vector<Violation>> violations = check_limits(options.limits_file, *clip);
  if (!violations) return ExitCode::BadInput;
  const LintReport lint = lint_clip(make_clip(*clip));
  if (!options.input.as_json) report_check(file, clip->diagnostics, lint);
  const std::string text = options.input.as_json ? check_json(display_name(file), *clip, lint, *violations)
                                                 : verdict(file, *clip, *violations);
  if (!write_bytes("-", text)) return ExitCode::BadInput;
  const bool is_good = violations->empty() && clip->diagnostics.count(Severity::Error) == 0;
  return is_good ? ExitCode::Done : ExitCode::CheckFailed;
}

}  // namespace

void add_check_command(CLI::App& program, ExitCode& exit_code) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App* command = program.add_subcommand("check", "Report findings and limit violations; exit code 1 if it fails");
  add_input(*command, options->input);
  command->add_option("--limits", options->limits_file,
                      R"(JSON file: {"limits": [{"channel": "LeftKnee Xrotation", "min": 0, "max": 140}]})");
  command->add_flag("--json", options->input.as_json, "As JSON, the findings included");
  command->callback([options, &exit_code] { exit_code = run_check(*options); });
}

}  // namespace marey::cli
