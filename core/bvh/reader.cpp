#include "core/bvh/reader.h"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "core/bvh/clip_reader.h"
#include "core/bvh/text_encoding.h"
#include "core/bvh/wide_blanks.h"
#include "core/text/readable.h"

namespace marey {
namespace {

BvhClip read_decoded(const DecodedText& decoded, std::string_view bytes, std::size_t copied_bytes, const ReadOptions& options,
                     Report& report) {
  const std::string_view file_text = decoded.encoding == TextEncoding::Bytes ? bytes : std::string_view(decoded.converted);
  ClipReader reader(decoded.text, file_text, decoded.begin, options, report);
  if (!reader.read_header()) return {};
  RowsInput input = reader.rows_input();
  input.part = {decoded.text, 0};
  input.rows_bytes = static_cast<std::int64_t>(decoded.text.size() - reader.data_begin());
  input.text_bytes = static_cast<std::int64_t>(bytes.size() + decoded.converted.capacity() + copied_bytes);
  MotionRows rows = read_motion_rows(input, options.limits, report);
  if (report.failed()) return {};
  const std::size_t end = rows.end;
  const ClipReader::Tail tail{{decoded.text.substr(end), end}, file_text.substr(end)};
  return reader.finish(std::move(rows), tail, input.text_bytes);
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
  BvhClip clip = read_decoded(decoded, text, plain.size(), options, report);
  if (report.failed()) return readable(report.error());
  clip.style.encoding = decoded.encoding;
  clip.diagnostics = report.take_diagnostics();
  return clip;
}

}  // namespace marey
