#include "core/table/table_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/bits.h"
#include "core/base/counted.h"
#include "core/base/index.h"
#include "core/base/number_text.h"
#include "core/motion/frame_time.h"

namespace marey {
namespace {

using Code = DiagnosticCode;

/// Reads the numbers of a table, whose decimal sign its first number with decimals decides.
class NumberFields {
 public:
  explicit NumberFields(char separator) : may_have_commas_(separator != ',') {}

  /// Nothing where the field is no number.
  [[nodiscard]] std::optional<NumberRead> read(std::string_view text) {
    const bool has_comma = text.find(',') != std::string_view::npos;
    const bool has_point = text.find('.') != std::string_view::npos;
    if ((has_comma && (!may_have_commas_ || point_ == '.')) || (has_point && point_ == ',')) return std::nullopt;
    if (has_comma || has_point) point_ = has_comma ? ',' : '.';
    const NumberRead number = read_number(text, has_comma ? ',' : '.');
    return number.length == text.size() ? std::optional(number) : std::nullopt;
  }

 private:
  bool may_have_commas_;
  char point_ = '\0';  // not known yet
};

/// Takes the fields behind the last column away as far as they are empty.
void drop_surplus(std::vector<TableField>& fields, std::size_t count) {
  while (fields.size() > count && fields.back().text.empty()) fields.pop_back();
}

void report_gap(Code code, const TableField& field, const TableColumn& column, Report& report) {
  if (report.count_repeat(code)) return;
  report.add(code, field.offset,
             fmt::format("'{}' has no value here; that of the row before is used.", shown(column.name)), "a number",
             shown(field.text));
}

void take_field(const TableField& field, NumberFields& numbers, TableColumn& column, Report& report) {
  const double before = column.values.empty() ? column.value_before_first : column.values.back();
  if (field.text.empty()) {
    report_gap(Code::TableGap, field, column, report);
    column.values.push_back(before);
    return;
  }
  const std::optional<NumberRead> number = numbers.read(field.text);
  if (number && std::isfinite(number->value)) {
    column.values.push_back(number->value);
    return;
  }
  if (number || is_not_finite_text(field.text)) {
    report_gap(number ? Code::NumberRange : Code::NotFinite, field, column, report);
    column.values.push_back(before);
    return;
  }
  report.fail(Code::BadNumber, field.offset,
              fmt::format("In the column '{}' there should be a number, but there is '{}'.", shown(column.name),
                          shown(field.text)),
              "a number", shown(field.text));
}

/// False where the row is not to be used.
bool has_right_length(const std::vector<TableField>& fields, std::size_t count, bool is_cut, Report& report) {
  if (fields.size() == count) return true;
  const std::string found = counted(static_cast<std::int64_t>(fields.size()), "value");
  const std::string message = fmt::format("This row has {}, but there are {}.", found,
                                          counted(static_cast<std::int64_t>(count), "column"));
  if (is_cut && fields.size() < count) {
    report.add(Code::PartialFrame, fields.front().offset, "The last row is cut off; it is left out. " + message);
  } else {
    report.fail(Code::RowLength, fields.front().offset, message, counted(static_cast<std::int64_t>(count), "value"), found);
  }
  return false;
}

bool is_within_limits(int row_count, int columns_in_all, const ReadLimits& limits, std::size_t offset, Report& report) {
  if (row_count > limits.max_frames) {
    report.fail(Code::LimitFrames, offset, fmt::format("The table has more than {} rows.", limits.max_frames));
  } else if (std::int64_t{row_count} * columns_in_all * 8 * 2 > limits.max_sample_bytes) {
    report.fail(Code::LimitMemory, offset,
                fmt::format("{} rows of {} need more memory than {} bytes.", row_count, counted(columns_in_all, "value"),
                            limits.max_sample_bytes));
  }
  return !report.failed();
}

/// The double of which all times are whole multiples as Marey writes them.
std::optional<double> exact_step(const std::vector<double>& times) {
  if (times[0] != 0.0) return std::nullopt;
  for (std::size_t row = 1; row < times.size(); ++row) {
    if (!same_bits(static_cast<double>(row) * times[1], times[row])) return std::nullopt;
  }
  return times[1];
}

}  // namespace

std::vector<TableColumn> read_header(FieldReader& rows, Report& report) {
  std::vector<TableField> fields;
  std::vector<TableColumn> columns;
  if (rows.next_row(fields) && fields.size() == FieldReader::kMostFields) {
    report.fail(Code::LimitChannels, fields.front().offset,
                fmt::format("The table has {} columns or more.", FieldReader::kMostFields));
    return columns;
  }
  drop_surplus(fields, 0);
  for (const TableField& field : fields) {
    const std::string name = field.value();
    const ColumnName parts = split_unit(name);
    TableColumn column;
    column.header = name;
    column.name = parts.name;
    column.unit = parts.unit;
    column.offset = field.offset;
    columns.push_back(std::move(column));
  }
  const bool has_number = std::any_of(fields.begin(), fields.end(), [](const TableField& field) {
    return read_number(field.text).length == field.text.size() && !field.text.empty();
  });
  if (columns.empty() || has_number) {
    report.fail(Code::TableHeader, fields.empty() ? 0 : fields.front().offset,
                "The first row does not name the columns, such as frame,time,Hips.x,Hips.y,Hips.z.");
  }
  return columns;
}

void read_rows(FieldReader& rows, char separator, int columns_in_all, const ReadLimits& limits,
               std::vector<TableColumn>& columns, Report& report) {
  NumberFields numbers(separator);
  std::vector<TableField> fields;
  int row_count = 0;
  while (!report.failed() && rows.next_row(fields)) {
    drop_surplus(fields, columns.size());
    if (!has_right_length(fields, columns.size(), !rows.row_was_ended(), report)) continue;
    if (!is_within_limits(++row_count, columns_in_all, limits, fields.front().offset, report)) return;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (columns[i].is_wanted) take_field(fields[i], numbers, columns[i], report);
    }
  }
}

bool is_row_label(const TableColumn& column) {
  return equal_ignoring_case(column.name, "frame") || equal_ignoring_case(column.name, "time");
}

std::optional<std::size_t> find_time_column(const std::vector<TableColumn>& columns) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (equal_ignoring_case(columns[i].name, "time")) return i;
  }
  return std::nullopt;
}

double find_frame_time(const std::vector<TableColumn>& columns, int row_count, double fallback_s, Report& report) {
  const std::optional<std::size_t> column = find_time_column(columns);
  if (!column || row_count < 2) {
    report.add(Code::TableTimeMissing, column ? columns[*column].offset : 0,
               fmt::format("{}; {} s from frame to frame are assumed.",
                           column ? "There are less than two times" : "There is no column 'time'", fallback_s));
    return fallback_s;
  }
  const std::vector<double>& times = columns[*column].values;
  if (const std::optional<double> step = exact_step(times); step && is_frame_time(*step)) return *step;
  constexpr double kTolerance = 0.1;
  const double step = (times.back() - times.front()) / (row_count - 1);
  double largest = 0.0;
  int worst = 0;
  for (int row = 0; row < row_count; ++row) {
    const double away = std::abs(times[idx(row)] - times.front() - row * step);
    if (away > largest) worst = row;
    largest = std::max(largest, away);
  }
  if (!(step > 0.0) || !std::isfinite(step) || largest > kTolerance * step) {
    report.fail(Code::TableTimeUneven, columns[*column].offset,
                fmt::format("The times do not rise evenly: row {} is off by {:.3g} s from steps of {:.6g} s.", worst + 1,
                            largest, step));
  } else if (!is_frame_time(step)) {
    report.fail(Code::FrameTimeLooksLikeRate, columns[*column].offset,
                fmt::format("The times rise by {:.6g} s from row to row; frames take less than {} s.", step, kFrameTimeEndS));
  } else if (largest > 1e-9 * step) {
    report.add(Code::TableTimeRounded, columns[*column].offset,
               fmt::format("The times are rounded; their mean step of {:.9g} s is used.", step));
  }
  return step;
}

}  // namespace marey
