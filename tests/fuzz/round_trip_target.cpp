#include <algorithm>

#include "core/bvh/joint_name.h"
#include "core/bvh/reader.h"
#include "core/bvh/save_options.h"
#include "core/bvh/writer.h"
#include "tests/fuzz/input_bytes.h"
#include "tests/fuzz/soundness.h"
#include "tests/support/same_bits.h"

namespace marey::test {
namespace {

SaveOptions take_options(InputBytes& bytes, int frame_count) {
  SaveOptions options;
  const int byte = bytes.take_byte();
  if ((byte & 16) != 0) options.decimals = byte % (kMostSavedDecimals + 1);
  if ((byte & 32) != 0) options.line_end = (byte & 64) != 0 ? LineEnd::Lf : LineEnd::CrLf;
  options.frames.first = bytes.take_below(frame_count);
  options.frames.count = bytes.take_below(frame_count - options.frames.first + 1);
  return options;
}

bool same_clip(const BvhClip& a, const BvhClip& b) { return same_numbers(a.skeleton, a.motion, b.skeleton, b.motion); }

/// Names as they were; where the hierarchy had to be printed anew, as they can be printed.
bool same_names(const Skeleton& read, const Skeleton& again) {
  if (read == again) return true;
  return same_tree(read, again) && std::equal(read.nodes().begin(), read.nodes().end(), again.nodes().begin(), [](const Node& a, const Node& b) {
    return b.name_bytes == a.name_bytes || b.name_bytes == printable_joint_name(a.name_bytes);
  });
}

Harm find_harm_in_own_style(const BvhClip& clip, std::string_view text) {
  const std::string written = write_bvh(clip.skeleton, clip.motion, clip.style);
  const Result<BvhClip> again = read_bvh(written);
  if (!again) return "what was written is refused: " + again.error().message + "\n" + written;
  if (!same_clip(clip, *again)) return "what was written says something else\n" + written;
  if (!same_names(clip.skeleton, again->skeleton)) return "what was written names something else\n" + written;
  if (written != write_bvh(again->skeleton, again->motion, again->style)) return "written twice it differs\n" + written;
  const bool is_flawless = clip.diagnostics.count(Severity::Warning) + clip.diagnostics.count(Severity::Error) == 0;
  if (written == text || !is_flawless) return std::nullopt;
  return "a flawless file does not come out byte for byte\n" + written;
}

Harm find_harm_in_plain_style(const BvhClip& clip) {
  const std::string written = write_bvh(clip.skeleton, clip.motion, {});
  const Result<BvhClip> again = read_bvh(written);
  if (!again) return "the plain form is refused: " + again.error().message + "\n" + written;
  if (!same_clip(clip, *again)) return "the plain form says something else\n" + written;
  return same_tree(clip.skeleton, again->skeleton) ? std::nullopt : Harm("the plain form has another tree\n" + written);
}

Harm find_harm_in_saving(const BvhClip& clip, const SaveOptions& options) {
  const std::string written = write_bvh(clip.skeleton, clip.motion, clip.style, options);
  const Result<BvhClip> again = read_bvh(written);
  if (!again) return "what was saved is refused: " + again.error().message + "\n" + written;
  const FrameRange frames = options.frames.count > 0 ? options.frames : FrameRange{0, clip.motion.frame_count()};
  if (again->motion.frame_count() != frames.count) return "what was saved has other frames\n" + written;
  if (!same_tree(clip.skeleton, again->skeleton)) return "what was saved has another tree\n" + written;
  if (options.decimals) return std::nullopt;
  for (ChannelIndex channel = 0; channel < clip.motion.channel_count(); ++channel) {
    const auto kept = clip.motion.channel_samples(channel).subspan(idx(frames.first), idx(frames.count));
    const auto saved = again->motion.channel_samples(channel);
    if (!std::equal(kept.begin(), kept.end(), saved.begin(), saved.end())) return "what was saved says something else\n" + written;
  }
  return std::nullopt;
}

}  // namespace

Harm find_harm_in_round_trip(std::string_view input) {
  constexpr std::size_t kOptionBytes = 3;
  InputBytes choices(input.substr(0, kOptionBytes));
  const std::string_view text = input.substr(std::min(kOptionBytes, input.size()));
  const Result<BvhClip> clip = read_bvh(text);
  if (!clip) return std::nullopt;
  if (Harm harm = find_harm_in_own_style(*clip, text)) return harm;
  if (Harm harm = find_harm_in_plain_style(*clip)) return harm;
  return find_harm_in_saving(*clip, take_options(choices, clip->motion.frame_count()));
}

}  // namespace marey::test
