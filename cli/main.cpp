#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include <csignal>
#include <cstdint>
#include <exception>

#include "cli/commands.h"
#include "cli/report.h"

namespace marey::cli {

namespace {

std::vector<std::string> character_set_ids() {
  std::vector<std::string> ids;
  for (const CharacterSet set : kCharacterSets) ids.emplace_back(traits_of(set).id);
  return ids;
}

/// "frames=1000" into the limits; what is wrong goes to the usage.
void read_limit(const std::string& text, ReadLimits& limits) {
  const std::size_t equals = text.find('=');
  std::int64_t value = 0;
  if (equals == std::string::npos || !CLI::detail::lexical_cast(text.substr(equals + 1), value)) {
    throw CLI::ValidationError("--max", "wants NAME=VALUE, as frames=1000");
  }
  const Status status = set_limit(limits, text.substr(0, equals), value);
  if (status) return;
  std::string message = status.error().message;
  message.pop_back();  // the usage goes on behind it
  throw CLI::ValidationError("--max", message);
}

}  // namespace

void add_input(CLI::App& command, Input& input, const std::string& name, const std::string& kind) {
  command.add_option(name, input.file, kind + ", - for standard input")->required();
  command.add_flag("--strict", input.strict, "Refuse what would otherwise be repaired");
  command
      .add_option_function<std::string>(
          "--names-in", [&input](const std::string& id) { input.names_in = find_character_set(id); },
          "Character set of the names; by default a guess")
      ->check(CLI::IsMember(character_set_ids()));
  command
      .add_option_function<std::vector<std::string>>(
          "--max",
          [&input](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) read_limit(text, input.limits);
          },
          "NAME=VALUE: another limit of reading; joints, depth, channels, frames, sample_bytes or bytes")
      ->expected(1)
      ->take_all();
}

namespace {

ExitCode run(int argument_count, char** arguments) {
  ExitCode exit_code = ExitCode::Done;
  CLI::App program("Marey reads, checks and converts BVH motion capture files.", "marey");
  program.set_version_flag("--version", "marey " MAREY_VERSION);
  program.require_subcommand(1);
  program.footer(
      "Frames are numbered from 1. Exit codes: 0 done, 1 a check failed, 2 the input or the usage is wrong.");
  add_info_command(program, exit_code);
  add_convert_command(program, exit_code);
  add_fk_command(program, exit_code);
  add_fmt_command(program, exit_code);
  add_check_command(program, exit_code);
  add_edit_command(program, exit_code);
  add_analyse_command(program, exit_code);
  add_targets_command(program, exit_code);
  try {
    program.parse(argument_count, arguments);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return static_cast<ExitCode>(program.exit(error));
    report_usage_error(fmt::format("{}. See marey --help.", error.what()));
    return ExitCode::BadInput;
  }
  return exit_code;
}

}  // namespace
}  // namespace marey::cli

int main(int argument_count, char** arguments) {
  // A reader that closes the pipe shows as a failed write instead of ending the program.
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return static_cast<int>(marey::cli::run(argument_count, arguments));
  } catch (const std::exception& error) {
    marey::cli::report_usage_error(error.what());
    return static_cast<int>(marey::cli::ExitCode::BadInput);
  }
}
