#include "core/bvh/save_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <vector>

#include "core/base/number_text.h"
#include "core/bvh/text_encoding.h"
#include "core/bvh/writer.h"
#include "core/motion/resampling.h"

namespace marey {
namespace {

/// Through the decimal text: 10^decimals has no exact reciprocal, so arithmetic would miss the nearest double.
double rounded_to(double value, int decimals) {
  if (!std::isfinite(value)) return value;
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "{:.{}f}", value, decimals);
  const double rounded = read_number({text.data(), text.size()}).value;
  return rounded == 0.0 ? 0.0 : rounded;
}

void give_decimals(NumberFormat& format, int decimals) {
  format.form = NumberFormat::Form::Fixed;
  format.decimals = static_cast<std::uint8_t>(decimals);
  format.exponent_below = std::numeric_limits<std::int8_t>::min();
  format.exponent_from = std::numeric_limits<std::int8_t>::max();
}

void round_all(Skeleton& skeleton, Motion& motion, BvhStyle& style, int decimals) {
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    glm::dvec3 offset = skeleton.node(node).offset;
    for (int axis = 0; axis < 3; ++axis) offset[axis] = rounded_to(offset[axis], decimals);
    skeleton.set_offset(node, offset);
  }
  for (ChannelIndex channel = 0; channel < motion.channel_count(); ++channel) {
    for (double& sample : motion.channel_samples(channel)) sample = rounded_to(sample, decimals);
  }
  give_decimals(style.header.offset_format, decimals);
  // The kept text of a number that rounding leaves alone has its old decimals.
  for (NumberSlot& slot : style.header_text.offsets) {
    if (slot.length > 0) slot.value = std::numeric_limits<double>::quiet_NaN();
  }
  if (size_of(style.motion.columns) != motion.channel_count()) {
    style.motion.columns.assign(idx(motion.channel_count()), ColumnStyle{});
  }
  for (ColumnStyle& column : style.motion.columns) give_decimals(column.format, decimals);
  for (OddToken& odd : style.motion.odd_tokens) odd.value = std::numeric_limits<double>::quiet_NaN();
}

std::string with_line_ends(const std::string& text, std::string_view line_end) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\r' && text[i] != '\n') {
      result += text[i];
      continue;
    }
    result += line_end;
    if (text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n') ++i;
  }
  return result;
}

/// The text in the wanted numbers. Copies the clip only where some of them are other ones.
std::string write_numbers(const Skeleton& skeleton, const Motion& motion, const BvhStyle& style, const SaveOptions& options) {
  if (options.frames.count == 0 && !options.decimals) return write_bvh(skeleton, motion, style);
  Skeleton saved_skeleton = skeleton;
  Motion saved_motion = options.frames.count > 0 ? trimmed(motion, options.frames) : motion;
  BvhStyle saved_style = style;
  if (options.frames.count > 0 && style.motion.frame_count == motion.frame_count()) {
    std::vector<FrameIndex> frames(idx(options.frames.count));
    std::iota(frames.begin(), frames.end(), options.frames.first);
    saved_style.motion = with_frames(style.motion, frames);
  }
  if (options.decimals) round_all(saved_skeleton, saved_motion, saved_style, *options.decimals);
  return write_bvh(saved_skeleton, saved_motion, saved_style);
}

}  // namespace

std::string write_bvh(const Skeleton& skeleton, const Motion& motion, const BvhStyle& style, const SaveOptions& options) {
  BvhStyle as_bytes = style;
  as_bytes.encoding = TextEncoding::Bytes;
  std::string text = write_numbers(skeleton, motion, as_bytes, options);
  if (options.line_end) text = with_line_ends(text, *options.line_end == LineEnd::Lf ? "\n" : "\r\n");
  return style.encoding == TextEncoding::Bytes ? text : encoded_as_utf16(text, style.encoding);
}

RoundingCost measure_rounding(const Skeleton& skeleton, const Motion& motion, FrameRange frames, int decimals) {
  RoundingCost cost;
  const double scale = std::pow(10.0, decimals);
  const auto look_at = [&](double value) {
    const double change = std::abs(std::nearbyint(value * scale) / scale - value);
    if (!(change > 4.0 * std::numeric_limits<double>::epsilon() * std::abs(value))) return;
    ++cost.numbers;
    cost.largest = std::max(cost.largest, change);
  };
  for (const Node& node : skeleton.nodes()) {
    for (int axis = 0; axis < 3; ++axis) look_at(node.offset[axis]);
  }
  const FrameRange looked_at = frames.count > 0 ? frames : FrameRange{0, motion.frame_count()};
  for (ChannelIndex channel = 0; channel < motion.channel_count(); ++channel) {
    for (const double sample : motion.channel_samples(channel).subspan(idx(looked_at.first), idx(looked_at.count))) {
      look_at(sample);
    }
  }
  return cost;
}

}  // namespace marey
