#include "core/table/csv_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/base/counted.h"
#include "core/skeleton/skeleton_builder.h"
#include "core/table/csv.h"
#include "core/table/table_rows.h"
#include "core/text/readable.h"

namespace marey {
namespace {

using Code = DiagnosticCode;

constexpr double kDefaultFrameTime_s = 1.0 / 30.0;

/// The axis that a column of a point names, -1 for none.
int axis_of_point(std::string_view name) {
  if (name.size() < 2 || name[name.size() - 2] != '.') return -1;
  const char letter = to_lower_ascii(name.back());
  return letter >= 'x' && letter <= 'z' ? letter - 'x' : -1;
}

bool is_channel(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  return dot != std::string_view::npos && find_channel_kind(name.substr(dot + 1)).has_value();
}

enum class Quantity { Time, Angle, Length, Any };

Quantity quantity_of(ChannelKind kind) {
  if (is_position(kind)) return Quantity::Length;
  return is_rotation(kind) ? Quantity::Angle : Quantity::Any;
}

/// Refuses units in which the values would mean something else.
void check_unit(const TableColumn& column, Quantity quantity, Report& report) {
  constexpr std::array<std::string_view, 6> kLengths = {"m", "cm", "mm", "in", "ft", "unit"};
  const auto is_unit = [&column](std::string_view unit) { return equal_ignoring_case(column.unit, unit); };
  const bool is_length = std::any_of(kLengths.begin(), kLengths.end(), is_unit);
  const bool is_known = column.unit.empty() || quantity == Quantity::Any || (quantity == Quantity::Time && is_unit("s")) ||
                        (quantity == Quantity::Angle && is_unit("deg")) || (quantity == Quantity::Length && is_length);
  if (is_known) return;
  constexpr std::array<std::string_view, 3> kWanted = {"s", "deg", "m, cm, mm, in, ft or unit"};
  const std::string_view wanted = kWanted[static_cast<std::size_t>(quantity)];
  report.fail(Code::TableUnit, column.offset,
              fmt::format("The unit of '{}' is '{}'; {} can be read.", shown(column.name), shown(column.unit), wanted),
              std::string(wanted), shown(column.unit));
}

/// A text with its header read.
struct Table {
  char separator;
  FieldReader rows;
  std::vector<TableColumn> columns;
};

Table open_table(std::string_view text, Report& report) {
  const std::size_t start = find_table_start(text);
  const char separator = find_separator(text, start);
  Table table{separator, FieldReader(text, start, separator), {}};
  if (text.find('\0') != std::string_view::npos) {
    report.fail(Code::UnsupportedEncoding, 0, "The table is not UTF-8 text; save it as UTF-8.");
    return table;
  }
  table.columns = read_header(table.rows, report);
  for (TableColumn& column : table.columns) {
    column.is_wanted = equal_ignoring_case(column.name, "time");
    if (column.is_wanted) check_unit(column, Quantity::Time, report);
  }
  return table;
}

void report_unknown(const std::vector<TableColumn>& columns, Report& report) {
  for (const TableColumn& column : columns) {
    if (column.is_wanted || is_row_label(column) || column.name.empty()) continue;
    report.add(Code::TableColumnUnknown, column.offset,
               fmt::format("The column '{}' is no channel or point; it is left out.", shown(column.name)));
  }
}

int row_count_of(const Table& table) {
  std::size_t rows = 0;
  for (const TableColumn& column : table.columns) rows = std::max(rows, column.values.size());
  return static_cast<int>(rows);
}

/// For each channel of a figure the column it is read from, or -1.
std::vector<int> match_columns(const Skeleton& skeleton, std::vector<TableColumn>& columns, Report& report) {
  std::unordered_map<std::string, std::vector<ChannelIndex>> channels;
  for (ChannelIndex channel = skeleton.channel_count() - 1; channel >= 0; --channel) {
    channels[channel_column_name(skeleton, channel)].push_back(channel);
  }
  std::vector<int> column_of(idx(skeleton.channel_count()), -1);
  for (int i = 0; i < size_of(columns); ++i) {
    TableColumn& column = columns[idx(i)];
    // What looks like a unit may be part of a name.
    auto found = channels.find(column.header);
    if (found == channels.end()) found = channels.find(column.name);
    if (found == channels.end() || found->second.empty()) continue;
    const ChannelIndex channel = found->second.back();
    found->second.pop_back();
    column_of[idx(channel)] = i;
    column.is_wanted = true;
    const ChannelKind kind = skeleton.channel(channel).kind;
    check_unit(column, quantity_of(kind), report);
  }
  return column_of;
}

void report_missing(const BvhClip& figure, const std::vector<int>& column_of, Report& report) {
  const auto missing = std::count(column_of.begin(), column_of.end(), -1);
  if (missing == 0) return;
  if (missing == static_cast<std::ptrdiff_t>(column_of.size())) {
    report.fail(Code::TableColumnMissing, 0, "No column of the table is a channel of the figure, such as 'Hips.Xposition'.");
    return;
  }
  const auto first = std::find(column_of.begin(), column_of.end(), -1) - column_of.begin();
  report.add(Code::TableColumnMissing, 0,
             fmt::format("{} no column, '{}' first; {}.",
                         counted(missing, "channel") + (missing == 1 ? " has" : " have"),
                         shown(channel_column_name(figure.skeleton, static_cast<ChannelIndex>(first))),
                         figure.motion.frame_count() > 0 ? "the value of the figure's first frame is used" : "0 is used"));
}

double first_value(const BvhClip& figure, ChannelIndex channel) {
  return figure.motion.frame_count() > 0 ? figure.motion.sample(channel, 0) : 0.0;
}

Motion motion_of(const BvhClip& figure, const std::vector<int>& column_of, const Table& table, double frame_time_s) {
  const int rows = row_count_of(table);
  Motion motion(size_of(column_of), rows, frame_time_s);
  for (ChannelIndex channel = 0; channel < motion.channel_count(); ++channel) {
    const std::span<double> samples = motion.channel_samples(channel);
    const int column = column_of[idx(channel)];
    if (column < 0) {
      std::fill(samples.begin(), samples.end(), first_value(figure, channel));
    } else {
      const std::vector<double>& values = table.columns[idx(column)].values;
      std::copy(values.begin(), values.end(), samples.begin());
    }
  }
  return motion;
}

/// A point and its columns.
struct Point {
  std::string name;
  std::vector<std::pair<int, int>> axes_and_columns;
};

std::vector<Point> find_points(std::vector<TableColumn>& columns, Report& report) {
  std::vector<Point> points;
  std::map<std::string, std::size_t, std::less<>> last_of_name;
  for (int i = 0; i < size_of(columns); ++i) {
    TableColumn& column = columns[idx(i)];
    const int axis = axis_of_point(column.name);
    if (axis < 0) continue;
    column.is_wanted = true;
    check_unit(column, Quantity::Length, report);
    const std::string name = column.name.substr(0, column.name.size() - 2);
    const auto known = last_of_name.find(name);
    const auto has_axis = [axis](const auto& entry) { return entry.first == axis; };
    const bool is_new = known == last_of_name.end() ||
                        std::any_of(points[known->second].axes_and_columns.begin(),
                                    points[known->second].axes_and_columns.end(), has_axis);
    if (is_new) {
      last_of_name[name] = points.size();
      points.push_back({name, {}});
    }
    points[last_of_name[name]].axes_and_columns.emplace_back(axis, i);
  }
  if (!points.empty() || report.failed()) return points;
  const bool has_channels = std::any_of(columns.begin(), columns.end(), [](const TableColumn& c) { return is_channel(c.name); });
  report.fail(Code::TableKind, columns.front().offset,
              has_channels ? "The table holds channels; say which BVH file has their figure."
                           : "No column names a coordinate of a point, such as 'Hips.x'.");
  return points;
}

Result<Skeleton> skeleton_of(const std::vector<Point>& points) {
  SkeletonBuilder builder;
  for (const Point& point : points) {
    builder.open_joint(point.name);
    for (const auto& [axis, column] : point.axes_and_columns) builder.add_channel(static_cast<ChannelKind>(axis));
    builder.close_joint();
  }
  return builder.build();
}

}  // namespace

Result<BvhClip> read_channel_table(std::string_view text, const BvhClip& figure, const TableOptions& options) {
  Report report(text, options.strict);
  Table table = open_table(text, report);
  if (report.failed()) return readable(report.error());
  const std::vector<int> column_of = match_columns(figure.skeleton, table.columns, report);
  report_missing(figure, column_of, report);
  report_unknown(table.columns, report);
  for (ChannelIndex channel = 0; channel < size_of(column_of); ++channel) {
    const int column = column_of[idx(channel)];
    if (column >= 0) table.columns[idx(column)].value_before_first = first_value(figure, channel);
  }
  read_rows(table.rows, table.separator, figure.skeleton.channel_count(), options.limits, table.columns, report);
  if (report.failed()) return readable(report.error());
  const double frame_time_s = find_frame_time(table.columns, row_count_of(table), figure.motion.frame_time_s(), report);
  if (report.failed()) return readable(report.error());
  BvhClip clip;
  clip.skeleton = figure.skeleton;
  clip.style = figure.style;
  clip.position_rule = figure.position_rule;
  clip.names_in = figure.names_in;
  clip.motion = motion_of(figure, column_of, table, frame_time_s);
  clip.diagnostics = report.take_diagnostics();
  return clip;
}

Result<BvhClip> read_points_table(std::string_view text, const TableOptions& options) {
  Report report(text, options.strict);
  Table table = open_table(text, report);
  if (report.failed()) return readable(report.error());
  const std::vector<Point> points = find_points(table.columns, report);
  if (report.failed()) return readable(report.error());
  report_unknown(table.columns, report);
  if (size_of(points) > options.limits.max_joints) {
    report.fail(Code::LimitJoints, 0, fmt::format("The table has more than {} points.", options.limits.max_joints));
    return readable(report.error());
  }
  Result<Skeleton> skeleton = skeleton_of(points);
  if (!skeleton) return skeleton.error();
  read_rows(table.rows, table.separator, skeleton->channel_count(), options.limits, table.columns, report);
  if (report.failed()) return readable(report.error());
  const int rows = row_count_of(table);
  const double frame_time_s = find_frame_time(table.columns, rows, kDefaultFrameTime_s, report);
  if (report.failed()) return readable(report.error());
  std::vector<double> samples;
  for (const Point& point : points) {
    for (const auto& [axis, column] : point.axes_and_columns) {
      const std::vector<double>& values = table.columns[idx(column)].values;
      samples.insert(samples.end(), values.begin(), values.end());
    }
  }
  BvhClip clip;
  clip.motion = Motion(skeleton->channel_count(), rows, frame_time_s, std::move(samples));
  clip.skeleton = std::move(*skeleton);
  clip.diagnostics = report.take_diagnostics();
  return clip;
}

}  // namespace marey
