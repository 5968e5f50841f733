#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <memory>

#include "cli/commands.h"
#include "cli/export_json.h"
#include "cli/files.h"
#include "cli/frame_selection.h"
#include "cli/report.h"
#include "cli/table_input.h"
#include "cli/table_output.h"
#include "core/base/counted.h"
#include "core/base/number_text.h"
#include "core/bvh/save_options.h"
#include "core/bvh/writer.h"
#include "core/document/document.h"
#include "core/interchange/export.h"
#include "core/motion/resampling.h"

namespace marey::cli {
namespace {

struct ConvertOptions {
  Input input;
  std::string output;
  std::string format;           ///< "bvh", "csv"; empty: by the extension of the output
  std::string input_format;     ///< "bvh", "csv"; empty: by the extension of the input
  std::string figure;           ///< BVH file with the figure of a table of channels; empty: none
  std::string length_unit;      ///< to be written into the header of a table; empty: none
  std::string frames;           ///< empty: all
  double frames_per_second = 0.0;  ///< 0: as they are
  std::optional<int> decimals;     ///< of the BVH to write; nothing: as they are
  std::string line_ends;           ///< "lf", "crlf"; empty: as they are
  std::string target;              ///< id of the program to write for; empty: none
  std::string reference_pose;      ///< "yes", "no"; empty: as the target wants it
  bool with_report = false;        ///< print as JSON what writing for the target did
};

std::string check_frames(const std::string& text) {
  if (parse_frame_selection(text)) return {};
  return fmt::format("\"{}\" is not FIRST:LAST, counted from 1, such as 10:60", text);
}

std::string check_rate(const std::string& text) {
  const NumberRead rate = read_number(text);
  const bool is_rate = !text.empty() && rate.length == text.size() && std::isfinite(rate.value) && rate.value > 0.0;
  return is_rate ? "" : fmt::format("\"{}\" is not a number of frames per second above 0", text);
}

std::string lower_case(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

bool has_extension(const std::string& file, std::string_view extension) {
  return lower_case(std::filesystem::path(file).extension().string()) == extension;
}

bool is_table(const ConvertOptions& options) {
  return options.input_format.empty() ? has_extension(options.input.file, ".csv") : options.input_format == "csv";
}

/// "bvh" or "csv"; nothing if the output's extension is neither, which has been reported.
std::optional<std::string> output_format(const ConvertOptions& options) {
  if (!options.format.empty()) return options.format;
  if (options.output == "-") return "bvh";
  for (const char* format : {"bvh", "csv"}) {
    if (has_extension(options.output, fmt::format(".{}", format))) return format;
  }
  report_error(options.output, {}, "The extension of a file to write is .bvh or .csv; --to names another format.");
  return std::nullopt;
}

/// The frames to take; nothing if the clip has not so many, which has been reported.
std::optional<FrameRange> wanted_frames(const ConvertOptions& options, const Motion& motion) {
  const auto selection = parse_frame_selection(options.frames);
  if (!selection) return FrameRange{0, motion.frame_count()};
  if (selection->last <= motion.frame_count()) return FrameRange{selection->first - 1, selection->last - selection->first + 1};
  report_error(options.input.file, {},
               fmt::format("The clip has {}, so {} cannot be taken.", counted(motion.frame_count(), "frame"), options.frames));
  return std::nullopt;
}

/// Trims and resamples the motion as asked; false if that cannot be done, which has been reported.
bool apply_options(const ConvertOptions& options, FrameRange frames, BvhClip& clip) {
  if (frames.count < clip.motion.frame_count()) clip.motion = trimmed(clip.motion, frames);
  if (options.frames_per_second <= 0.0) return true;
  Result<Motion> motion = resampled(clip.skeleton, clip.motion, options.frames_per_second);
  if (!motion) {
    report_usage_error(fmt::format("--fps: {}", motion.error().message));
    return false;
  }
  clip.motion = std::move(*motion);
  return true;
}

SaveOptions save_options(const ConvertOptions& options) {
  SaveOptions save;
  save.decimals = options.decimals;
  if (!options.line_ends.empty()) save.line_end = options.line_ends == "lf" ? LineEnd::Lf : LineEnd::CrLf;
  return save;
}

std::string check_target(const std::string& text) {
  if (find_export_target(text)) return {};
  return fmt::format("\"{}\" is no target; marey targets lists them", text);
}

/// False if the options contradict each other, which has been reported.
bool check_options(const ConvertOptions& options, const std::string& format) {
  const char* problem = nullptr;
  if (options.target.empty()) {
    if (options.with_report || !options.reference_pose.empty()) problem = "--json and --reference-pose go with --for.";
  } else if (format != "bvh") {
    problem = "--for writes BVH.";
  } else if (options.with_report && options.output == "-") {
    problem = "--json wants standard output for itself; name a file to write.";
  }
  if (!options.figure.empty() && !is_table(options)) problem = "--skeleton goes with a table to read.";
  if (format != "bvh" && save_options(options) != SaveOptions{}) problem = "--decimals and --line-ends go with BVH to write.";
  if (!options.length_unit.empty() && format != "csv") problem = "--units goes with a table to write.";
  if (problem != nullptr) report_usage_error(problem);
  return problem == nullptr;
}

ExitCode write_for_target(const ConvertOptions& options, const BvhClip& clip) {
  const ExportTarget target = find_export_target(options.target).value_or(ExportTarget::Strict);
  ExportOptions export_options;
  if (!options.reference_pose.empty()) export_options.reference_pose = options.reference_pose == "yes";
  const Result<ExportedClip> exported = export_for_target(make_clip(clip), target, export_options);
  if (!exported) {
    report_error(options.input.file, exported.error());
    return ExitCode::BadInput;
  }
  if (!write_bytes(options.output, write_exported(*exported, save_options(options)))) return ExitCode::BadInput;
  if (options.with_report) return write_bytes("-", export_json(target, *exported)) ? ExitCode::Done : ExitCode::BadInput;
  for (const ExportChange& change : exported->changes) report_note(options.input.file, {}, change.message);
  return ExitCode::Done;
}

/// The rows keep the text that they have in the file.
ExitCode write_rows(const ConvertOptions& options, const BvhClip& clip, FrameRange frames) {
  SaveOptions save = save_options(options);
  if (frames.count < clip.motion.frame_count()) save.frames = frames;
  return write_bytes(options.output, write_bvh(clip.skeleton, clip.motion, clip.style, save)) ? ExitCode::Done
                                                                                             : ExitCode::BadInput;
}

ExitCode run_convert(const ConvertOptions& options) {
  const std::optional<std::string> format = output_format(options);
  if (!format || !check_options(options, *format)) return ExitCode::BadInput;
  std::optional<BvhClip> clip =
      is_table(options) ? read_table(options.input, options.figure) : read_clip_for_use(options.input);
  if (!clip) return ExitCode::BadInput;
  const std::optional<FrameRange> frames = wanted_frames(options, clip->motion);
  if (!frames) return ExitCode::BadInput;
  const bool keeps_rows = *format == "bvh" && options.target.empty() && options.frames_per_second <= 0.0;
  if (keeps_rows) return write_rows(options, *clip, *frames);
  if (!apply_options(options, *frames, *clip)) return ExitCode::BadInput;
  if (!options.target.empty()) return write_for_target(options, *clip);
  if (*format == "csv") return write_channel_table(options.output, *clip, options.length_unit);
  const std::string text = write_bvh(clip->skeleton, clip->motion, clip->style, save_options(options));
  return write_bytes(options.output, text) ? ExitCode::Done : ExitCode::BadInput;
}

}  // namespace

void add_convert_command(CLI::App& program, ExitCode& exit_code) {
  const auto options = std::make_shared<ConvertOptions>();
  CLI::App* command = program.add_subcommand("convert", "Write a clip, or the clip of a table, as BVH or as CSV of its channels");
  add_input(*command, options->input, "IN", "BVH or CSV file");
  command->add_option("OUT", options->output, "File to write, .bvh or .csv; - for standard output")->required();
  command->add_option("--to", options->format, "Format to write, whatever the extension")
      ->check(CLI::IsMember({"bvh", "csv"}));
  command->add_option("--from", options->input_format, "Format to read, whatever the extension")
      ->check(CLI::IsMember({"bvh", "csv"}));
  command->add_option("--skeleton", options->figure,
                      "BVH file with the figure that a table of channels moves; without it a table is one of points");
  add_units(*command, options->length_unit);
  command->add_option("--frames", options->frames, "FIRST:LAST, counted from 1, both included")->check(check_frames);
  command->add_option("--fps", options->frames_per_second, "Frames per second to resample to")->check(check_rate);
  command->add_option("--decimals", options->decimals, "Decimals of the angles, positions and offsets of a BVH file to write")
      ->check(CLI::Range(0, kMostSavedDecimals));
  command->add_option("--line-ends", options->line_ends, "Line ends of a BVH file to write; by default as they are")
      ->check(CLI::IsMember({"lf", "crlf"}));
  command->add_option("--for", options->target, "Write BVH as a program wants it, at a cost; marey targets lists them")
      ->check(check_target);
  command->add_option("--reference-pose", options->reference_pose,
                      "With --for: whether the rest pose is the first frame; by default as the program wants it")
      ->check(CLI::IsMember({"yes", "no"}));
  command->add_flag("--json", options->with_report, "With --for: print what was changed, and what that costs, as JSON");
  command->callback([options, &exit_code] { exit_code = run_convert(*options); });
}

}  // namespace marey::cli
