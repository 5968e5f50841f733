#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include <csignal>
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

}  // namespace

void add_input(CLI::App& command, Input& input, const std::string& name, const std::string& kind) {
  command.add_option(name, input.file, kind + ", - for standard input")->required();
  command.add_flag("--strict", input.strict, "Refuse what would otherwise be repaired");
  command
      .add_option_function<std::string>(
          "--names-in", [&input](const std::string& id) { input.names_in = find_character_set(id); },
          "Character set of the names; by default a guess")
      ->check(CLI::IsMember(character_set_ids()));
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
