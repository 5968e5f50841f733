#include "tests/fuzz/soundness.h"

#include <algorithm>
#include <cmath>

#include "core/bvh/text_encoding.h"
#include "core/motion/frame_time.h"
#include "core/text/readable.h"
#include "core/text/utf8.h"

namespace marey::test {
namespace {

bool is_sentence(std::string_view text) { return text.size() > 10 && text.back() == '.' && is_utf8(text); }

bool is_in_text(TextPlace place, std::string_view bytes) {
  std::string converted;
  const auto size = static_cast<std::int64_t>(text_in_utf8(bytes, converted).size());
  return place.line >= 0 && place.column >= 0 && place.line <= size + 1 && place.column <= size + 1;
}

bool is_finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

Harm find_harm_in_skeleton(const Skeleton& skeleton) {
  if (skeleton.joint_count() == 0) return "a figure without joints";
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    if (skeleton.parent(joint) >= joint) return "a parent behind its child";
    if (skeleton.subtree_end(joint) <= joint || skeleton.subtree_end(joint) > skeleton.joint_count()) return "a subtree that is none";
  }
  for (const Node& node : skeleton.nodes()) {
    if (!is_finite(node.offset)) return "an offset that is not finite";
    if (!is_utf8(node.name)) return "a name that is not UTF-8";
  }
  return std::nullopt;
}

Harm find_harm_in_findings(const BvhClip& clip, std::string_view text) {
  const Diagnostics shown = readable(clip.diagnostics, clip.names_in);
  for (const Diagnostic& finding : shown.list()) {
    const std::string id(diagnostic_id(finding.code));
    if (!is_sentence(finding.message)) return id + ": no sentence: " + finding.message;
    if (!is_utf8(finding.expected) || !is_utf8(finding.found)) return id + ": no UTF-8";
    if (finding.count < 1) return id + ": counted 0 times";
    if (!is_in_text(finding.place, text)) return id + ": a place outside of the text";
  }
  return std::nullopt;
}

}  // namespace

Harm find_harm_in_refusal(const Error& error, std::string_view text) {
  if (!is_sentence(error.message)) return "a refusal without a sentence: " + error.message;
  if (!is_utf8(error.expected) || !is_utf8(error.found)) return "a refusal that is not UTF-8";
  if (!is_in_text(error.place, text)) return "a refusal with a place outside of the text";
  return std::nullopt;
}

Harm find_harm_in_clip(const BvhClip& clip, std::string_view text) {
  const Motion& motion = clip.motion;
  const auto samples = motion.samples();
  if (motion.channel_count() != clip.skeleton.channel_count()) return "channels of figure and motion differ in number";
  if (samples.size() != idx(motion.channel_count()) * idx(motion.frame_count())) return "samples are missing";
  if (!std::all_of(samples.begin(), samples.end(), [](double v) { return std::isfinite(v); })) return "a sample that is not finite";
  if (!is_frame_time(motion.frame_time_s())) return "a frame time that is none";
  const bool declares_more = clip.declared_frames != 0 && clip.declared_frames >= motion.frame_count();
  if (clip.declared_frames < 0 || declares_more) return "declared frames that are not fewer than those there are";
  if (Harm harm = find_harm_in_skeleton(clip.skeleton)) return harm;
  return find_harm_in_findings(clip, text);
}

bool same_tree(const Skeleton& a, const Skeleton& b) {
  const auto same_node = [](const Node& x, const Node& y) {
    return x.joint == y.joint && x.parent == y.parent && x.is_end_site == y.is_end_site;
  };
  const auto same_channel = [](const Channel& x, const Channel& y) { return x.joint == y.joint && x.kind == y.kind; };
  return std::equal(a.nodes().begin(), a.nodes().end(), b.nodes().begin(), b.nodes().end(), same_node) &&
         std::equal(a.channels().begin(), a.channels().end(), b.channels().begin(), b.channels().end(), same_channel);
}

}  // namespace marey::test
