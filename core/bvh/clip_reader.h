#pragma once

#include <string_view>

#include "core/bvh/bvh_clip.h"
#include "core/bvh/hierarchy_build.h"
#include "core/bvh/motion_header.h"
#include "core/bvh/motion_rows.h"
#include "core/bvh/reader.h"

namespace marey {

/// Reads what stands before the rows, and makes the clip once the rows are read. What is given must outlive it.
class ClipReader {
 public:
  /// `text`, to be read from its byte `begin` on, holds all before the rows and some of them; `file_text` is the same as the
  /// file has it, where blanks of `text` stand for others.
  ClipReader(std::string_view text, std::string_view file_text, std::size_t begin, const ReadOptions& options, Report& report)
      : text_(text), file_text_(file_text), begin_(begin), options_(options), report_(report) {}

  /// False if the report has failed.
  [[nodiscard]] bool read_header();
  /// Precondition of all that follows: read_header().
  [[nodiscard]] std::size_t data_begin() const { return header_.data_begin; }
  /// What the rows are read with, but for part, rows_bytes and text_bytes.
  [[nodiscard]] RowsInput rows_input() const;

  /// What the file holds behind the rows.
  struct Tail {
    TextPart part;               ///< without NUL bytes at the end of the file
    std::string_view file_text;  ///< as the file has it
  };
  /// The clip; nothing of use when the report has failed. `text_bytes` is the memory that the text takes.
  [[nodiscard]] BvhClip finish(MotionRows rows, const Tail& tail, std::int64_t text_bytes);

  /// The figure with the frames that are known: channel-major samples, `frame_count` of each channel. Findings are not kept.
  [[nodiscard]] BvhClip clip_of(std::vector<double> samples, int frame_count) const;

 private:
  void report_tail(TextPart tail);
  void keep_style(MotionRows& rows, std::string_view tail, std::int64_t text_bytes);
  void keep_header();

  std::string_view text_;
  std::string_view file_text_;
  std::size_t begin_;
  const ReadOptions& options_;
  Report& report_;
  BvhClip clip_;
  Hierarchy hierarchy_;
  MotionHeader header_;
};

}  // namespace marey
