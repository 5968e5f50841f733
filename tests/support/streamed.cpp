#include "tests/support/streamed.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/bvh/text_encoding.h"
#include "core/bvh/writer.h"
#include "tests/support/same_bits.h"

namespace marey::test {
namespace {

std::string listing_of(const Diagnostics& diagnostics) {
  std::string result;
  for (const Diagnostic& d : diagnostics.list()) {
    result += fmt::format("{}:{} {} x{}: {} [{}|{}]\n", d.place.line, d.place.column, diagnostic_id(d.code), d.count, d.message,
                          d.expected, d.found);
  }
  return result;
}

std::string listing_of(const Error& error) {
  return fmt::format("{}:{} {}: {}", error.place.line, error.place.column, diagnostic_id(error.code), error.message);
}

std::string listing_of(const std::vector<TextExcerpt>& excerpts) {
  std::string result;
  for (const TextExcerpt& excerpt : excerpts) {
    result += fmt::format("{} {} {}\n", excerpt.first_line, excerpt.marked_line, excerpt.marked_byte);
    for (const std::string& line : excerpt.lines) result += "  " + line + "\n";
  }
  return result;
}

std::string difference(std::string_view what, const std::string& whole, const std::string& streamed) {
  return whole == streamed ? "" : fmt::format("{}\nof the whole:\n{}\nstreamed:\n{}\n", what, whole, streamed);
}

std::string difference_of(const BvhClip& whole, const BvhClip& streamed) {
  if (!same_numbers(whole.skeleton, whole.motion, streamed.skeleton, streamed.motion)) return "the numbers differ";
  if (!(whole.skeleton == streamed.skeleton)) return "the skeletons differ";
  if (whole.position_rule != streamed.position_rule) return "the position rules differ";
  if (whole.names_in != streamed.names_in) return "the names are read differently";
  if (whole.declared_frames != streamed.declared_frames) return "the declared frames differ";
  std::string found = difference("findings", listing_of(whole.diagnostics), listing_of(streamed.diagnostics));
  if (!found.empty()) return found;
  return difference("text", write_bvh(whole.skeleton, whole.motion, whole.style),
                    write_bvh(streamed.skeleton, streamed.motion, streamed.style));
}

}  // namespace

std::string difference_when_streamed(std::string_view text, const StreamOptions& options, const NextPiece& next_piece,
                                     bool* was_streamed) {
  StreamReader reader({}, options);
  for (std::string_view left = text; !left.empty();) {
    const std::string piece(left.substr(0, next_piece()));  // a copy, so that reading beyond it is found
    left.remove_prefix(piece.size());
    if (!reader.feed(piece)) break;
  }
  if (was_streamed != nullptr) *was_streamed = reader.frame_count() > 0;
  const Result<BvhClip> streamed = reader.finish();
  const Result<BvhClip> whole = read_bvh(text);
  if (!whole || !streamed) {
    return difference("refusal", whole ? "none" : listing_of(whole.error()), streamed ? "none" : listing_of(streamed.error()));
  }
  std::string found = difference_of(*whole, *streamed);
  if (!found.empty()) return found;
  std::string converted;
  const std::string_view shown_text = text_in_utf8(text, converted);
  return difference("excerpts", listing_of(make_excerpts(shown_text, whole->diagnostics.places())), listing_of(reader.take_excerpts()));
}

}  // namespace marey::test
