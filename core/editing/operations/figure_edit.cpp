#include "core/editing/operations/figure_edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/editing/body_carrying.h"
#include "core/kinematics/forward_kinematics.h"

namespace marey {
namespace {

constexpr int kBlock = 256;              // frames whose points are looked at together
constexpr double kUnnoticed = 1e-9;      // of the stature

// The farthest that a node moves which is in both figures.
double largest_move(const Clip& clip, const FigureChange& figure, const std::vector<NodeIndex>& origins) {
  double largest = 0.0;
  std::vector<double> before(idx(kBlock) * idx(clip.skeleton.node_count()) * 3);
  std::vector<double> now(idx(kBlock) * origins.size() * 3);
  for (FrameIndex first = 0; first < clip.motion.frame_count(); first += kBlock) {
    const FrameRange frames{first, std::min(kBlock, clip.motion.frame_count() - first)};
    before.resize(idx(frames.count) * idx(clip.skeleton.node_count()) * 3);
    now.resize(idx(frames.count) * origins.size() * 3);
    compute_world_positions(clip.skeleton, clip.motion, frames, clip.settings.position_rule, std::span<double>(before));
    compute_world_positions(figure.skeleton, figure.motion, frames, clip.settings.position_rule, std::span<double>(now));
    for (int frame = 0; frame < frames.count; ++frame) {
      for (std::size_t node = 0; node < origins.size(); ++node) {
        if (origins[node] == kNoParent) continue;
        const double* a = &before[(idx(frame) * idx(clip.skeleton.node_count()) + idx(origins[node])) * 3];
        const double* b = &now[(idx(frame) * origins.size() + node) * 3];
        const double move = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
        if (move > largest && std::isfinite(move)) largest = move;
      }
    }
  }
  return largest;
}

}  // namespace

Result<OperationOutcome> make_figure_edit(const OperationCall& call, FigureDraft draft, std::vector<std::string> notes,
                                          Points points) {
  std::vector<NodeIndex> origins;
  for (const NodeDraft& node : draft.nodes) origins.push_back(node.origin);
  Result<FigureChange> figure = put_together(call.clip, std::move(draft));
  if (!figure) return figure.error();
  OperationOutcome outcome{{}, std::move(notes)};
  if (points == Points::MayMove) {
    const double move = largest_move(call.clip, *figure, origins);
    if (move > kUnnoticed * compute_stature(call.clip.skeleton)) {
      outcome.notes.push_back(fmt::format("Points of the figure move by up to {:.4g} file units.", move));
    }
  }
  BodyChoice body = carry_body_over(call.clip.body, call.clip.skeleton, figure->skeleton, origins, outcome.notes);
  if (!(body == call.clip.body)) outcome.edit.body = std::move(body);
  outcome.edit.name = call.operation.label;
  outcome.edit.figure = std::move(*figure);
  return outcome;
}

bool has_own_positions(const Skeleton& skeleton, JointIndex joint) {
  const auto channels = skeleton.channels(joint);
  return skeleton.parent(joint) != kNoParent &&
         std::any_of(channels.begin(), channels.end(), [](const Channel& c) { return is_position(c.kind); });
}

}  // namespace marey
