#include <fmt/format.h>

#include <iterator>
#include <memory>

#include "cli/commands.h"
#include "cli/export_json.h"
#include "cli/files.h"
#include "core/interchange/export_target.h"

namespace marey::cli {
namespace {

std::string targets_text() {
  std::string out;
  for (const TargetTraits& target : export_targets()) {
    fmt::format_to(std::back_inserter(out), "{} ({}): {}\n", target.id, target.name, target.audience);
    for (const TargetNeed& need : target.needs) {
      fmt::format_to(std::back_inserter(out), "  - {} {}\n", traits_of(need.requirement).sentence, need.reason);
    }
    if (!target.remark.empty()) fmt::format_to(std::back_inserter(out), "  {}\n", target.remark);
    fmt::format_to(std::back_inserter(out), "  Known from {}.\n", target.source);
  }
  return out;
}

}  // namespace

void add_targets_command(CLI::App& program, ExitCode& exit_code) {
  const auto as_json = std::make_shared<bool>(false);
  CLI::App* command = program.add_subcommand("targets", "List the programs that convert --for can write for");
  command->add_flag("--json", *as_json, "As JSON");
  command->callback([as_json, &exit_code] {
    exit_code = write_bytes("-", *as_json ? targets_json() : targets_text()) ? ExitCode::Done : ExitCode::BadInput;
  });
}

}  // namespace marey::cli
