#include "tests/support/same_bits.h"

#include <algorithm>
#include <cstring>
#include <string>

#include "core/base/bits.h"

namespace marey::test {
namespace {

std::uint64_t bits(double value) {
  std::uint64_t result = 0;
  std::memcpy(&result, &value, sizeof result);
  return result;
}

void add_text(const std::string& text, std::vector<std::uint64_t>& result) {
  for (const char c : text) result.push_back(static_cast<unsigned char>(c));
}

void add_keys(const SharedKeys& keys, std::vector<std::uint64_t>& result) {
  if (!keys) return;
  for (const Key& key : keys->keys) {
    for (const double number : {key.frame, key.value, key.left.frames, key.left.value, key.right.frames, key.right.value}) {
      result.push_back(bits(number));
    }
    result.push_back(static_cast<std::uint64_t>(key.interpolation) * 64 + static_cast<std::uint64_t>(key.left_kind) * 8 +
                     static_cast<std::uint64_t>(key.right_kind));
  }
  result.push_back(static_cast<std::uint64_t>(keys->before) * 16 + static_cast<std::uint64_t>(keys->behind) * 2 +
                   (keys->weighted ? 1 : 0));
}

void add_stack(const LayerStack& stack, std::vector<std::uint64_t>& result) {
  for (const auto& [channel, keys] : stack.keyed) {
    result.push_back(static_cast<std::uint64_t>(channel));
    add_keys(keys, result);
  }
  for (const auto& [channel, samples] : stack.beneath) {
    result.push_back(static_cast<std::uint64_t>(channel));
    for (const double sample : *samples) result.push_back(bits(sample));
  }
  for (const Layer& layer : stack.layers) {
    add_text(layer.name, result);
    result.push_back((layer.mode == LayerMode::Override ? 1u : 0u) + (layer.sums_angles ? 2u : 0u) + (layer.muted ? 4u : 0u) +
                     (layer.solo ? 8u : 0u) + (layer.locked ? 16u : 0u));
    add_keys(layer.weight, result);
    for (const auto& [channel, keys] : layer.curves) {
      result.push_back(static_cast<std::uint64_t>(channel));
      add_keys(keys, result);
    }
  }
}

}  // namespace

bool same_numbers(const Skeleton& a, const Motion& motion_a, const Skeleton& b, const Motion& motion_b) {
  if (a.node_count() != b.node_count() || motion_a.frame_count() != motion_b.frame_count()) return false;
  for (NodeIndex node = 0; node < a.node_count(); ++node) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!same_bits(a.node(node).offset[axis], b.node(node).offset[axis])) return false;
    }
  }
  return same_bits(motion_a.frame_time_s(), motion_b.frame_time_s()) &&
         std::equal(motion_a.samples().begin(), motion_a.samples().end(), motion_b.samples().begin(),
                    motion_b.samples().end(), same_bits<double>);
}

std::vector<std::uint64_t> bits_of(const Clip& clip) {
  std::vector<std::uint64_t> result;
  for (const double sample : clip.motion.samples()) result.push_back(bits(sample));
  for (const Node& node : clip.skeleton.nodes()) {
    for (int axis = 0; axis < 3; ++axis) result.push_back(bits(node.offset[axis]));
    result.push_back(static_cast<std::uint64_t>(node.parent) * 4 + (node.is_end_site ? 2 : 0) + (node.positions_add ? 1 : 0));
    add_text(node.name_bytes, result);
  }
  for (const Channel& channel : clip.skeleton.channels()) {
    result.push_back(static_cast<std::uint64_t>(channel.joint) * 16 + static_cast<std::uint64_t>(channel.kind));
  }
  for (FrameIndex frame = 0; frame < clip.motion.frame_count(); ++frame) {
    result.push_back(static_cast<std::uint64_t>(clip.file_frames.empty() ? frame : clip.file_frames[idx(frame)]));
  }
  result.push_back(bits(clip.motion.frame_time_s()));
  result.push_back(bits(clip.settings.metres_per_unit));
  result.push_back(static_cast<std::uint64_t>(clip.settings.up_axis));
  result.push_back(static_cast<std::uint64_t>(clip.settings.position_rule));
  result.push_back(static_cast<std::uint64_t>(clip.settings.names_in));
  add_stack(clip.stack, result);
  return result;
}

}  // namespace marey::test
