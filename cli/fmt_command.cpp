#include <memory>

#include "cli/commands.h"
#include "cli/files.h"
#include "core/bvh/writer.h"

namespace marey::cli {
namespace {

struct FmtOptions {
  Input input;
  std::string output = "-";
  bool canonical = false;
};

ExitCode run_fmt(const FmtOptions& options) {
  const std::optional<BvhClip> clip = read_clip_for_use(options.input);
  if (!clip) return ExitCode::BadInput;
  const std::string text = write_bvh(clip->skeleton, clip->motion, options.canonical ? BvhStyle() : clip->style);
  return write_bytes(options.output, text) ? ExitCode::Done : ExitCode::BadInput;
}

}  // namespace

void add_fmt_command(CLI::App& program, ExitCode& exit_code) {
  const auto options = std::make_shared<FmtOptions>();
  CLI::App* command = program.add_subcommand("fmt", "Repair a BVH file and write it in its own style");
  add_input(*command, options->input);
  command->add_option("-o,--output", options->output, "BVH file to write; standard output by default");
  command->add_flag("--canonical", options->canonical, "Write the one clean form instead of the file's own style");
  command->callback([options, &exit_code] { exit_code = run_fmt(*options); });
}

}  // namespace marey::cli
