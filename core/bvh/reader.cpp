#include "core/bvh/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/base/bits.h"
#include "core/base/index.h"
#include "core/bvh/clip_findings.h"
#include "core/bvh/format_guess.h"
#include "core/bvh/hierarchy_build.h"
#include "core/bvh/hierarchy_text.h"
#include "core/bvh/motion_header.h"
#include "core/bvh/motion_rows.h"
#include "core/bvh/row_text.h"
#include "core/bvh/text_encoding.h"
#include "core/bvh/wide_blanks.h"
#include "core/text/readable.h"

namespace marey {
namespace {

std::string_view first_line_end(std::string_view text) {
  const std::size_t at = text.find_first_of("\r\n");
  if (at == std::string_view::npos) return "\n";
  return text.substr(at, 2) == "\r\n" ? "\r\n" : text.substr(at, 1);
}

HeaderStyle learn_header_style(std::string_view text, std::size_t begin, const HierarchyText& hierarchy) {
  constexpr std::size_t kMostNumbers = 1024;
  HeaderStyle style;
  TextCursor before(text, begin);
  pass_blanks_and_comments(before);
  style.before = text.substr(0, before.offset());
  style.line_end = first_line_end(text);
  std::vector<std::string_view> numbers;
  for (const RawBlock& block : hierarchy.blocks) {
    if (block.offset.count != 3 || numbers.size() > kMostNumbers) continue;
    for (const NumberSlot& slot : block.offset.values) numbers.push_back(text.substr(slot.begin, slot.length));
  }
  style.offset_format = guess_format(numbers, '.');
  style.indent = find_indent(text, hierarchy);
  return style;
}

/// Reads a header that was patched, followed by `rows`; its text is empty if it needs further repairs.
HeaderText read_header(std::string text, std::string_view rows, std::size_t begin, const ReadLimits& limits) {
  const std::size_t size = text.size();
  text += rows;
  Report report(text, false);
  TextCursor cursor(text, begin);
  HierarchyText words = read_hierarchy_text(cursor, limits, report);
  if (report.failed() || !words.patches.empty()) return {};
  Hierarchy hierarchy = build_hierarchy(text, std::move(words), limits, report);
  if (report.failed() || !hierarchy.patches.empty() || !hierarchy.open_offsets.empty()) return {};
  const MotionHeader header = read_motion_header(cursor, hierarchy.skeleton.channel_count(), report);
  if (report.failed() || !header.patches.empty() || header.data_begin != size) return {};
  text.resize(size);
  return {std::move(text), std::move(hierarchy.skeleton), std::move(hierarchy.offset_slots), header.frame_count_slot,
          header.frame_time_slot};
}

class BvhReader {
 public:
  BvhReader(const DecodedText& decoded, std::string_view bytes, std::size_t copied_bytes, const ReadOptions& options,
            Report& report)
      : text_(decoded.text),
        whole_text_(decoded.encoding == TextEncoding::Bytes ? bytes : std::string_view(decoded.converted)),
        text_bytes_(static_cast<std::int64_t>(bytes.size() + decoded.converted.capacity() + copied_bytes)),
        begin_(decoded.begin),
        options_(options),
        report_(report) {}

  BvhClip read();

 private:
  void read_hierarchy(TextCursor& cursor);
  void read_motion();
  void report_tail(std::size_t rows_end);
  void keep_style(MotionRows& rows);
  void keep_header();

  std::string_view text_;
  std::string_view whole_text_;  ///< with NUL bytes at its end
  std::int64_t text_bytes_;      ///< memory that it takes
  std::size_t begin_;
  const ReadOptions& options_;
  Report& report_;
  BvhClip clip_;
  Hierarchy hierarchy_;
  MotionHeader header_;
};

BvhClip BvhReader::read() {
  TextCursor cursor(text_, begin_);
  read_hierarchy(cursor);
  if (report_.failed()) return {};
  header_ = read_motion_header(cursor, hierarchy_.skeleton.channel_count(), report_);
  if (report_.failed()) return {};
  read_motion();
  if (report_.failed()) return {};
  settle_open_offsets(hierarchy_, clip_.motion, report_);
  keep_header();
  note_tree_habits(hierarchy_, report_);
  clip_.position_rule = settle_position_rule(hierarchy_, clip_.motion, report_);
  clip_.names_in = options_.names_in ? *options_.names_in : find_character_set_of_names(hierarchy_, report_);
  clip_.skeleton = std::move(hierarchy_.skeleton);
  clip_.skeleton.read_names_in(clip_.names_in);
  return std::move(clip_);
}

void BvhReader::read_hierarchy(TextCursor& cursor) {
  HierarchyText hierarchy = read_hierarchy_text(cursor, options_.limits, report_);
  if (report_.failed()) return;
  clip_.style.header = learn_header_style(whole_text_, begin_, hierarchy);
  hierarchy_ = build_hierarchy(text_, std::move(hierarchy), options_.limits, report_);
}

void BvhReader::read_motion() {
  const Skeleton& skeleton = hierarchy_.skeleton;
  RowsInput input;
  input.text = text_;
  input.data_begin = header_.data_begin;
  input.channel_count = skeleton.channel_count();
  input.declared_frames = header_.declared_frames;
  input.declared_place = header_.frame_count_slot.begin;
  input.line_end = clip_.style.header.line_end;
  input.text_bytes = text_bytes_;
  MotionRows rows = read_motion_rows(input, options_.limits, report_);
  if (report_.failed()) return;
  report_tail(rows.end);
  keep_style(rows);
  if (report_.failed()) return;
  if (header_.declared_frames.value_or(0) > 0 && *header_.declared_frames < rows.frame_count) {
    clip_.declared_frames = static_cast<int>(*header_.declared_frames);
  }
  clip_.motion = Motion(skeleton.channel_count(), rows.frame_count, header_.frame_time_s, std::move(rows.samples));
}

void BvhReader::report_tail(std::size_t rows_end) {
  const std::string_view behind = trimmed(text_.substr(rows_end));
  if (behind.empty()) return;
  report_.add(DiagnosticCode::TextAfterMotion, static_cast<std::size_t>(behind.data() - text_.data()),
              fmt::format("The text behind the motion, beginning with '{}', is kept as it is.",
                          shown(TextCursor(behind, 0).take_word())),
              "the end of the file", shown(behind));
}

/// Keeps copies of what stands before and behind the rows.
void BvhReader::keep_style(MotionRows& rows) {
  const std::size_t copied = header_.data_begin + whole_text_.size() - rows.end;
  const std::size_t sample_bytes = rows.samples.size() * sizeof(double);
  const std::int64_t all_bytes = text_bytes_ + static_cast<std::int64_t>(copied + sample_bytes);
  if (all_bytes > options_.limits.max_bytes) {
    report_.fail(DiagnosticCode::LimitMemory, rows.end,
                 fmt::format("The file needs {} bytes of memory; the limit is {}.", all_bytes, options_.limits.max_bytes));
    return;
  }
  BvhStyle& style = clip_.style;
  style.motion = std::move(rows.style);
  style.motion.tail = whole_text_.substr(rows.end);
  // In the line of the last row, text would be read as its surplus values.
  if (rows.lines_are_new && !trimmed(first_line(style.motion.tail)).empty()) style.motion.tail.insert(0, style.header.line_end);
}

/// Keeps the text before the rows if it says what was understood, or can be made to say it by edits here and there.
void BvhReader::keep_header() {
  HeaderPatches patches = hierarchy_.patches;
  patches.append(header_.patches);
  HeaderText& header = clip_.style.header_text;
  const std::string_view before_rows = whole_text_.substr(0, header_.data_begin);
  if (patches.empty()) {
    header = {std::string(before_rows), hierarchy_.skeleton, std::move(hierarchy_.offset_slots), header_.frame_count_slot,
              header_.frame_time_slot};
    return;
  }
  if (!patches.is_local()) return;
  const std::string& line_end = clip_.style.header.line_end;
  constexpr std::size_t kSomeRows = 4096;
  const std::string_view rows = text_.substr(header_.data_begin, kSomeRows);
  HeaderText patched = read_header(patches.applied_to(before_rows, line_end, clip_.motion.frame_count()), rows, begin_,
                                   options_.limits);
  const bool same_time = same_bits(patched.frame_time.value, clip_.motion.frame_time_s());
  if (same_time && patched.skeleton == hierarchy_.skeleton) header = std::move(patched);
}

}  // namespace

Result<BvhClip> read_bvh(std::string_view text, const ReadOptions& options) {
  DecodedText decoded;
  Report encoding_report(text, options.strict);
  if (static_cast<std::int64_t>(text.size()) > options.limits.max_bytes) {
    encoding_report.fail_without_place(
        DiagnosticCode::LimitMemory,
        fmt::format("The file has {} bytes; the limit is {}. Split the file.", text.size(), options.limits.max_bytes));
    return encoding_report.error();
  }
  decode_text(text, decoded, encoding_report);
  if (encoding_report.failed()) return readable(encoding_report.error());
  Report report(decoded.text, options.strict);
  report.take_over(encoding_report.take_diagnostics());
  const std::string plain = with_plain_blanks(decoded.text, decoded.begin, report);
  if (report.failed()) return readable(report.error());
  if (!plain.empty()) decoded.text = plain;
  BvhClip clip = BvhReader(decoded, text, plain.size(), options, report).read();
  if (report.failed()) return readable(report.error());
  clip.style.encoding = decoded.encoding;
  clip.diagnostics = report.take_diagnostics();
  return clip;
}

}  // namespace marey
