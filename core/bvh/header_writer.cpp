#include "core/bvh/header_writer.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "core/base/bits.h"
#include "core/base/index.h"
#include "core/base/text_cursor.h"
#include "core/bvh/header_patch.h"
#include "core/bvh/joint_name.h"
#include "core/bvh/keyword.h"
#include "core/bvh/row_text.h"

namespace marey {
namespace {

bool same_but_for_offset(const Node& a, const Node& b) {
  return a.joint == b.joint && a.parent == b.parent && a.is_end_site == b.is_end_site &&
         a.name_bytes == b.name_bytes;
}

bool same_but_for_offsets(const Skeleton& a, const Skeleton& b) {
  return std::equal(a.nodes().begin(), a.nodes().end(), b.nodes().begin(), b.nodes().end(), same_but_for_offset) &&
         std::equal(a.channels().begin(), a.channels().end(), b.channels().begin(), b.channels().end());
}

/// A piece of the header's text to be exchanged.
struct Exchange {
  NumberSlot slot;
  std::string text;
};

std::string text_of(double value, const NumberFormat& format) {
  std::string text;
  append_number(value, format, text);
  return text;
}

/// Collects the numbers of the header that changed; false if one has no place in the text.
bool find_exchanges(const Skeleton& skeleton, const Motion& motion, const BvhStyle& style,
                    std::vector<Exchange>& exchanges) {
  bool all_have_a_place = true;
  const auto compare = [&](const NumberSlot& slot, double value, const NumberFormat& format) {
    if (same_bits(slot.value, value)) return;
    all_have_a_place = all_have_a_place && slot.length > 0;
    exchanges.push_back({slot, text_of(value, format)});
  };
  const HeaderText& header = style.header_text;
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    for (int axis = 0; axis < 3; ++axis) {
      compare(header.offsets[idx(3 * node + axis)], skeleton.node(node).offset[axis], style.header.offset_format);
    }
  }
  NumberFormat whole;
  whole.decimals = 0;
  compare(header.frame_count, motion.frame_count(), whole);
  compare(header.frame_time, motion.frame_time_s(), NumberFormat{});
  return all_have_a_place;
}

/// Appends the header as it was read; false if it does not fit.
bool append_kept_header(const Skeleton& skeleton, const Motion& motion, const BvhStyle& style, std::string& out) {
  const HeaderText& header = style.header_text;
  if (header.text.empty() || !same_but_for_offsets(skeleton, header.skeleton)) return false;
  std::vector<Exchange> exchanges;
  if (!find_exchanges(skeleton, motion, style, exchanges)) return false;
  std::sort(exchanges.begin(), exchanges.end(),
            [](const Exchange& a, const Exchange& b) { return a.slot.begin < b.slot.begin; });
  const std::string_view text = header.text;
  std::size_t done = 0;
  for (const Exchange& exchange : exchanges) {
    out.append(text.substr(done, exchange.slot.begin - done)).append(exchange.text);
    done = exchange.slot.begin + exchange.slot.length;
  }
  out += text.substr(done);
  return true;
}

/// Prints a skeleton in the style of a file.
class HeaderPrinter {
 public:
  HeaderPrinter(const Skeleton& skeleton, const HeaderStyle& style, std::string& out)
      : skeleton_(skeleton), style_(style), out_(out) {}

  void print();

 private:
  void begin_line() {
    out_ += indent_at(style_.indent, open_.size());
  }
  void end_line() { out_ += style_.line_end; }
  void print_line(std::string_view text) {
    begin_line();
    out_ += text;
    end_line();
  }
  void open(std::string_view keyword, std::string_view name, JointIndex joint);
  void close();
  void print_offset(const glm::dvec3& offset);
  void print_channels(JointIndex joint);
  void print_node(const Node& node);

  const Skeleton& skeleton_;
  const HeaderStyle& style_;
  std::string& out_;
  std::vector<JointIndex> open_;
};

std::string printable_channel(const Channel& channel) {
  if (channel.kind != ChannelKind::Other) return std::string(channel_keyword(channel.kind));
  std::string result = printable_joint_name(channel.other_name);
  std::replace_if(result.begin(), result.end(), is_blank, '_');
  if (result.empty()) return "Unknown";
  const bool ends_the_list = find_keyword(result) != Keyword::None || starts_comment(result);
  return ends_the_list ? "_" + result : result;
}

void HeaderPrinter::open(std::string_view keyword, std::string_view name, JointIndex joint) {
  begin_line();
  out_ += keyword;
  const std::string printable = printable_joint_name(name);
  if (!printable.empty()) out_.append(" ").append(printable);
  end_line();
  print_line("{");
  open_.push_back(joint);
}

void HeaderPrinter::close() {
  open_.pop_back();
  print_line("}");
}

void HeaderPrinter::print_offset(const glm::dvec3& offset) {
  begin_line();
  out_ += "OFFSET";
  for (int axis = 0; axis < 3; ++axis) {
    out_ += ' ';
    append_number(offset[axis], style_.offset_format, out_);
  }
  end_line();
}

void HeaderPrinter::print_channels(JointIndex joint) {
  begin_line();
  out_.append("CHANNELS ").append(std::to_string(skeleton_.channel_count(joint)));
  for (const Channel& channel : skeleton_.channels(joint)) out_.append(" ").append(printable_channel(channel));
  end_line();
}

void HeaderPrinter::print_node(const Node& node) {
  const JointIndex parent = node.is_end_site ? node.joint : skeleton_.parent(node.joint);
  while (!open_.empty() && open_.back() != parent) close();
  if (node.is_end_site) {
    open("End Site", node.name_bytes, kNoParent);
    print_offset(node.offset);
    close();
    return;
  }
  open(parent == kNoParent ? "ROOT" : "JOINT", node.name_bytes, node.joint);
  print_offset(node.offset);
  print_channels(node.joint);
}

void HeaderPrinter::print() {
  out_ += style_.before;
  print_line("HIERARCHY");
  for (const Node& node : skeleton_.nodes()) print_node(node);
  while (!open_.empty()) close();
}

}  // namespace

void append_header(const Skeleton& skeleton, const Motion& motion, const BvhStyle& style, std::string& out) {
  if (append_kept_header(skeleton, motion, style, out)) return;
  HeaderPrinter(skeleton, style.header, out).print();
  const std::string& line_end = style.header.line_end;
  out.append("MOTION").append(line_end);
  out.append("Frames: ").append(std::to_string(motion.frame_count())).append(line_end);
  out += "Frame Time: ";
  append_number(motion.frame_time_s(), NumberFormat{}, out);
  out += line_end;
}

}  // namespace marey
