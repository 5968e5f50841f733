#include "cli/table_input.h"

#include "cli/files.h"
#include "cli/report.h"
#include "core/table/csv_reader.h"

namespace marey::cli {

std::optional<BvhClip> read_table(const Input& input, const std::string& figure) {
  const std::optional<std::string> text = read_bytes(input.file);
  if (!text) return std::nullopt;
  std::optional<BvhClip> with_figure;
  if (!figure.empty()) {
    with_figure = read_clip_for_use({.file = figure, .strict = input.strict, .limits = input.limits, .names_in = input.names_in, .as_json = false});
    if (!with_figure) return std::nullopt;
  }
  const TableOptions options{.strict = input.strict, .limits = input.limits};
  Result<BvhClip> clip = with_figure ? read_channel_table(*text, *with_figure, options) : read_points_table(*text, options);
  if (!clip) {
    report_error(input.file, clip.error());
    return std::nullopt;
  }
  report_diagnostics(input.file, clip->diagnostics);
  return std::move(*clip);
}

}  // namespace marey::cli
