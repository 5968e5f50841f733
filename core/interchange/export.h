#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/bvh/save_options.h"
#include "core/interchange/export_target.h"
#include "core/motion/clip.h"

namespace marey {

/// What an export did to a clip.
enum class ExportChangeKind : std::uint8_t {
  ChannelsDropped,    ///< scales and unknown channels
  ChannelsReordered,  ///< positions put before rotations; the same movement
  RootAdded,
  PositionsDropped,   ///< of joints below the root
  PositionsAdded,     ///< channels that were not there, with the OFFSET as value
  RootOffsetMoved,    ///< into the positions
  RotationsAdded,     ///< channels that stay 0
  RotationsSolved,    ///< other angles for the same rotation
  NamesChanged,
  EndSitesAdded,
  EndSitesDropped,
  EndSiteNamesDropped,
  PoseAdded,          ///< a first frame
  BonesWithoutLength,  ///< kept, which some programs show otherwise
  TooLong,            ///< for the target; kept
  JointsMoved,        ///< how far the result is from the clip
};

inline constexpr int kExportChangeKindCount = static_cast<int>(ExportChangeKind::JointsMoved) + 1;

/// "names_changed": for programs; it never changes its meaning.
[[nodiscard]] std::string_view export_change_id(ExportChangeKind kind);

struct ExportChange {
  ExportChangeKind kind{};
  bool is_loss = false;  ///< something of the clip is not in the file; else it says the same in another way
  int count = 1;         ///< how many joints, channels or nodes
  std::string message;   ///< a whole sentence, with numbers
};

/// A joint that goes by another name in the file.
struct ExportedName {
  JointIndex joint = 0;  ///< in the exported skeleton
  std::string before;    ///< bytes as in the clip
  std::string after;
};

/// A clip as a program wants it, and what that costs.
struct ExportedClip {
  Skeleton skeleton;
  Motion motion;
  PositionRule position_rule = PositionRule::Replace;  ///< of the program: with it the positions are those of the clip
  std::vector<ExportChange> changes;                   ///< in the order in which they were made
  std::vector<ExportedName> names;                     ///< that changed
  std::vector<NodeIndex> nodes;  ///< for each node of the clip its node in `skeleton`; kNoParent where it was dropped
  int added_frames = 0;          ///< in front of the first frame of the clip: 0 or 1
  double largest_move = 0.0;     ///< greatest distance of a node from where the clip has it, over all frames, file units
};

struct ExportOptions {
  /// Whether the rest pose is the first frame; by default as the target wants it.
  std::optional<bool> reference_pose;
};

/// Rewrites a clip so that the target shows the same movement, as far as it can. World positions stay within 1e-9 of
/// the stature unless a change of kind JointsMoved says how far they move.
/// Error InvalidArgument: the clip is so long that the result could have more than kMaxResampledSamples samples.
[[nodiscard]] Result<ExportedClip> export_for_target(const Clip& clip, ExportTarget target,
                                                     const ExportOptions& options = {});

/// The BVH file: the canonical form, without exponents, LF, UTF-8, but for what `options` ask; their frames count those
/// of the exported clip.
[[nodiscard]] std::string write_exported(const ExportedClip& clip, const SaveOptions& options = {});

}  // namespace marey
