#include "core/interchange/export.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/bvh/writer.h"
#include "core/interchange/rig.h"
#include "core/interchange/rig_ends.h"
#include "core/interchange/rig_frames.h"
#include "core/interchange/rig_names.h"
#include "core/interchange/rig_roots.h"
#include "core/interchange/rig_rotations.h"
#include "core/kinematics/forward_kinematics.h"
#include "core/lint/wording.h"
#include "core/motion/resampling.h"

namespace marey {
namespace {

using Kind = ExportChangeKind;

constexpr std::array<std::string_view, kExportChangeKindCount> kIds = {
    "channels_dropped", "channels_reordered", "root_added",       "positions_dropped",
    "positions_added",  "root_offset_moved",  "rotations_added",  "rotations_solved",
    "names_changed",    "end_sites_added",    "end_sites_dropped", "end_site_names_dropped",
    "pose_added",       "bones_without_length", "too_long",       "joints_moved"};
static_assert(!kIds.back().empty());

// Of the stature: what rounding may do.
constexpr double kUnmoved = 1e-9;
constexpr double kSecondLifeLongest_s = 60.0;

void rewrite_positions(const TargetTraits& target, Rig& rig, ExportChanges& changes) {
  const bool of_root_only = target.asks_for(Requirement::PositionsOfRootOnly);
  if (target.asks_for(Requirement::OneRoot)) join_roots(rig, of_root_only, changes);
  if (target.asks_for(Requirement::RootPositions)) complete_root_positions(rig, changes);
  if (target.asks_for(Requirement::WholePositions)) complete_positions(rig, changes);
  if (of_root_only) drop_positions_below_root(rig, changes);
  if (target.asks_for(Requirement::NoRootOffset)) move_root_offset(rig, changes);
}

void rewrite_rotations(const TargetTraits& target, Rig& rig, ExportChanges& changes) {
  const bool for_all = target.asks_for(Requirement::ThreeRotations);
  if (target.asks_for(Requirement::RotationOrderZxy)) {
    give_one_order(rig, {Axis::Z, Axis::X, Axis::Y}, changes);
  } else if (for_all || target.asks_for(Requirement::ThreeRotationsOrNone)) {
    give_three_rotations(rig, !for_all, changes);
  }
}

void rewrite_ends(const TargetTraits& target, Rig& rig, ExportChanges& changes) {
  drop_end_site_names(rig, changes);
  if (target.asks_for(Requirement::NoInnerEndSites)) drop_inner_end_sites(rig, changes);
  if (target.asks_for(Requirement::EndSites)) close_limbs(rig, changes);
  note_bones_without_length(rig, changes);
}

std::vector<ExportedName> rewrite_names(const TargetTraits& target, Rig& rig, ExportChanges& changes) {
  if (target.asks_for(Requirement::WordNames)) return give_plain_names(rig, NameLetters::Words, changes);
  if (target.asks_for(Requirement::AsciiNames)) return give_plain_names(rig, NameLetters::Ascii, changes);
  return {};
}

struct Move {
  double distance = 0.0;
  NodeIndex node = 0;  // of the clip
  FrameIndex frame = 0;
};

Move find_largest_move(const Clip& clip, const ExportedClip& exported) {
  constexpr int kFramesAtOnce = 64;
  const int before_nodes = clip.skeleton.node_count();
  const int after_nodes = exported.skeleton.node_count();
  std::vector<double> before(idx(before_nodes) * 3 * kFramesAtOnce);
  std::vector<double> after(idx(after_nodes) * 3 * kFramesAtOnce);
  Move largest;
  for (FrameIndex first = 0; first < clip.motion.frame_count(); first += kFramesAtOnce) {
    const int count = std::min(kFramesAtOnce, clip.motion.frame_count() - first);
    const FrameRange shifted{first + exported.added_frames, count};
    compute_world_positions(clip.skeleton, clip.motion, {first, count}, clip.settings.position_rule,
                            std::span(before).first(idx(count * before_nodes) * 3));
    compute_world_positions(exported.skeleton, exported.motion, shifted, exported.position_rule,
                            std::span(after).first(idx(count * after_nodes) * 3));
    for (int i = 0; i < count * before_nodes; ++i) {
      const NodeIndex node = exported.nodes[idx(i % before_nodes)];
      if (node == kNoParent) continue;
      const double* a = &before[idx(i) * 3];
      const double* b = &after[(idx(i / before_nodes) * idx(after_nodes) + idx(node)) * 3];
      const double distance = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
      if (distance > largest.distance) largest = {distance, i % before_nodes, first + i / before_nodes};
    }
  }
  return largest;
}

void measure(const Clip& clip, ExportedClip& exported) {
  const Move move = find_largest_move(clip, exported);
  exported.largest_move = move.distance;
  const double stature = compute_stature(clip.skeleton);
  if (move.distance <= kUnmoved * (stature > 0.0 ? stature : 1.0)) return;
  const std::string part =
      stature > 0.0 ? fmt::format(" ({} % of the stature)", lint::rounded(100.0 * move.distance / stature)) : "";
  exported.changes.push_back(
      {Kind::JointsMoved, true, 1,
       fmt::format("Joints are up to {} units{} from their place, most {} in frame {}.", lint::rounded(move.distance),
                   part, lint::quoted(node_label(clip.skeleton, move.node)), move.frame + 1)});
}

void note_length(ExportTarget target, const Motion& motion, ExportChanges& changes) {
  if (target != ExportTarget::SecondLife || motion.duration_s() <= kSecondLifeLongest_s) return;
  changes.push_back({Kind::TooLong, false, 1,
                     fmt::format("The clip lasts {} s; Second Life takes {} s.", lint::rounded(motion.duration_s()),
                                 lint::rounded(kSecondLifeLongest_s))});
}

}  // namespace

std::string_view export_change_id(ExportChangeKind kind) { return kIds[static_cast<std::size_t>(kind)]; }

Result<ExportedClip> export_for_target(const Clip& clip, ExportTarget target, const ExportOptions& options) {
  const TargetTraits& traits = traits_of(target);
  const double most_samples = 6.0 * (clip.skeleton.joint_count() + 1) * (clip.motion.frame_count() + 1);
  if (most_samples + static_cast<double>(clip.motion.samples().size()) > kMaxResampledSamples) {
    return Error{DiagnosticCode::InvalidArgument, {}, "The clip is too long to be rewritten; take a part of it.", {}, {}};
  }
  ExportChanges changes;
  Rig rig = clip.motion.frame_count() > 0
                ? make_rig(clip, changes)
                : make_rig({clip.skeleton, rest_frame(clip, changes), clip.settings}, changes);
  rewrite_positions(traits, rig, changes);
  rewrite_rotations(traits, rig, changes);
  rewrite_ends(traits, rig, changes);
  std::vector<ExportedName> names = rewrite_names(traits, rig, changes);
  if (options.reference_pose.value_or(traits.asks_for(Requirement::ReferencePose))) add_reference_pose(rig, changes);
  const bool adds = traits.asks_for(Requirement::PositionsAddToOffset);
  Result<ExportedClip> exported =
      assembled(rig, adds ? PositionRule::Add : PositionRule::Replace, clip.skeleton.node_count());
  if (!exported) return exported;
  exported->changes = std::move(changes);
  exported->names = std::move(names);
  note_length(target, exported->motion, exported->changes);
  measure(clip, *exported);
  return exported;
}

std::string write_exported(const ExportedClip& clip, const SaveOptions& options) {
  BvhStyle style;
  NumberFormat plain;
  plain.exponent_below = -kMaxDecimals;
  plain.exponent_from = kMaxDecimals;
  style.header.offset_format = plain;
  style.motion.columns.assign(idx(clip.skeleton.channel_count()), ColumnStyle{" ", plain});
  return write_bvh(clip.skeleton, clip.motion, style, options);
}

}  // namespace marey
