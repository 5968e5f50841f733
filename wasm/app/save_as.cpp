#include "wasm/app/save_as.h"

#include <fmt/format.h>

#include <utility>

#include "core/base/counted.h"
#include "core/interchange/export.h"
#include "core/motion/resampling.h"
#include "core/table/csv.h"
#include "wasm/app/builtin_commands.h"

namespace marey::app {
namespace {

std::string stem_of(const Document& document) {
  std::string name = download_name(document.file_name());
  return name.substr(0, name.size() - 4);
}

FrameRange frames_of(const Document& document, const SaveAs& wanted) {
  const FrameRange frames = wanted.options.frames;
  return frames.count > 0 ? frames : FrameRange{0, document.motion().frame_count()};
}

/// The wanted frames for the wanted target.
Result<ExportedClip> export_wanted(const Document& document, const SaveAs& wanted) {
  if (wanted.options.frames.count == 0) return export_for_target(document.clip(), *wanted.target);
  const Clip part{document.skeleton(), trimmed(document.motion(), wanted.options.frames), document.settings()};
  return export_for_target(part, *wanted.target);
}

SaveOptions without_frames(SaveOptions options) {
  options.frames = {};
  return options;
}

std::string write_table(const Document& document, const SaveAs& wanted) {
  std::string text;
  const FrameRange frames = frames_of(document, wanted);
  if (wanted.form == SavedForm::ChannelTable) {
    append_channel_header(document.skeleton(), text);
    append_channel_rows(document.motion(), frames, text);
  } else {
    append_position_header(document.skeleton(), text);
    append_position_rows(document.skeleton(), document.motion(), frames, document.settings().position_rule, text);
  }
  return text;
}

void describe_frames(const Document& document, const SaveAs& wanted, std::vector<std::string>& lines) {
  const int left_out = document.motion().frame_count() - frames_of(document, wanted).count;
  if (left_out > 0) lines.push_back(fmt::format("{} {} left out.", counted(left_out, "frame"), left_out == 1 ? "is" : "are"));
}

void describe_decimals(const Document& document, const SaveAs& wanted, std::vector<std::string>& lines) {
  if (!wanted.options.decimals) return;
  const RoundingCost cost =
      measure_rounding(document.skeleton(), document.motion(), wanted.options.frames, *wanted.options.decimals);
  const std::string decimals = counted(*wanted.options.decimals, "decimal");
  lines.push_back(cost.numbers == 0
                      ? fmt::format("Every number fits {}; none changes.", decimals)
                      : fmt::format("{} {} rounded to {}, by {:.2g} degrees or units at most.", counted(cost.numbers, "number"),
                                    cost.numbers == 1 ? "is" : "are", decimals, cost.largest));
}

bool is_export(const SaveAs& wanted) { return wanted.form == SavedForm::Bvh && wanted.target.has_value(); }

/// `exported`: the clip for the wanted target, null without one.
std::vector<std::string> list_differences(const Document& document, const SaveAs& wanted, const ExportedClip* exported) {
  std::vector<std::string> lines;
  const Changes changes = document.find_changes();
  if (!changes.empty()) lines.push_back("Your changes: " + describe(changes) + ".");
  describe_frames(document, wanted, lines);
  if (wanted.form != SavedForm::Bvh) {
    lines.emplace_back(wanted.form == SavedForm::ChannelTable
                           ? "A table holds the samples in degrees and file units; the skeleton is not in it."
                           : "A table holds the world positions of all joints in file units; the skeleton is not in it.");
    return lines;
  }
  if (exported != nullptr) {
    for (const ExportChange& change : exported->changes) lines.push_back(change.message);
    if (const std::string_view remark = traits_of(*wanted.target).remark; !remark.empty()) lines.emplace_back(remark);
  }
  describe_decimals(document, wanted, lines);
  if (wanted.options.line_end) {
    lines.push_back(fmt::format("Every line ends with {}.", *wanted.options.line_end == LineEnd::Lf ? "LF" : "CR LF"));
  }
  return lines;
}

}  // namespace

std::string copy_name(const Document& document, const SaveAs& wanted) {
  const std::string stem = stem_of(document);
  switch (wanted.form) {
    case SavedForm::ChannelTable: return stem + "-channels.csv";
    case SavedForm::PositionTable: return stem + "-positions.csv";
    case SavedForm::Bvh: break;
  }
  return wanted.target ? fmt::format("{}-{}.bvh", stem, traits_of(*wanted.target).id) : stem + ".bvh";
}

std::vector<std::string> describe_copy(const Document& document, const SaveAs& wanted) {
  if (!is_export(wanted)) return list_differences(document, wanted, nullptr);
  const Result<ExportedClip> exported = export_wanted(document, wanted);
  if (!exported) return {exported.error().message};
  return list_differences(document, wanted, &*exported);
}

Result<Copy> make_copy(const Document& document, const SaveAs& wanted) {
  if (!is_export(wanted)) {
    std::string bytes = wanted.form == SavedForm::Bvh ? document.save_text(wanted.options) : write_table(document, wanted);
    return Copy{std::move(bytes), list_differences(document, wanted, nullptr)};
  }
  const Result<ExportedClip> exported = export_wanted(document, wanted);
  if (!exported) return exported.error();
  return Copy{write_exported(*exported, without_frames(wanted.options)), list_differences(document, wanted, &*exported)};
}

nlohmann::json arguments_of(const SaveAs& wanted) {
  constexpr const char* kForms[] = {"bvh", "channels", "positions"};
  nlohmann::json args = {{"form", kForms[static_cast<int>(wanted.form)]}};
  if (wanted.target) args["target"] = traits_of(*wanted.target).id;
  if (wanted.options.decimals) args["decimals"] = *wanted.options.decimals;
  if (wanted.options.line_end) args["lineEnds"] = *wanted.options.line_end == LineEnd::Lf ? "lf" : "crlf";
  if (wanted.options.frames.count > 0) {
    args["first"] = wanted.options.frames.first;
    args["count"] = wanted.options.frames.count;
  }
  return args;
}

bool is_whole(const SaveAs& wanted) {
  return wanted.form == SavedForm::Bvh && !wanted.target && wanted.options.frames.count == 0 && !wanted.options.decimals;
}

}  // namespace marey::app
