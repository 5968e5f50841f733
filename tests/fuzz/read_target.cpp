#include <algorithm>

#include "core/bvh/reader.h"
#include "tests/fuzz/input_bytes.h"
#include "tests/fuzz/soundness.h"
#include "tests/support/same_bits.h"

namespace marey::test {
namespace {

/// Bits 0 to 2 of the byte: a character set, or a guess. Bit 3: limits so low that small files reach them.
ReadOptions options_of(int byte) {
  ReadOptions options;
  const auto set = idx(byte & 7);
  if (set < kCharacterSets.size()) options.names_in = kCharacterSets[set];
  if ((byte & 8) != 0) options.limits = {3, 3, 7, 4, 160, 4096};
  return options;
}

Harm find_broken_limit(const BvhClip& clip, const ReadLimits& limits) {
  // Repairs make joints of end sites and of blocks without a joint, each of which have the same limit.
  if (clip.skeleton.joint_count() > 3 * limits.max_joints) return "more joints than the limit";
  if (clip.skeleton.channel_count() > limits.max_channels) return "more channels than the limit";
  if (clip.motion.frame_count() > limits.max_frames) return "more frames than the limit";
  if (static_cast<std::int64_t>(clip.motion.samples().size_bytes()) > limits.max_sample_bytes) return "more samples than the limit";
  for (JointIndex joint = 0; joint < clip.skeleton.joint_count(); ++joint) {
    if (clip.skeleton.depth(joint) > limits.max_depth) return "deeper than the limit";
  }
  return std::nullopt;
}

/// A strict reader takes what a lenient one takes without a finding that is to be refused, and takes it for the same.
Harm find_harm_in_strictness(const Result<BvhClip>& lenient, const Result<BvhClip>& strict) {
  if (!lenient) return strict ? Harm("strict reading takes what lenient reading refuses") : std::nullopt;
  const auto& findings = lenient->diagnostics.list();
  const auto refused = std::find_if(findings.begin(), findings.end(), [](const Diagnostic& finding) {
    return traits_of(finding.code).refused_when_strict;
  });
  if (strict && refused != findings.end()) return "strict reading takes " + std::string(diagnostic_id(refused->code));
  if (!strict && refused == findings.end()) return "strict reading refuses what has no finding: " + strict.error().message;
  if (!strict) return std::nullopt;
  const bool same = lenient->skeleton == strict->skeleton &&
                    same_numbers(lenient->skeleton, lenient->motion, strict->skeleton, strict->motion);
  return same ? std::nullopt : Harm("strict and lenient reading give different clips");
}

}  // namespace

Harm find_harm_in_reading(std::string_view input) {
  InputBytes bytes(input);
  ReadOptions options = options_of(bytes.take_byte());
  const std::string_view text = bytes.rest();
  const Result<BvhClip> lenient = read_bvh(text, options);
  options.strict = true;
  const Result<BvhClip> strict = read_bvh(text, options);
  for (const Result<BvhClip>* clip : {&lenient, &strict}) {
    Harm harm = *clip ? find_harm_in_clip(**clip, text) : find_harm_in_refusal(clip->error(), text);
    if (harm) return harm;
    if (*clip) harm = find_broken_limit(**clip, options.limits);
    if (harm) return harm;
  }
  return find_harm_in_strictness(lenient, strict);
}

}  // namespace marey::test
