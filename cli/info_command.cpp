#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>

#include "cli/clip_json.h"
#include "cli/commands.h"
#include "cli/files.h"
#include "cli/report.h"
#include "core/base/counted.h"
#include "core/document/document.h"
#include "core/text/utf8.h"

namespace marey::cli {
namespace {

struct InfoOptions {
  Input input;
};

/// "ZXY (20 joints), Z (1 joint)", the most frequent first; joints that do not rotate are left out.
std::string euler_orders(const Skeleton& skeleton) {
  std::map<std::string, int> counts;
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) ++counts[euler_order_label(skeleton, joint)];
  counts.erase("");
  std::multimap<int, std::string, std::greater<>> by_count;
  for (const auto& [order, count] : counts) by_count.emplace(count, order);
  std::string text;
  for (const auto& [count, order] : by_count) {
    text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", order, counted(count, "joint"));
  }
  return text.empty() ? "none" : text;
}

std::string channel_list(const Skeleton& skeleton, JointIndex joint) {
  std::string text;
  for (const Channel& channel : skeleton.channels(joint)) {
    const bool is_known = channel.kind != ChannelKind::Other;
    text += ' ';
    text += is_known ? channel_keyword(channel.kind) : std::string_view(channel.other_name);
  }
  return text;
}

void append_tree(const Skeleton& skeleton, std::string& out) {
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    fmt::format_to(std::back_inserter(out), "{:{}}{}{}\n", "", 2 + 2 * skeleton.depth(joint), skeleton.name(joint),
                   channel_list(skeleton, joint));
  }
}

std::string info_text(const std::string& file, const BvhClip& clip) {
  const Skeleton& skeleton = clip.skeleton;
  const Motion& motion = clip.motion;
  const double metres_per_unit = guess_metres_per_unit(skeleton);
  const double stature = compute_stature(skeleton);
  std::string out = fmt::format("{}\n", display_name(file));
  const auto line = [&out](std::string_view name, const std::string& value) {
    fmt::format_to(std::back_inserter(out), "  {:<14}{}\n", name, value);
  };
  line("joints", fmt::format("{}, and {}", skeleton.joint_count(),
                             counted(skeleton.node_count() - skeleton.joint_count(), "end site")));
  line("channels", fmt::format("{}", skeleton.channel_count()));
  line("frames", fmt::format("{}", motion.frame_count()));
  line("frame time", fmt::format("{} s, {:.6g} per second", motion.frame_time_s(),
                                 display_frame_rate_hz(motion.frame_time_s())));
  line("duration", fmt::format("{:.6g} s", motion.duration_s()));
  line("Euler orders", euler_orders(skeleton));
  line("stature", fmt::format("{:.6g} units", stature));
  line("unit", fmt::format("{:.6g} m (guessed: a stature of {:.2f} m)", metres_per_unit, stature * metres_per_unit));
  if (!std::all_of(skeleton.nodes().begin(), skeleton.nodes().end(), [](const Node& node) { return is_ascii(node.name); })) {
    line("names", fmt::format("{} ({})", traits_of(clip.names_in).label, traits_of(clip.names_in).script));
  }
  const Diagnostics& found = clip.diagnostics;
  line("findings", fmt::format("{}, {}, {}", counted(found.count(Severity::Error), "error"),
                               counted(found.count(Severity::Warning), "warning"),
                               counted(found.count(Severity::Note), "note")));
  append_tree(skeleton, out);
  return out;
}

ExitCode run_info(const InfoOptions& options) {
  const std::optional<BvhClip> clip = read_clip(options.input);
  if (!clip) return ExitCode::BadInput;
  if (!options.input.as_json) report_diagnostics(options.input.file, clip->diagnostics);
  const std::string text = options.input.as_json ? clip_json(*clip) : info_text(options.input.file, *clip);
  return write_bytes("-", text) ? ExitCode::Done : ExitCode::BadInput;
}

}  // namespace

void add_info_command(CLI::App& program, ExitCode& exit_code) {
  const auto options = std::make_shared<InfoOptions>();
  CLI::App* command = program.add_subcommand("info", "Tell what a BVH file holds and what was noticed while reading");
  add_input(*command, options->input);
  command->add_flag("--json", options->input.as_json, "As JSON, the findings included");
  command->callback([options, &exit_code] { exit_code = run_info(*options); });
}

}  // namespace marey::cli
