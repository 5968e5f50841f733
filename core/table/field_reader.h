#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace marey {

/// A field of a table, as it stands in the text.
struct TableField {
  std::string_view text;      ///< without blanks around it; of a quoted field what is between the quotes
  std::size_t offset = 0;     ///< of its first byte in the text
  bool has_quotes = false;    ///< doubled quotes within stand for one

  /// The text as it is meant.
  [[nodiscard]] std::string value() const;
};

/// Reads a text of comma-separated values row by row: CR, LF and CRLF end a row, quotes may hold separators and line
/// ends, rows of nothing but blanks and separators are passed over. The text must outlive the reader.
class FieldReader {
 public:
  /// Of a row with more fields, such as a text of nothing but separators, so many are kept, the last of them with text.
  static constexpr std::size_t kMostFields = 400'000;

  FieldReader(std::string_view text, std::size_t offset, char separator)
      : text_(text), offset_(offset), separator_(separator) {}

  /// The fields of the next row; false at the end of the text.
  [[nodiscard]] bool next_row(std::vector<TableField>& fields);
  /// Where the next row begins.
  [[nodiscard]] std::size_t offset() const { return offset_; }
  /// True if the last row that was read ended with a line end.
  [[nodiscard]] bool row_was_ended() const { return row_was_ended_; }

 private:
  void read_fields(std::vector<TableField>& fields);
  [[nodiscard]] TableField read_field();
  [[nodiscard]] TableField read_quoted_field();

  std::string_view text_;
  std::size_t offset_;
  char separator_;
  bool row_was_ended_ = true;
};

/// Where the table begins: behind a byte order mark, lines that begin with '#', and Excel's "sep=;".
[[nodiscard]] std::size_t find_table_start(std::string_view text);

/// ',', ';' or a tab: the one that gives the first row a field "frame" or "time"; else the one that gives most fields.
[[nodiscard]] char find_separator(std::string_view text, std::size_t offset);

/// A column's name without the unit that stands behind it: "Hips.Xposition [cm]" is "Hips.Xposition" and "cm".
struct ColumnName {
  std::string_view name;
  std::string_view unit;  ///< empty when there is none
};
[[nodiscard]] ColumnName split_unit(std::string_view name);

}  // namespace marey
