#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/fixed_numbers.h"
#include "core/base/number_spelling.h"
#include "core/bvh/motion_rows.h"
#include "core/bvh/motion_survey.h"
#include "core/bvh/odd_tokens.h"
#include "core/bvh/sample_store.h"

namespace marey {

/// Reads one row after the other. A row that looks as the survey predicts costs one pass over its bytes (row_reader.cpp);
/// any other is read again with care (irregular_rows.cpp), which is where every repair is.
class RowReader {
 public:
  /// `limits` and `report` are kept.
  RowReader(const RowsInput& input, const ReadLimits& limits, MotionSurvey survey, Report& report);

  /// Reads the rest of the rows; the part ends with the file.
  void read_all();
  /// Reads rows as far as what follows the part cannot change what they mean. The part ends behind a line end, and holds
  /// the first row wholly.
  void read_some();
  /// Goes on in `part`, which begins where the one before did or at a line that begins before offset().
  void move_to(TextPart part);
  /// Commas and semicolons among the rows that are left mean what `look` says.
  void set_look(const NumberLook& look) { survey_.look = look; }

  [[nodiscard]] std::size_t part_end() const { return input_.part.begin + input_.part.text.size(); }
  /// Behind the last value.
  [[nodiscard]] std::size_t offset() const { return offset_of(at_); }
  [[nodiscard]] const MotionSurvey& survey() const { return survey_; }
  [[nodiscard]] const SampleStore& store() const { return store_; }
  [[nodiscard]] MotionRows take_result();

 private:
  /// What the hot loop wants to know about a column, in one cache line's reach.
  struct HotColumn {
    std::uint64_t gap_word = 0;  ///< the gap's bytes
    std::uint64_t gap_mask = 0;
    int gap_length = 0;
    PlainSpelling spelling;
    int run_length = 1;                ///< columns from here on that `run` reads,
    std::optional<FixedNumbers> run;   ///< if it reads any
  };

  /// How the values of an irregular row lie.
  struct RowPlan {
    int value_count = 0;             ///< values to read, at most one per channel
    bool regular = true;             ///< nothing is added or left out
    bool partial = false;            ///< the last row, cut off
    const char* drop_to = nullptr;   ///< where to go on when values are left out
  };

  [[nodiscard]] bool is_predictable() const { return frames() > 0 && !all_declared_read(); }
  bool is_settled();
  [[nodiscard]] std::size_t begin_of_last_lines(int lines) const;
  void prepare_columns();
  void find_runs();
  bool read_predicted_row();
  const char* read_run(const char* p, const HotColumn& column, double* values);
  const char* read_predicted_value(const char* p, int channel, double& value);
  const char* read_unpredicted_value(const char* p, int channel, double& value);
  [[nodiscard]] bool text_is_predicted(int channel, double value, std::string_view gap, std::string_view number) const;

  bool read_irregular_row();
  const char* skip_gap(const char* p, bool& line_ends);
  bool ends_here(const char* p);
  [[nodiscard]] bool is_text_between_rows(const char* p) const;
  void report_passed_text(const char* p, std::string_view text, bool is_comment);
  bool surplus_rows_are_frames(const char* p);
  bool settle_line_remainder(const char* p);
  RowPlan plan_row(const char* p, bool shares_line);
  RowPlan plan_short_line(const char* p, int count);
  RowPlan plan_stream_row(const char* p);
  void read_values(const char* p, const RowPlan& plan);
  const char* read_value(const char* p, int channel, double& value, bool& kept_as_written);
  double replace_value(const char* p, std::string_view word, int channel, DiagnosticCode code);
  void drop_partial_row(const RowPlan& plan, const char* p);
  void report_row_length(const char* p, int found);
  void report_frame_count();
  void check_limits();
  void fail_beyond_limit();

  [[nodiscard]] std::string_view rest(const char* p) const { return {p, static_cast<std::size_t>(end_ - p)}; }
  [[nodiscard]] std::size_t offset_of(const char* p) const {
    return input_.part.begin + static_cast<std::size_t>(p - input_.part.text.data());
  }
  [[nodiscard]] std::int64_t frames() const { return store_.frame_count(); }
  /// True once all frames that the header declares are read; false when it declares none.
  [[nodiscard]] bool all_declared_read() const { return input_.declared_frames && frames() >= *input_.declared_frames; }
  [[nodiscard]] std::string_view word_at(const char* p) const {
    return rest(p).substr(0, value_length(rest(p), survey_.look));
  }

  RowsInput input_;
  const ReadLimits& limits_;
  MotionSurvey survey_;
  Report& report_;
  int channel_count_;
  const char* at_;   ///< behind the last value
  const char* end_;
  std::size_t shared_line_end_ = 0;  ///< several frames stand in the line that ends here
  std::optional<std::size_t> settled_end_;  ///< see is_settled()
  bool rows_ended_ = false;
  std::int64_t sample_frames_;  ///< frames that memory has room for
  std::int64_t most_frames_;
  std::optional<bool> keeps_surplus_rows_;  ///< once all declared frames are read: whether rows behind them are frames
  bool repaired_ = false;  ///< the rows as written are not the rows as read
  std::vector<HotColumn> hot_columns_;
  int failed_runs_ = 0;        ///< in a row
  SampleStore store_;
  OddTokens odd_tokens_;
};

/// False, with the reason in `report`, if the file surely has more frames than memory has room for: told before any is taken.
[[nodiscard]] bool rows_fit(const RowsInput& input, const ReadLimits& limits, const MotionSurvey& survey, Report& report);

}  // namespace marey
