#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/text_excerpt.h"
#include "core/bvh/clip_reader.h"
#include "core/bvh/report.h"
#include "core/bvh/row_reader.h"

namespace marey {

/// Reads the rows of a file while its text comes: part of StreamReader. Holds the beginning of the text, and of the rest
/// what is not read yet.
class StreamRows {
 public:
  /// `head`: the text so far. `options` are kept.
  StreamRows(std::string head, const ReadOptions& options, std::int64_t expected_bytes);
  StreamRows(const StreamRows&) = delete;
  StreamRows& operator=(const StreamRows&) = delete;

  enum class Start { Done, NeedsMore, Impossible };
  /// Reads the header and the first rows. Unless that is done, only take_head() may follow.
  [[nodiscard]] Start start();
  [[nodiscard]] std::string take_head() { return std::move(head_); }

  /// Takes more of the text; reads once `step` bytes wait.
  void feed(std::string_view text, std::size_t step);
  /// All is fed. Nothing of use when the report has failed.
  [[nodiscard]] BvhClip finish();
  /// Of each of the clip's diagnostics.
  [[nodiscard]] std::vector<TextExcerpt> find_excerpts(const Diagnostics& diagnostics) const;

  [[nodiscard]] Report& report() { return report_; }
  [[nodiscard]] int channel_count() const { return input_.channel_count; }
  [[nodiscard]] std::int64_t frame_count() const { return rows_ ? rows_->store().frame_count() : 0; }
  [[nodiscard]] BvhClip clip_so_far(std::int64_t most_samples) const;
  [[nodiscard]] std::int64_t held_bytes() const;

 private:
  [[nodiscard]] Start look_at_rows(std::string_view rows) const;
  void start_rows(std::string_view settled);
  void read_waiting();
  void forget_read_rows();
  void learn_commas(std::string_view rows);
  void note_excerpts();
  [[nodiscard]] std::size_t find_unusual(std::string_view text, std::size_t from);

  std::string head_;  ///< stays where it is: the header is views into it
  const ReadOptions& options_;
  std::int64_t expected_bytes_;
  Report report_;
  std::optional<ClipReader> clip_;
  RowsInput input_;
  std::optional<RowReader> rows_;
  std::string window_;             ///< the text from some line on that is not wholly read
  std::size_t window_begin_ = 0;   ///< in the file
  std::size_t looked_at_ = 0;      ///< bytes of the window that were looked at
  bool holds_rest_ = false;        ///< something unusual has come: nothing more is read before the end
  std::size_t noted_ = 0;          ///< findings that have their excerpt
  std::vector<std::pair<TextPlace, TextExcerpt>> excerpts_;
};

}  // namespace marey
