#include <memory>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/table_output.h"

namespace marey::cli {
namespace {

struct FkOptions {
  Input input;
  std::string output = "-";
};

ExitCode run_fk(const FkOptions& options) {
  const std::optional<BvhClip> clip = read_clip_for_use(options.input.file, options.input.strict);
  return clip ? write_position_table(options.output, *clip) : ExitCode::BadInput;
}

}  // namespace

void add_fk_command(CLI::App& program, ExitCode& exit_code) {
  const auto options = std::make_shared<FkOptions>();
  CLI::App* command = program.add_subcommand("fk", "Write the world positions of all joints and end sites as CSV");
  add_input(*command, options->input);
  command->add_option("-o,--output", options->output, "CSV file to write; standard output by default");
  command->callback([options, &exit_code] { exit_code = run_fk(*options); });
}

}  // namespace marey::cli
