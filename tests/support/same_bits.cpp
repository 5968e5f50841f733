#include "tests/support/same_bits.h"

#include <algorithm>
#include <cstring>

#include "core/base/bits.h"

namespace marey::test {
namespace {

std::uint64_t bits(double value) {
  std::uint64_t result = 0;
  std::memcpy(&result, &value, sizeof result);
  return result;
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
    for (const char c : node.name_bytes) result.push_back(static_cast<unsigned char>(c));
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
  return result;
}

}  // namespace marey::test
