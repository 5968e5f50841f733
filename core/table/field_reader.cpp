#include "core/table/field_reader.h"

#include <algorithm>
#include <array>

#include "core/base/text_cursor.h"

namespace marey {
namespace {

bool is_empty_row(const std::vector<TableField>& fields) {
  return std::all_of(fields.begin(), fields.end(), [](const TableField& field) { return field.text.empty(); });
}

std::size_t end_of_line(std::string_view text, std::size_t offset) {
  const std::size_t end = text.find_first_of("\r\n", offset);
  if (end == std::string_view::npos) return text.size();
  return text.substr(end, 2) == "\r\n" ? end + 2 : end + 1;
}

bool is_time_or_frame(const TableField& field) {
  const std::string name = field.value();
  const std::string_view plain = split_unit(name).name;
  return equal_ignoring_case(plain, "frame") || equal_ignoring_case(plain, "time");
}

}  // namespace

std::string TableField::value() const {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    result += text[i];
    if (has_quotes && text.substr(i, 2) == "\"\"") ++i;
  }
  return result;
}

bool FieldReader::next_row(std::vector<TableField>& fields) {
  do {
    fields.clear();
    if (offset_ >= text_.size()) return false;
    read_fields(fields);
  } while (is_empty_row(fields));
  return true;
}

void FieldReader::read_fields(std::vector<TableField>& fields) {
  while (true) {
    const TableField field = read_field();
    if (fields.size() < kMostFields) {
      fields.push_back(field);
    } else if (!field.text.empty()) {
      fields.back() = field;
    }
    const char end = offset_ < text_.size() ? text_[offset_] : '\0';
    row_was_ended_ = offset_ < text_.size();
    if (end != separator_ || !row_was_ended_) break;
    ++offset_;
  }
  offset_ = std::min(text_.size(), end_of_line(text_, offset_));
}

TableField FieldReader::read_field() {
  std::size_t begin = offset_;
  const auto is_gap = [this](char c) { return c != separator_ && (c == ' ' || c == '\t'); };
  while (begin < text_.size() && is_gap(text_[begin])) ++begin;
  if (begin < text_.size() && text_[begin] == '"') {
    offset_ = begin;
    return read_quoted_field();
  }
  const std::array<char, 3> ends = {separator_, '\r', '\n'};
  offset_ = std::min(text_.size(), text_.find_first_of(std::string_view(ends.data(), ends.size()), begin));
  std::size_t end = offset_;
  while (end > begin && is_gap(text_[end - 1])) --end;
  return {text_.substr(begin, end - begin), begin, false};
}

TableField FieldReader::read_quoted_field() {
  const std::size_t begin = offset_ + 1;
  std::size_t end = begin;
  bool has_quotes = false;
  while (end < text_.size() && (text_[end] != '"' || text_.substr(end, 2) == "\"\"")) {
    has_quotes = has_quotes || text_[end] == '"';
    end += text_[end] == '"' ? 2U : 1U;
  }
  end = std::min(end, text_.size());
  offset_ = end;
  while (offset_ < text_.size() && text_[offset_] != separator_ && !is_line_end(text_[offset_])) ++offset_;
  return {text_.substr(begin, end - begin), begin, has_quotes};
}

std::size_t find_table_start(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  std::size_t offset = text.substr(0, kByteOrderMark.size()) == kByteOrderMark ? kByteOrderMark.size() : 0;
  if (equal_ignoring_case(text.substr(offset, 4), "sep=")) offset = end_of_line(text, offset);
  while (offset < text.size() && (text[offset] == '#' || is_line_end(text[offset]))) offset = end_of_line(text, offset);
  return offset;
}

char find_separator(std::string_view text, std::size_t offset) {
  char best = ',';
  std::size_t most = 0;
  for (const char separator : {',', ';', '\t'}) {
    std::vector<TableField> fields;
    if (!FieldReader(text, offset, separator).next_row(fields)) continue;
    const bool is_known = std::any_of(fields.begin(), fields.end(), is_time_or_frame);
    const std::size_t score = fields.size() + (is_known ? text.size() : 0);
    if (score > most) best = separator;
    most = std::max(most, score);
  }
  return best;
}

ColumnName split_unit(std::string_view name) {
  const std::size_t open = name.rfind('[');
  if (name.empty() || name.back() != ']' || open == std::string_view::npos || open == 0) return {name, {}};
  return {trimmed(name.substr(0, open)), trimmed(name.substr(open + 1, name.size() - open - 2))};
}

}  // namespace marey
