#include "core/editing/figure_draft.h"

#include <utility>

#include "core/skeleton/skeleton_builder.h"

namespace marey {
namespace {

void add_channels(const Clip& clip, JointIndex joint, NodeDraft& node) {
  for (int i = 0; i < clip.skeleton.channel_count(joint); ++i) {
    const ChannelIndex channel = clip.skeleton.first_channel(joint) + i;
    const std::span<const double> samples = clip.motion.channel_samples(channel);
    const Channel& c = clip.skeleton.channel(channel);
    node.channels.push_back({c.kind, c.other_name, {samples.begin(), samples.end()}});
  }
}

Result<Skeleton> build_skeleton(const FigureDraft& draft) {
  SkeletonBuilder builder;
  std::vector<int> open;
  for (int i = 0; i < size_of(draft.nodes); ++i) {
    const NodeDraft& node = draft.nodes[idx(i)];
    while (!open.empty() && open.back() != node.parent) {
      builder.close_joint();
      open.pop_back();
    }
    if (node.is_end_site) {
      builder.add_end_site(node.offset, node.name_bytes);
      continue;
    }
    builder.open_joint(node.name_bytes, node.offset);
    for (const ChannelDraft& channel : node.channels) builder.add_channel(channel.kind, channel.other_name);
    open.push_back(i);
  }
  for (std::size_t i = 0; i < open.size(); ++i) builder.close_joint();
  return builder.build();
}

}  // namespace

int FigureDraft::subtree_end(int node) const {
  int end = node + 1;
  while (end < size_of(nodes) && nodes[idx(end)].parent >= node) ++end;
  return end;
}

void FigureDraft::move_subtree(int node, int new_parent) {
  const int end = subtree_end(node);
  const int target = subtree_end(new_parent);
  nodes[idx(node)].parent = new_parent;
  // The nodes in their new order, by their old places.
  std::vector<int> order;
  for (int i = 0; i <= size_of(nodes); ++i) {
    if (i == target) {
      for (int k = node; k < end; ++k) order.push_back(k);
    }
    if (i < size_of(nodes) && (i < node || i >= end)) order.push_back(i);
  }
  std::vector<int> place(nodes.size());
  for (int i = 0; i < size_of(order); ++i) place[idx(order[idx(i)])] = i;
  std::vector<NodeDraft> moved;
  for (const int old : order) {
    NodeDraft& taken = moved.emplace_back(std::move(nodes[idx(old)]));
    if (taken.parent != kNoParent) taken.parent = place[idx(taken.parent)];
  }
  nodes = std::move(moved);
}

FigureDraft take_apart(const Clip& clip) {
  FigureDraft draft;
  for (NodeIndex i = 0; i < clip.skeleton.node_count(); ++i) {
    const Node& node = clip.skeleton.node(i);
    NodeDraft taken{node.parent, node.is_end_site, node.name_bytes, node.offset, node.positions_add, {}, i};
    if (!node.is_end_site) add_channels(clip, node.joint, taken);
    draft.nodes.push_back(std::move(taken));
  }
  return draft;
}

Result<FigureChange> put_together(const Clip& clip, FigureDraft draft) {
  Result<Skeleton> skeleton = build_skeleton(draft);
  if (!skeleton) return skeleton.error();
  std::vector<double> samples;
  JointIndex joint = 0;
  for (const NodeDraft& node : draft.nodes) {
    for (const ChannelDraft& channel : node.channels) samples.insert(samples.end(), channel.samples.begin(), channel.samples.end());
    if (!node.is_end_site) skeleton->set_positions_add(joint++, node.positions_add);
  }
  skeleton->read_names_in(clip.settings.names_in);
  Motion motion(skeleton->channel_count(), clip.motion.frame_count(), clip.motion.frame_time_s(), std::move(samples));
  return FigureChange{std::move(*skeleton), std::move(motion)};
}

}  // namespace marey
