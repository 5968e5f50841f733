#include <memory>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/table_output.h"

namespace marey::cli {
namespace {

struct FkOptions {
  Input input;
  std::string output = "-";
  std::string length_unit;
  std::string positions;  ///< kPositionRuleIds; empty: as the file's numbers speak
};

ExitCode run_fk(const FkOptions& options) {
  std::optional<BvhClip> clip = read_clip_for_use(options.input);
  if (!clip) return ExitCode::BadInput;
  clip->position_rule = find_position_rule(options.positions).value_or(clip->position_rule);
  return write_position_table(options.output, *clip, options.length_unit);
}

}  // namespace

void add_fk_command(CLI::App& program, ExitCode& exit_code) {
  const auto options = std::make_shared<FkOptions>();
  CLI::App* command = program.add_subcommand("fk", "Write the world positions of all joints and end sites as CSV");
  add_input(*command, options->input);
  command->add_option("-o,--output", options->output, "CSV file to write; standard output by default");
  command->add_option("--positions", options->positions,
                      "Position channels replace OFFSET, are added to it, or each as its joint's numbers speak; by default as all of "
                      "the file's numbers speak")
      ->check(CLI::IsMember(kPositionRuleIds));
  add_units(*command, options->length_unit);
  command->callback([options, &exit_code] { exit_code = run_fk(*options); });
}

}  // namespace marey::cli
