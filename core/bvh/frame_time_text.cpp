#include "core/bvh/frame_time_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/base/number_text.h"
#include "core/bvh/row_text.h"
#include "core/motion/frame_time.h"

namespace marey {
namespace {

enum class Measure { Seconds, Milliseconds, PerSecond };

struct Unit {
  std::string_view text;
  Measure measure;
};

constexpr std::array<Unit, 14> kUnits = {{{"s", Measure::Seconds},
                                          {"sec", Measure::Seconds},
                                          {"secs", Measure::Seconds},
                                          {"second", Measure::Seconds},
                                          {"seconds", Measure::Seconds},
                                          {"f", Measure::Seconds},
                                          {";", Measure::Seconds},
                                          {",", Measure::Seconds},
                                          {"ms", Measure::Milliseconds},
                                          {"msec", Measure::Milliseconds},
                                          {"milliseconds", Measure::Milliseconds},
                                          {"hz", Measure::PerSecond},
                                          {"fps", Measure::PerSecond},
                                          {"frames/s", Measure::PerSecond}}};

std::optional<Measure> find_measure(std::string_view text) {
  const auto unit = std::find_if(kUnits.begin(), kUnits.end(),
                                 [text](const Unit& known) { return equal_ignoring_case(known.text, text); });
  return unit == kUnits.end() ? std::nullopt : std::optional<Measure>(unit->measure);
}

double in_seconds(double value, Measure measure) {
  switch (measure) {
    case Measure::Milliseconds: return value / 1000.0;
    case Measure::PerSecond: return 1.0 / value;
    case Measure::Seconds: break;
  }
  return value;
}

/// A number and what is written to it.
struct Written {
  std::size_t length = 0;  ///< of both; 0 where nothing more than the number stands there, or nothing that is known
  double seconds = 0.0;
};

/// What a unit or a fraction makes of the number that `line` begins with.
Written with_unit(std::string_view line, std::string_view word, const NumberRead& number) {
  const std::string_view behind = word.substr(number.length);
  if (!behind.empty() && behind.front() == '/') {
    const NumberRead divisor = read_number(behind.substr(1));
    const bool is_fraction = divisor.length > 0 && divisor.length + 1 == behind.size() && divisor.value > 0.0;
    return is_fraction ? Written{word.size(), number.value / divisor.value} : Written{};
  }
  if (!behind.empty()) {
    const auto measure = find_measure(behind);
    return measure ? Written{word.size(), in_seconds(number.value, *measure)} : Written{};
  }
  TextCursor next(line, word.size());
  next.skip_blanks_in_line();
  const auto measure = next.at_end() ? std::nullopt : find_measure(next.peek_word());
  return measure ? Written{next.offset() + next.peek_word().size(), in_seconds(number.value, *measure)} : Written{};
}

double take_written(const Written& written, std::string_view line, TextCursor& cursor, HeaderPatches& patches, Report& report) {
  const std::size_t place = cursor.offset();
  std::string text;
  append_number(written.seconds, NumberFormat{}, text);
  patches.replace(place, written.length, text);
  report.add(DiagnosticCode::UnexpectedToken, place,
             fmt::format("The frame time '{}' was read as {} s.", shown(line.substr(0, written.length)), text),
             "a number of seconds", shown(line.substr(0, written.length)));
  cursor.move_to(place + written.length);
  return written.seconds;
}

/// A time that is kept although it can hardly be meant.
void report_unlikely(double seconds, std::string_view word, std::size_t place, Report& report) {
  constexpr double kLongestLikely = 1.0;
  constexpr double kShortestLikely = 1e-4;
  if (seconds <= kLongestLikely && seconds >= kShortestLikely) return;
  report.add(DiagnosticCode::FrameTimeLooksLikeRate, place,
             fmt::format("Frame Time {} means {:.4g} frames per second, which is used. Another unit may have been meant.",
                         shown(word), 1.0 / seconds),
             "seconds per frame", shown(word));
}

}  // namespace

double read_frame_time(TextCursor& cursor, double fallback_s, HeaderPatches& patches, Report& report) {
  const std::size_t place = cursor.offset();
  constexpr std::size_t kFarthestUnit = 64;  // behind the number; a line may be as long as the file
  const std::string_view word = cursor.peek_word();
  const std::string_view line = first_line(cursor.rest().substr(0, word.size() + kFarthestUnit));
  const std::size_t comma_at = word.find(',');
  const bool comma = comma_at < word.size() - 1 && word.find('.') == std::string_view::npos;
  const NumberRead number = read_number(word, comma ? ',' : '.');
  const Written written = number.length > 0 ? with_unit(line, word, number) : Written{};
  if (written.length > 0 && is_frame_time(written.seconds)) return take_written(written, line, cursor, patches, report);
  cursor.take_word();
  if (comma) {
    report.add(DiagnosticCode::DecimalComma, place,
               fmt::format("'{}' has a decimal comma, which was read as a point.", shown(word)), "a decimal point",
               shown(word));
  }
  if (number.length != word.size() || !std::isfinite(number.value) || !(number.value > 0.0)) {
    report.add(DiagnosticCode::FrameTimeNotPositive, place,
               fmt::format("Frame Time '{}' is no time; 1/30 of a second is used.", shown(word)), "seconds per frame",
               shown(word));
    return fallback_s;
  }
  if (number.value >= kFrameTimeEndS) {
    report.add(DiagnosticCode::FrameTimeLooksLikeRate, place,
               fmt::format("Frame Time {} looks like frames per second; 1/{} of a second is used.", shown(word), shown(word)),
               "seconds per frame", shown(word));
    return 1.0 / number.value;
  }
  report_unlikely(number.value, word, place, report);
  return number.value;
}

}  // namespace marey
