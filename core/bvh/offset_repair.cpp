#include "core/bvh/offset_repair.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/counted.h"
#include "core/base/index.h"
#include "core/base/number_text.h"

namespace marey {
namespace {

struct Word {
  std::string text;
  double value = 0.0;
};
using Words = std::vector<Word>;

OffsetReading reading_of(const Words& words) {
  OffsetReading reading;
  for (int axis = 0; axis < 3; ++axis) {
    const Word word = axis < size_of(words) ? words[idx(axis)] : Word{"0", 0.0};
    reading.offset[axis] = word.value;
    reading.text += (axis > 0 ? " " : "") + word.text;
  }
  return reading;
}

bool is_whole(std::string_view word, bool sign_allowed) {
  if (sign_allowed && !word.empty() && word.front() == '-') word.remove_prefix(1);
  return !word.empty() && std::all_of(word.begin(), word.end(), is_digit);
}

/// Joins word i with word i + 1 wherever bit i of `joints` is set; empty when some pair cannot be a cut number.
Words joined(const Words& words, unsigned joints) {
  Words result;
  for (int i = 0; i < size_of(words); ++i) {
    if ((joints >> i & 1U) == 0) {
      result.push_back(words[idx(i)]);
      continue;
    }
    const bool overlaps = (joints >> (i + 1) & 1U) != 0;
    const std::string& before = words[idx(i)].text;
    const std::string& behind = words[idx(i + 1)].text;
    if (overlaps || !is_whole(before, true) || !is_whole(behind, false)) return {};
    const std::string text = before + "." + behind;
    const NumberRead number = read_number(text);
    if (number.out_of_range) return {};
    result.push_back({text, number.value});
    ++i;
  }
  return result;
}

void add_if_new(const OffsetReading& reading, std::vector<OffsetReading>& readings) {
  const bool known = std::any_of(readings.begin(), readings.end(),
                                 [&](const OffsetReading& other) { return other.offset == reading.offset; });
  if (!known) readings.push_back(reading);
}

void add_joined_readings(const Words& words, std::vector<OffsetReading>& readings) {
  const unsigned pairs = static_cast<unsigned>(words.size()) - 1;
  for (unsigned joints = 1; joints < 1U << pairs; ++joints) {
    const Words result = joined(words, joints);
    if (result.size() == 3) add_if_new(reading_of(result), readings);
  }
}

void add_readings_without_a_zero(const Words& words, std::vector<OffsetReading>& readings) {
  for (int i = 0; i < size_of(words); ++i) {
    if (words[idx(i)].value != 0.0) continue;
    Words rest = words;
    rest.erase(rest.begin() + i);
    add_if_new(reading_of(rest), readings);
  }
}

}  // namespace

std::vector<OffsetReading> find_offset_readings(std::string_view text, const OffsetRead& offset) {
  Words words;
  for (const NumberSlot& slot : offset.values) words.push_back({std::string(text.substr(slot.begin, slot.length)), slot.value});
  std::vector<OffsetReading> readings;
  const bool all_seen = offset.count == size_of(words);
  if (all_seen && offset.count > 3) add_joined_readings(words, readings);
  if (all_seen && offset.count == 4 && readings.empty()) add_readings_without_a_zero(words, readings);
  if (readings.empty()) readings.push_back(reading_of(words));
  return readings;
}

void patch_offset(const OffsetRead& offset, std::size_t keyword_end, const OffsetReading& reading, HeaderPatches& patches) {
  const std::size_t begin = offset.values.empty() ? keyword_end : offset.values.front().begin;
  patches.replace(begin, offset.end - begin, (offset.values.empty() ? " " : "") + reading.text);
}

void report_offset_reading(std::string_view owner, std::size_t place, int value_count, const OffsetReading& reading,
                           Report& report) {
  report.add_each(DiagnosticCode::OffsetValueCount, place,
                  fmt::format("The OFFSET of {} has {}; it was read as {}.", owner, counted(value_count, "value"),
                              reading.text),
                  "3 values", counted(value_count, "value"));
}

}  // namespace marey
