#pragma once

#include <CLI/App.hpp>
#include <string>

#include "cli/exit_code.h"
#include "cli/input.h"

namespace marey::cli {

// Each adds one command to the program; running it sets `exit_code`, which outlives the program.

void add_info_command(CLI::App& program, ExitCode& exit_code);
void add_convert_command(CLI::App& program, ExitCode& exit_code);
void add_fk_command(CLI::App& program, ExitCode& exit_code);
void add_fmt_command(CLI::App& program, ExitCode& exit_code);
void add_check_command(CLI::App& program, ExitCode& exit_code);
void add_edit_command(CLI::App& program, ExitCode& exit_code);
void add_analyse_command(CLI::App& program, ExitCode& exit_code);
void add_targets_command(CLI::App& program, ExitCode& exit_code);

/// Adds the positional FILE and --strict.
void add_input(CLI::App& command, Input& input, const std::string& name = "FILE",
               const std::string& kind = "BVH file");

}  // namespace marey::cli
