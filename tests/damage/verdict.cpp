#include "tests/damage/verdict.h"

#include <fmt/format.h>

#include "core/bvh/reader.h"
#include "core/bvh/writer.h"
#include "tests/damage/heap_peak.h"
#include "tests/fuzz/soundness.h"
#include "tests/support/same_bits.h"

namespace marey::test {

void Verdict::add(std::string_view bytes) {
  for (const char byte : bytes) hash_ = (hash_ ^ static_cast<unsigned char>(byte)) * 1099511628211U;
}

template <class T>
void Verdict::add_value(const T& value) {
  add({reinterpret_cast<const char*>(&value), sizeof value});
}

Harm Verdict::take(std::string_view text) {
  ++texts_;
  if (Harm harm = take(text, false)) return harm;
  return take(text, true);
}

Harm Verdict::take(std::string_view text, bool strict) {
  const HeapPeak peak;
  const Result<BvhClip> clip = read_bvh(text, {.strict = strict, .limits = {}});
  if (peak.bytes() > most_bytes(text.size())) return fmt::format("{} bytes of memory for {}", peak.bytes(), text.size());
  if (!clip) {
    refused_ += strict ? 0 : 1;
    add(diagnostic_id(clip.error().code));
    add_value(clip.error().place);
    return find_harm_in_refusal(clip.error(), text);
  }
  for (const double sample : clip->motion.samples()) add_value(sample);
  for (const Node& node : clip->skeleton.nodes()) add(node.name);
  for (const Diagnostic& finding : clip->diagnostics.list()) {
    add(diagnostic_id(finding.code));
    add_value(finding.place);
    add_value(finding.count);
  }
  if (Harm harm = find_harm_in_clip(*clip, text)) return harm;
  if (strict) return std::nullopt;
  const std::string written = write_bvh(clip->skeleton, clip->motion, clip->style);
  add(written);
  const Result<BvhClip> again = read_bvh(written);
  if (!again) return "what was written is refused: " + again.error().message + "\n" + written;
  const bool same = same_numbers(clip->skeleton, clip->motion, again->skeleton, again->motion);
  return same ? std::nullopt : Harm("what was written says something else\n" + written);
}

}  // namespace marey::test
