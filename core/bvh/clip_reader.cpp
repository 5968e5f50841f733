#include "core/bvh/clip_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/base/bits.h"
#include "core/base/index.h"
#include "core/bvh/clip_findings.h"
#include "core/bvh/format_guess.h"
#include "core/bvh/hierarchy_text.h"
#include "core/bvh/row_text.h"

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
HeaderText read_patched_header(std::string text, std::string_view rows, std::size_t begin, const ReadLimits& limits) {
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

/// What the whole file says about the meaning of its parts.
void settle(Hierarchy& hierarchy, BvhClip& clip, const ReadOptions& options, Report& report) {
  note_tree_habits(hierarchy, report);
  clip.position_rule = settle_position_rule(hierarchy, clip.motion, report);
  clip.names_in = options.names_in ? *options.names_in : find_character_set_of_names(hierarchy, report);
  clip.skeleton = std::move(hierarchy.skeleton);
  clip.skeleton.read_names_in(clip.names_in);
}

}  // namespace

bool ClipReader::read_header() {
  TextCursor cursor(text_, begin_);
  HierarchyText hierarchy = read_hierarchy_text(cursor, options_.limits, report_);
  if (report_.failed()) return false;
  clip_.style.header = learn_header_style(file_text_, begin_, hierarchy);
  hierarchy_ = build_hierarchy(text_, std::move(hierarchy), options_.limits, report_);
  if (report_.failed()) return false;
  header_ = read_motion_header(cursor, hierarchy_.skeleton.channel_count(), report_);
  return !report_.failed();
}

RowsInput ClipReader::rows_input() const {
  RowsInput input;
  input.data_begin = header_.data_begin;
  input.channel_count = hierarchy_.skeleton.channel_count();
  input.declared_frames = header_.declared_frames;
  input.declared_place = header_.frame_count_slot.begin;
  input.line_end = clip_.style.header.line_end;
  return input;
}

BvhClip ClipReader::finish(MotionRows rows, const Tail& tail, std::int64_t text_bytes) {
  report_tail(tail.part);
  keep_style(rows, tail.file_text, text_bytes);
  if (report_.failed()) return {};
  if (header_.declared_frames.value_or(0) > 0 && *header_.declared_frames < rows.frame_count) {
    clip_.declared_frames = static_cast<int>(*header_.declared_frames);
  }
  const int channels = hierarchy_.skeleton.channel_count();
  clip_.motion = Motion(channels, rows.frame_count, header_.frame_time_s, std::move(rows.samples));
  settle_open_offsets(hierarchy_, clip_.motion, report_);
  keep_header();
  settle(hierarchy_, clip_, options_, report_);
  return std::move(clip_);
}

BvhClip ClipReader::clip_of(std::vector<double> samples, int frame_count) const {
  BvhClip clip;
  Hierarchy hierarchy = hierarchy_;
  Report unheard(text_, false);
  clip.style.header = clip_.style.header;
  clip.motion = Motion(hierarchy.skeleton.channel_count(), frame_count, header_.frame_time_s, std::move(samples));
  settle_open_offsets(hierarchy, clip.motion, unheard);
  settle(hierarchy, clip, options_, unheard);
  return clip;
}

void ClipReader::report_tail(TextPart tail) {
  const std::string_view behind = trimmed(tail.text);
  if (behind.empty()) return;
  report_.add(DiagnosticCode::TextAfterMotion, tail.begin + static_cast<std::size_t>(behind.data() - tail.text.data()),
              fmt::format("The text behind the motion, beginning with '{}', is kept as it is.",
                          shown(TextCursor(behind, 0).take_word())),
              "the end of the file", shown(behind));
}

/// Keeps copies of what stands before and behind the rows.
void ClipReader::keep_style(MotionRows& rows, std::string_view tail, std::int64_t text_bytes) {
  const std::size_t copied = header_.data_begin + tail.size();
  const std::size_t sample_bytes = rows.samples.size() * sizeof(double);
  const std::int64_t all_bytes = text_bytes + static_cast<std::int64_t>(copied + sample_bytes);
  if (all_bytes > options_.limits.max_bytes) {
    report_.fail(DiagnosticCode::LimitMemory, rows.end,
                 fmt::format("The file needs {} bytes of memory; the limit is {}.", all_bytes, options_.limits.max_bytes));
    return;
  }
  BvhStyle& style = clip_.style;
  style.motion = std::move(rows.style);
  style.motion.tail = tail;
  // In the line of the last row, text would be read as its surplus values.
  if (rows.lines_are_new && !trimmed(first_line(style.motion.tail)).empty()) style.motion.tail.insert(0, style.header.line_end);
}

/// Keeps the text before the rows if it says what was understood, or can be made to say it by edits here and there.
void ClipReader::keep_header() {
  HeaderPatches patches = hierarchy_.patches;
  patches.append(header_.patches);
  HeaderText& header = clip_.style.header_text;
  const std::string_view before_rows = file_text_.substr(0, header_.data_begin);
  if (patches.empty()) {
    header = {std::string(before_rows), hierarchy_.skeleton, std::move(hierarchy_.offset_slots), header_.frame_count_slot,
              header_.frame_time_slot};
    return;
  }
  if (!patches.is_local()) return;
  const std::string& line_end = clip_.style.header.line_end;
  constexpr std::size_t kSomeRows = 4096;
  const std::string_view rows = text_.substr(header_.data_begin, kSomeRows);
  HeaderText patched = read_patched_header(patches.applied_to(before_rows, line_end, clip_.motion.frame_count()), rows, begin_,
                                   options_.limits);
  const bool same_time = same_bits(patched.frame_time.value, clip_.motion.frame_time_s());
  if (same_time && patched.skeleton == hierarchy_.skeleton) header = std::move(patched);
}

}  // namespace marey
