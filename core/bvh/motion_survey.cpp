#include "core/bvh/motion_survey.h"

#include <algorithm>
#include <map>

#include "core/base/index.h"
#include "core/bvh/comma_habit.h"
#include "core/bvh/format_guess.h"

namespace marey {
namespace {

constexpr int kMostLines = 32;
constexpr std::size_t kMostBytes = std::size_t{1} << 20;

/// The number of values that at least half of the lines have, `channel_count` in doubt; 0 if there is none.
int usual_value_count(const std::vector<std::string_view>& lines, int channel_count, const NumberLook& look) {
  std::map<int, int> lines_by_count;
  for (const std::string_view line : lines) ++lines_by_count[count_values(line, look)];
  int best = channel_count;
  int most = lines_by_count[channel_count];
  for (const auto& [count, frequency] : lines_by_count) {
    if (frequency > most) best = count;
    most = std::max(most, frequency);
  }
  return 2 * most >= size_of(lines) ? best : 0;
}

/// Judges a file whose usual line has `usual` values (0: there is no usual line), not one per channel.
RowLayout judge_odd_lines(std::string_view rows, const MotionSurvey& survey, int channel_count,
                          std::optional<std::int64_t> declared) {
  const int usual = survey.values_per_line;
  const RowCensus census = take_census(rows, survey.look);
  if (declared && census.values == *declared * channel_count) return RowLayout::Stream;
  if (usual == 0 || census.lines <= 1) return RowLayout::Stream;
  if (declared && census.lines == *declared) return RowLayout::CutLines;
  const bool multiple = usual < channel_count ? channel_count % usual == 0 : usual % channel_count == 0;
  return multiple ? RowLayout::Stream : RowLayout::CutLines;
}

/// Values of one row: views into the text, in the order of the channels.
using SampledRow = std::vector<std::string_view>;

/// The first rows that have one value per channel.
std::vector<SampledRow> sample_rows(std::string_view rows, int channel_count, const MotionSurvey& survey) {
  constexpr int kMostTokens = 4096;
  const int most_rows = std::clamp(kMostTokens / channel_count, 3, kMostLines);
  std::vector<SampledRow> result;
  std::string_view rest = rows.substr(0, kMostBytes);
  while (!rest.empty() && size_of(result) < most_rows) {
    const bool stream = survey.layout == RowLayout::Stream;
    std::string_view line = stream ? rest : first_line(rest);
    const char* line_end = line.data() + line.size();
    SampledRow row;
    for (;;) {
      line.remove_prefix(gap_length(line, survey.look));
      if (line.empty() || (stream && size_of(row) == channel_count)) break;
      row.push_back(line.substr(0, value_length(line, survey.look)));
      line.remove_prefix(row.back().size());
    }
    if (size_of(row) == channel_count) result.push_back(std::move(row));
    if (stream) line_end = line.data();
    rest.remove_prefix(std::min(rest.size(), static_cast<std::size_t>(line_end - rest.data()) + (stream ? 0 : 1)));
  }
  return result;
}

std::string gap_between(std::string_view before, std::string_view behind) {
  const char* begin = before.data() + before.size();
  return {begin, static_cast<std::size_t>(behind.data() - begin)};
}

std::vector<ColumnStyle> learn_columns(const std::vector<SampledRow>& rows, int channel_count, const NumberLook& look,
                                       std::string_view line_end) {
  std::vector<ColumnStyle> columns(idx(channel_count));
  columns[0].gap = line_end;
  const SampledRow& last = rows.back();
  for (int c = 1; c < channel_count; ++c) columns[idx(c)].gap = gap_between(last[idx(c) - 1], last[idx(c)]);
  for (std::size_t row = 1; row < rows.size(); ++row) {
    const std::string gap = gap_between(rows[row - 1].back(), rows[row].front());
    // Between sampled rows there may be others that have another length.
    if (gap_length(gap, look) == gap.size()) columns[0].gap = gap;
  }
  const std::vector<NumberFormat> formats = guess_formats(rows, look.point);
  for (int c = 0; c < channel_count; ++c) {
    ColumnStyle& column = columns[idx(c)];
    column.format = formats[idx(c)];
    if (column.gap.empty()) column.gap.assign(1, ' ');
  }
  return columns;
}

}  // namespace

MotionSurvey survey_rows(std::string_view rows, int channel_count, std::optional<std::int64_t> declared_frames,
                         std::string_view line_end) {
  MotionSurvey survey;
  survey.columns.resize(idx(channel_count));
  survey.columns.front().gap = line_end;
  const std::vector<std::string_view> lines = find_value_lines(rows, channel_count, kMostLines);
  survey.look = find_comma_habit(rows, lines, channel_count, declared_frames);
  survey.values_per_line = usual_value_count(lines, channel_count, survey.look);
  if (survey.values_per_line != channel_count && !lines.empty()) {
    survey.layout = judge_odd_lines(rows, survey, channel_count, declared_frames);
  }
  const bool cut = survey.layout == RowLayout::CutLines;
  const int sampled_values = cut ? survey.values_per_line : channel_count;
  const std::vector<SampledRow> sampled = sample_rows(rows, sampled_values, survey);
  if (!sampled.empty()) {
    survey.columns = learn_columns(sampled, sampled_values, survey.look, line_end);
    // Columns that no row shows look like the last one; those beyond the channels are left out with their values.
    survey.columns.resize(idx(channel_count), ColumnStyle(survey.columns.back()));
    const char* end = sampled.back().back().data() + sampled.back().back().size();
    survey.bytes_per_row = static_cast<double>(end - rows.data()) / static_cast<double>(sampled.size());
  }
  return survey;
}

}  // namespace marey
