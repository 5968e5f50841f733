#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/bvh/limits.h"
#include "core/bvh/report.h"
#include "core/table/field_reader.h"

namespace marey {

/// What a column of a table is read into.
struct TableColumn {
  std::string header;               ///< as in the first row
  std::string name;                 ///< the same without its unit
  std::string unit;
  std::size_t offset = 0;           ///< of the name in the text
  bool is_wanted = true;            ///< else its fields are passed over
  double value_before_first = 0.0;  ///< for gaps in the first row
  std::vector<double> values;       ///< one per row
};

/// The columns of the header; empty names are those of surplus separators. Fails where there is no header.
[[nodiscard]] std::vector<TableColumn> read_header(FieldReader& rows, Report& report);

/// Reads all rows into the wanted columns. Gaps (empty fields, "nan") take the value of the row before. A row of another
/// length, or a field that is no number, fails with its place; but a last row that was cut off is left out and reported.
/// `columns_in_all` columns of as many rows must stay within the limits.
/// Numbers have a point, or a comma where the separator is another character; not both in one table.
void read_rows(FieldReader& rows, char separator, int columns_in_all, const ReadLimits& limits,
               std::vector<TableColumn>& columns, Report& report);

/// Index of the column "time", in any case.
[[nodiscard]] std::optional<std::size_t> find_time_column(const std::vector<TableColumn>& columns);
/// True for "frame" and "time".
[[nodiscard]] bool is_row_label(const TableColumn& column);

/// Seconds from row to row. When the times are whole multiples of a double, as those of a table written by Marey, that
/// double exactly; else the mean step, from which no time may be off by more than a tenth of it. `fallback_s` where there
/// is no such column, or less than two rows. Fails where times are uneven, or rise by what
/// is no is_frame_time().
[[nodiscard]] double find_frame_time(const std::vector<TableColumn>& columns, int row_count, double fallback_s,
                                     Report& report);

}  // namespace marey
