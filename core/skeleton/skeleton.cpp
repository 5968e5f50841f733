#include "core/skeleton/skeleton.h"

#include <algorithm>
#include <glm/common.hpp>

#include "core/base/text_cursor.h"
#include "core/text/utf8.h"

namespace marey {
namespace {

int end_site_ordinal(const Skeleton& skeleton, NodeIndex node) {
  int ordinal = 1;
  for (NodeIndex other = skeleton.node(node).parent; other < node; ++other) {
    const Node& candidate = skeleton.node(other);
    if (candidate.is_end_site && candidate.joint == skeleton.node(node).joint) ++ordinal;
  }
  return ordinal;
}

}  // namespace

void Skeleton::read_names_in(CharacterSet set) {
  std::vector<std::string> names;
  names.reserve(nodes_.size());
  for (const Node& node : nodes_) names.push_back(decoded(trimmed(node.name_bytes), set));
  for (std::size_t i = 0; i < names.size(); ++i) nodes_[i].name = std::move(names[i]);
}

std::vector<std::string_view> name_bytes_of(const Skeleton& skeleton) {
  std::vector<std::string_view> names;
  for (const Node& node : skeleton.nodes()) names.emplace_back(node.name_bytes);
  return names;
}

std::vector<std::string> telling_names(const Skeleton& skeleton, CharacterSet set, int most) {
  std::vector<std::string> names;
  for (const Node& node : skeleton.nodes()) {
    if (size_of(names) == most) break;
    if (!is_ascii(node.name_bytes)) names.push_back(decoded(trimmed(node.name_bytes), set));
  }
  return names;
}

bool has_joints_that_add(const Skeleton& skeleton) {
  const auto nodes = skeleton.nodes();
  return std::any_of(nodes.begin(), nodes.end(), [](const Node& node) { return node.positions_add; });
}

std::string node_label(const Skeleton& skeleton, NodeIndex node) {
  const Node& n = skeleton.node(node);
  if (!n.is_end_site) return n.name;
  const int ordinal = end_site_ordinal(skeleton, node);
  return skeleton.name(n.joint) + "_end" + (ordinal > 1 ? std::to_string(ordinal) : std::string());
}

std::string_view channel_name(const Channel& channel) {
  const std::string_view keyword = channel_keyword(channel.kind);
  return keyword.empty() ? std::string_view(channel.other_name) : keyword;
}

std::string channel_label(const Skeleton& skeleton, ChannelIndex channel) {
  const Channel& c = skeleton.channel(channel);
  return skeleton.name(c.joint) + " " + std::string(channel_name(c));
}

std::string euler_order_label(const Skeleton& skeleton, JointIndex joint) {
  std::string order;
  for (const Channel& channel : skeleton.channels(joint)) {
    if (is_rotation(channel.kind)) order += "XYZ"[static_cast<int>(axis_of(channel.kind))];
  }
  return order;
}

double compute_stature(const Skeleton& skeleton) {
  glm::dvec3 low(0.0);
  glm::dvec3 high(0.0);
  std::vector<glm::dvec3> rest(idx(skeleton.node_count()));
  for (NodeIndex i = 0; i < skeleton.node_count(); ++i) {
    const Node& node = skeleton.node(i);
    // Where a root stands in the world says nothing about the size of the figure.
    rest[idx(i)] = node.parent == kNoParent ? glm::dvec3(0.0) : rest[idx(node.parent)] + node.offset;
    low = glm::min(low, rest[idx(i)]);
    high = glm::max(high, rest[idx(i)]);
  }
  const glm::dvec3 extent = high - low;
  return std::max({extent.x, extent.y, extent.z});
}

}  // namespace marey
