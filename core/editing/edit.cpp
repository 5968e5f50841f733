#include "core/editing/edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>

#include "core/base/bits.h"
#include "core/biomechanics/body_model.h"
#include "core/motion/frame_time.h"

namespace marey {
namespace {

Error refusal(DiagnosticCode code, std::string message) { return Error{code, {}, std::move(message), {}, {}}; }

Status check_samples(const Motion& motion, const SamplesChange& change) {
  if (change.channel < 0 || change.channel >= motion.channel_count()) {
    return refusal(DiagnosticCode::InvalidArgument,
                   fmt::format("The clip has no channel {}.", std::int64_t{change.channel} + 1));
  }
  if (change.first < 0 || change.first > motion.frame_count() ||
      change.values.size() > idx(motion.frame_count() - change.first)) {
    return refusal(DiagnosticCode::InvalidArgument,
                   fmt::format("The change reaches beyond the {} frames of the clip.", motion.frame_count()));
  }
  const std::span<const double> present = motion.channel_samples(change.channel).subspan(idx(change.first));
  for (std::size_t i = 0; i < change.values.size(); ++i) {
    if (!std::isfinite(change.values[i]) && std::isfinite(present[i])) {
      return refusal(DiagnosticCode::NotFinite,
                     fmt::format("Frame {} would get a value that is not a finite number.", idx(change.first) + i + 1));
    }
  }
  return {};
}

Status check_offset(const Skeleton& skeleton, const OffsetChange& change) {
  if (change.node < 0 || change.node >= skeleton.node_count()) {
    return refusal(DiagnosticCode::InvalidArgument,
                   fmt::format("The figure has no node {}.", std::int64_t{change.node} + 1));
  }
  const glm::dvec3& offset = change.offset;
  if (!std::isfinite(offset.x) || !std::isfinite(offset.y) || !std::isfinite(offset.z)) {
    return refusal(DiagnosticCode::NotFinite, "The offset is not made of finite numbers.");
  }
  return {};
}

std::int64_t count_missing(std::span<const double> samples) {
  return std::count_if(samples.begin(), samples.end(), [](double value) { return !std::isfinite(value); });
}

// Frames that give way may take their missing samples along; a change makes no more of them in any channel.
bool inserts_more_missing(const Motion& motion, const FramesChange& change) {
  if (count_missing(change.inserted.samples()) == 0) return false;
  for (ChannelIndex channel = 0; channel < motion.channel_count(); ++channel) {
    const auto removed = motion.channel_samples(channel).subspan(idx(change.removed.first), idx(change.removed.count));
    if (count_missing(change.inserted.channel_samples(channel)) > count_missing(removed)) return true;
  }
  return false;
}

Status check_frames(const Clip& clip, const Edit& edit) {
  const FramesChange& change = *edit.frames;
  const Motion& motion = clip.motion;
  const FrameRange removed = change.removed;
  if (removed.first < 0 || removed.count < 0 || removed.first > motion.frame_count() ||
      removed.count > motion.frame_count() - removed.first) {
    return refusal(DiagnosticCode::InvalidArgument,
                   fmt::format("The clip has {} frames; the change reaches beyond them.", motion.frame_count()));
  }
  const bool fits = change.inserted.frame_count() == 0 || change.inserted.channel_count() == motion.channel_count();
  if (!fits || size_of(change.file_frames) != change.inserted.frame_count() || !edit.samples.empty()) {
    return refusal(DiagnosticCode::InvalidArgument, "The frames to insert do not fit the clip.");
  }
  if (motion.frame_count() > 0 && motion.frame_count() - removed.count + change.inserted.frame_count() == 0) {
    return refusal(DiagnosticCode::InvalidArgument, "A clip keeps one frame at least.");
  }
  if (inserts_more_missing(motion, change)) {
    return refusal(DiagnosticCode::NotFinite, "The frames to insert hold a value that is not a finite number.");
  }
  return {};
}

Status check_figure(const Clip& clip, const Edit& edit) {
  const auto& [skeleton, motion] = *edit.figure;
  const bool fits = skeleton.channel_count() == motion.channel_count() && skeleton.joint_count() > 0 &&
                    motion.frame_count() == clip.motion.frame_count() &&
                    same_bits(motion.frame_time_s(), clip.motion.frame_time_s());
  const bool is_alone = edit.samples.empty() && edit.offsets.empty() && !edit.frames &&
                        (!edit.settings || edit.settings->names_in == clip.settings.names_in);
  if (!fits || !is_alone) return refusal(DiagnosticCode::InvalidArgument, "The new figure does not fit the clip.");
  for (const Node& node : skeleton.nodes()) {
    if (Status status = check_offset(skeleton, {skeleton.node_of(node.joint), node.offset}); !status) return status;
  }
  if (count_missing(motion.samples()) > count_missing(clip.motion.samples())) {
    return refusal(DiagnosticCode::NotFinite, "The new figure would have a sample that is not a finite number.");
  }
  return {};
}

bool is_positive(double value) { return std::isfinite(value) && value > 0.0; }

Status check_scalars(const Edit& edit) {
  if (edit.frame_time_s && !is_positive(*edit.frame_time_s)) {
    return refusal(DiagnosticCode::FrameTimeNotPositive, "The frame time must be more than 0 seconds.");
  }
  if (edit.frame_time_s && !is_frame_time(*edit.frame_time_s)) {
    return refusal(DiagnosticCode::FrameTimeLooksLikeRate,
                   fmt::format("The frame time must be less than {} seconds; readers take more for frames per second.",
                               kFrameTimeEndS));
  }
  if (edit.settings && !is_positive(edit.settings->metres_per_unit)) {
    return refusal(DiagnosticCode::InvalidArgument, "The unit of length must be more than 0 metres.");
  }
  return {};
}

Status check_contacts(const std::vector<OwnContact>& contacts, const Skeleton& skeleton, int frame_count) {
  const OwnContact* before = nullptr;
  for (const OwnContact& contact : contacts) {
    const bool is_in_clip = contact.node >= 0 && contact.node < skeleton.node_count() && contact.first >= 0 &&
                            contact.last >= contact.first && contact.last < frame_count;
    const bool is_behind = before == nullptr || before->node < contact.node || (before->node == contact.node && before->last < contact.first);
    if (!is_in_clip || !is_behind) {
      return refusal(DiagnosticCode::InvalidArgument, "A contact is of a point of the figure and of frames of the clip, one behind the other.");
    }
    before = &contact;
  }
  return {};
}

Status check_body(const BodyChoice& body, const Skeleton& skeleton) {
  const int joint_count = skeleton.joint_count();
  if (body.mass_kg && !is_positive(*body.mass_kg)) {
    return refusal(DiagnosticCode::InvalidArgument, "The mass of the body must be more than 0 kg.");
  }
  JointIndex before = kNoParent;
  for (const OwnSegment& own : body.segments) {
    if (own.joint <= before || own.joint >= joint_count || !std::isfinite(own.mass_kg) || own.mass_kg < 0.0) {
      return refusal(DiagnosticCode::InvalidArgument, "The mass of a segment must be 0 kg or more, and of a joint of the figure.");
    }
    before = own.joint;
    if (!own.shape) continue;
    const Segment segment{own.joint, own.mass_kg, own.shape->com_m, symmetric_tensor(own.shape->inertia_kgm2)};
    if (Status status = check_segment(segment, skeleton.name(own.joint)); !status) return status;
  }
  if (const auto& gravity = body.gravity_mps2; gravity && !std::isfinite(gravity->x + gravity->y + gravity->z)) {
    return refusal(DiagnosticCode::InvalidArgument, "Gravity must be three numbers in metres per second squared.");
  }
  for (const OwnPart& own : body.parts) {
    if (own.joint < 0 || own.joint >= joint_count) {
      return refusal(DiagnosticCode::InvalidArgument, "A part of the body begins at a joint of the figure.");
    }
  }
  return {};
}

Status check_keys(const std::map<ChannelIndex, SharedKeys>& curves, int channel_count) {
  for (const auto& [channel, keys] : curves) {
    if (channel < 0 || channel >= channel_count || !keys) {
      return refusal(DiagnosticCode::InvalidArgument, fmt::format("There are keys for channel {}, which the clip does not have.",
                                                                  std::int64_t{channel} + 1));
    }
    if (Status status = check_key_curve(*keys); !status) return status;
  }
  return {};
}

Status check_stack(const Clip& clip, const Edit& edit) {
  const LayerStack& stack = *edit.stack;
  const Skeleton& skeleton = edit.figure ? edit.figure->skeleton : clip.skeleton;
  const int channel_count = skeleton.channel_count();
  if (Status status = check_keys(stack.keyed, channel_count); !status) return status;
  for (const Layer& layer : stack.layers) {
    if (Status status = check_keys(layer.curves, channel_count); !status) return status;
    if (!layer.weight) continue;
    if (Status status = check_key_curve(*layer.weight); !status) return status;
  }
  const std::size_t frame_count = idx(clip.motion.frame_count());
  const bool replaces_frames = edit.frames || edit.figure;
  for (const ChannelIndex channel : layered_channels(skeleton, stack)) {
    const auto beneath = stack.beneath.find(channel);
    const bool has_samples = beneath != stack.beneath.end() && beneath->second && beneath->second->size() == frame_count;
    if (replaces_frames || !has_samples) {
      return refusal(DiagnosticCode::InvalidArgument, "The layers do not fit the clip.");
    }
  }
  return {};
}

bool have_overlap(const std::vector<SamplesChange>& changes) {
  std::vector<std::tuple<ChannelIndex, FrameIndex, FrameIndex>> ranges;
  ranges.reserve(changes.size());
  for (const SamplesChange& change : changes) {
    ranges.emplace_back(change.channel, change.first, change.first + size_of(change.values));
  }
  std::sort(ranges.begin(), ranges.end());
  return std::adjacent_find(ranges.begin(), ranges.end(), [](const auto& a, const auto& b) {
           return std::get<0>(a) == std::get<0>(b) && std::get<1>(b) < std::get<2>(a);
         }) != ranges.end();
}

bool have_repeat(const std::vector<OffsetChange>& changes) {
  std::vector<NodeIndex> nodes;
  for (const OffsetChange& change : changes) nodes.push_back(change.node);
  std::sort(nodes.begin(), nodes.end());
  return std::adjacent_find(nodes.begin(), nodes.end()) != nodes.end();
}

/// A change of frames ready to be made: what the clip and the change are to hold.
struct PreparedFrames {
  Motion motion;
  std::vector<FrameIndex> file_frames;
  FramesChange back;
};

PreparedFrames prepare_frames(const Clip& clip, const FramesChange& change) {
  PreparedFrames prepared;
  std::vector<FrameIndex>& frames = prepared.file_frames;
  frames = clip.file_frames;
  if (frames.empty()) {
    frames.resize(idx(clip.motion.frame_count()));
    std::iota(frames.begin(), frames.end(), 0);
  }
  const auto begin = frames.begin() + change.removed.first;
  const auto end = begin + change.removed.count;
  prepared.back.removed = {change.removed.first, size_of(change.file_frames)};
  prepared.back.file_frames.assign(begin, end);
  prepared.back.inserted = clip.motion.frames_of(change.removed);
  prepared.motion = clip.motion.with_frames_replaced(change.removed, change.inserted);
  frames.insert(frames.erase(begin, end), change.file_frames.begin(), change.file_frames.end());
  return prepared;
}

void cut_to_difference(std::span<const double> present, SamplesChange& change) {
  const auto differs = [&](std::size_t i) { return !same_bits(present[idx(change.first) + i], change.values[i]); };
  std::size_t begin = 0;
  std::size_t end = change.values.size();
  while (begin < end && !differs(begin)) ++begin;
  while (end > begin && !differs(end - 1)) --end;
  change.values.resize(end);
  change.values.erase(change.values.begin(), change.values.begin() + static_cast<std::ptrdiff_t>(begin));
  change.first += static_cast<FrameIndex>(begin);
}

// Whether frames give way to the same ones.
bool leaves_frames(const Clip& clip, const FramesChange& change) {
  if (change.removed.count != size_of(change.file_frames)) return false;
  for (int i = 0; i < change.removed.count; ++i) {
    const FrameIndex frame = change.removed.first + i;
    if (change.file_frames[idx(i)] != (clip.file_frames.empty() ? frame : clip.file_frames[idx(frame)])) return false;
  }
  if (change.removed.count == 0) return true;
  for (ChannelIndex channel = 0; channel < clip.motion.channel_count(); ++channel) {
    const auto present = clip.motion.channel_samples(channel).subspan(idx(change.removed.first), idx(change.removed.count));
    const auto inserted = change.inserted.channel_samples(channel);
    if (!std::equal(present.begin(), present.end(), inserted.begin(), same_bits<double>)) return false;
  }
  return true;
}

}  // namespace

Status check_edit(const Clip& clip, const Edit& edit) {
  for (const SamplesChange& change : edit.samples) {
    if (Status status = check_samples(clip.motion, change); !status) return status;
  }
  for (const OffsetChange& change : edit.offsets) {
    if (Status status = check_offset(clip.skeleton, change); !status) return status;
  }
  if (edit.frames) {
    if (Status status = check_frames(clip, edit); !status) return status;
  }
  if (edit.figure) {
    if (Status status = check_figure(clip, edit); !status) return status;
  }
  if (edit.stack) {
    if (Status status = check_stack(clip, edit); !status) return status;
  }
  if (Status status = check_scalars(edit); !status) return status;
  const Skeleton& skeleton = edit.figure ? edit.figure->skeleton : clip.skeleton;
  if (Status status = edit.body ? check_body(*edit.body, skeleton) : Status{}; !status) return status;
  const int frame_count = clip.motion.frame_count() + (edit.frames ? edit.frames->inserted.frame_count() - edit.frames->removed.count : 0);
  if (Status status = edit.body ? check_contacts(edit.body->contacts, skeleton, frame_count) : Status{}; !status) return status;
  if (have_overlap(edit.samples) || have_repeat(edit.offsets)) {
    return refusal(DiagnosticCode::InvalidArgument, "The change gives two values to the same place.");
  }
  return {};
}

Edit reduced_to_changes(const Clip& clip, Edit edit) {
  for (SamplesChange& change : edit.samples) {
    cut_to_difference(clip.motion.channel_samples(change.channel), change);
  }
  std::erase_if(edit.samples, [](const SamplesChange& change) { return change.values.empty(); });
  std::erase_if(edit.offsets, [&](const OffsetChange& change) {
    return same_bits(clip.skeleton.node(change.node).offset, change.offset);
  });
  if (edit.frames && leaves_frames(clip, *edit.frames)) edit.frames.reset();
  if (edit.figure && edit.figure->skeleton == clip.skeleton &&
      std::equal(clip.motion.samples().begin(), clip.motion.samples().end(), edit.figure->motion.samples().begin(),
                 same_bits<double>)) {
    edit.figure.reset();
  }
  if (edit.settings == clip.settings) edit.settings.reset();
  if (edit.frame_time_s == clip.motion.frame_time_s()) edit.frame_time_s.reset();
  if (edit.stack == clip.stack) edit.stack.reset();
  if (edit.body == clip.body) edit.body.reset();
  return edit;
}

void swap_edit(Clip& clip, Edit& edit) {
  // What takes memory comes first: without it the clip and the edit are as they were.
  std::optional<PreparedFrames> prepared;
  if (edit.frames) prepared = prepare_frames(clip, *edit.frames);
  if (edit.settings && edit.settings->names_in != clip.settings.names_in) {
    clip.skeleton.read_names_in(edit.settings->names_in);
  }
  if (prepared) {
    clip.motion = std::move(prepared->motion);
    clip.file_frames = std::move(prepared->file_frames);
    *edit.frames = std::move(prepared->back);
  }
  if (edit.figure) {
    std::swap(clip.skeleton, edit.figure->skeleton);
    std::swap(clip.motion, edit.figure->motion);
  }
  for (SamplesChange& change : edit.samples) {
    const std::span<double> present = clip.motion.channel_samples(change.channel).subspan(idx(change.first));
    std::swap_ranges(change.values.begin(), change.values.end(), present.begin());
  }
  for (OffsetChange& change : edit.offsets) {
    const glm::dvec3 present = clip.skeleton.node(change.node).offset;
    clip.skeleton.set_offset(change.node, change.offset);
    change.offset = present;
  }
  if (edit.stack) std::swap(clip.stack, *edit.stack);
  if (edit.body) std::swap(clip.body, *edit.body);
  if (edit.settings) std::swap(clip.settings, *edit.settings);
  if (edit.frame_time_s) {
    const double present = clip.motion.frame_time_s();
    clip.motion.set_frame_time_s(*edit.frame_time_s);
    edit.frame_time_s = present;
  }
}

std::size_t edit_bytes(const Edit& edit) {
  std::size_t bytes = sizeof(Edit) + edit.name.size() + edit.offsets.size() * sizeof(OffsetChange);
  for (const SamplesChange& change : edit.samples) {
    bytes += sizeof(SamplesChange) + change.values.size() * sizeof(double);
  }
  if (edit.figure) {
    const Skeleton& skeleton = edit.figure->skeleton;
    bytes += edit.figure->motion.samples().size() * sizeof(double) + idx(skeleton.node_count()) * sizeof(Node) +
             idx(skeleton.channel_count()) * sizeof(Channel);
  }
  if (edit.frames) {
    bytes += edit.frames->inserted.samples().size() * sizeof(double) + edit.frames->file_frames.size() * sizeof(FrameIndex);
  }
  if (edit.stack) bytes += unshared_bytes(*edit.stack);
  if (edit.body) bytes += edit.body->segments.size() * sizeof(OwnSegment) + edit.body->parts.size() * sizeof(OwnPart) + edit.body->contacts.size() * sizeof(OwnContact);
  return bytes;
}

FrameRange edited_frames(const Clip& clip, const Edit& edit) {
  const bool moves_rule = edit.settings && edit.settings->position_rule != clip.settings.position_rule;
  if (moves_rule || edit.frames || edit.figure || !edit.offsets.empty()) return {0, clip.motion.frame_count()};
  FrameRange frames;
  for (const SamplesChange& change : edit.samples) frames = hull(frames, {change.first, size_of(change.values)});
  return frames;
}

FrameRange hull(FrameRange a, FrameRange b) {
  if (a.count <= 0) return b;
  if (b.count <= 0) return a;
  const FrameIndex first = std::min(a.first, b.first);
  return {first, std::max(a.end(), b.end()) - first};
}

}  // namespace marey
