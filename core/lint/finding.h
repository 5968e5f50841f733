#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/index.h"

namespace marey {

/// What the linter knows about. `docs/command-line.md` explains each.
enum class FindingKind {
  DuplicateName,
  EmptyName,
  NameWithBlank,
  NameNotAscii,
  NameDiffersInCase,
  SeveralRoots,
  ZeroLengthBone,
  LeafWithoutEndSite,
  JointWithoutChannels,
  SingleChannelJoint,
  PositionBelowRoot,
  MixedRotationOrders,
  RareRotationOrder,
  UnusualChannelOrder,
  ReferencePose,
  Jump,
  Spike,
  AngleWrap,
  GimbalFlip,
  FrozenFigure,
  FrozenChannel,
  BelowFloor,
};

inline constexpr int kFindingKindCount = static_cast<int>(FindingKind::BelowFloor) + 1;

/// What is fixed about a kind.
struct FindingTraits {
  FindingKind kind{};
  std::string_view id;          ///< for programs, e.g. "angle_wrap"; it never changes its meaning
  std::string_view suggestion;  ///< what to do about it: whole sentences
  /// Programs that are known to refuse such a file, or to show it wrongly. Others may.
  std::span<const std::string_view> tools;
};

[[nodiscard]] const FindingTraits& traits_of(FindingKind kind);

/// Something about a clip that is legal but seldom meant, or that other programs stumble over. Nothing is broken by it.
struct Finding {
  FindingKind kind{};
  std::optional<JointIndex> joint;      ///< the first or the worst of those it is about
  std::optional<ChannelIndex> channel;  ///< the same for findings about curves
  std::optional<FrameRange> frames;     ///< where in time, from the first frame to the last that it is about
  int count = 1;                        ///< how many joints, channels or frames, as the message says
  std::string message;                  ///< a whole sentence; frames in it are numbered from 1
};

}  // namespace marey
