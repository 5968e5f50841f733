#include "core/table/csv.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <iterator>
#include <string_view>
#include <vector>

#include "core/base/number_text.h"
#include "core/kinematics/forward_kinematics.h"

namespace marey {
namespace {

void append_text_field(std::string_view text, std::string& out) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    out += text;
    return;
  }
  out += '"';
  for (const char c : text) out.append(c == '"' ? 2U : 1U, c);
  out += '"';
}

void append_number_field(double value, std::string& out) {
  constexpr NumberFormat kFewestDigits{.decimals = 0};
  out += ',';
  append_number(value, kFewestDigits, out);
}

void append_row_start(double frame_time_s, FrameIndex frame, std::string& out) {
  fmt::format_to(std::back_inserter(out), "{}", frame + 1);
  append_number_field(frame * frame_time_s, out);
}

std::string in_brackets(std::string_view unit) { return unit.empty() ? "" : fmt::format("[{}]", unit); }

std::string_view unit_of(ChannelKind kind, std::string_view length_unit) {
  if (is_position(kind)) return length_unit;
  return is_rotation(kind) && !length_unit.empty() ? "deg" : "";
}

std::string_view row_labels(std::string_view length_unit) { return length_unit.empty() ? "frame,time" : "frame,time[s]"; }

}  // namespace

std::string channel_column_name(const Skeleton& skeleton, ChannelIndex index) {
  const Channel& channel = skeleton.channel(index);
  const bool is_known = channel.kind != ChannelKind::Other;
  return fmt::format("{}.{}", skeleton.name(channel.joint), is_known ? channel_keyword(channel.kind) : channel.other_name);
}

void append_channel_header(const Skeleton& skeleton, std::string& out, std::string_view length_unit) {
  out += row_labels(length_unit);
  for (ChannelIndex channel = 0; channel < skeleton.channel_count(); ++channel) {
    const std::string_view unit = unit_of(skeleton.channel(channel).kind, length_unit);
    out += ',';
    append_text_field(channel_column_name(skeleton, channel) + in_brackets(unit), out);
  }
  out += '\n';
}

void append_channel_rows(const Motion& motion, FrameRange frames, std::string& out) {
  for (FrameIndex frame = frames.first; frame < frames.end(); ++frame) {
    append_row_start(motion.frame_time_s(), frame, out);
    for (ChannelIndex channel = 0; channel < motion.channel_count(); ++channel) {
      append_number_field(motion.sample(channel, frame), out);
    }
    out += '\n';
  }
}

void append_position_header(const Skeleton& skeleton, std::string& out, std::string_view length_unit) {
  out += row_labels(length_unit);
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    const std::string label = node_label(skeleton, node);
    for (const char axis : std::array{'x', 'y', 'z'}) {
      out += ',';
      append_text_field(fmt::format("{}.{}{}", label, axis, in_brackets(length_unit)), out);
    }
  }
  out += '\n';
}

void append_position_rows(const Skeleton& skeleton, const Motion& motion, FrameRange frames, PositionRule rule,
                          std::string& out) {
  const std::size_t row_length = idx(skeleton.node_count()) * 3;
  std::vector<double> world_positions(idx(frames.count) * row_length);
  compute_world_positions(skeleton, motion, frames, rule, world_positions);
  for (int row = 0; row < frames.count; ++row) {
    append_row_start(motion.frame_time_s(), frames.first + row, out);
    for (const double value : std::span(world_positions).subspan(idx(row) * row_length, row_length)) {
      append_number_field(value, out);
    }
    out += '\n';
  }
}

void append_columns_header(std::span<const NumberColumn> columns, std::string& out) {
  out += "frame,time[s]";
  for (const NumberColumn& column : columns) {
    out += ',';
    append_text_field(column.name, out);
  }
  out += '\n';
}

void append_columns(std::span<const NumberColumn> columns, double frame_time_s, FrameRange frames, std::string& out) {
  for (FrameIndex frame = frames.first; frame < frames.end(); ++frame) {
    append_row_start(frame_time_s, frame, out);
    for (const NumberColumn& column : columns) {
      const double value = column.values[idx(frame)];
      if (std::isfinite(value)) {
        append_number_field(value, out);
      } else {
        out += ',';
      }
    }
    out += '\n';
  }
}

}  // namespace marey
