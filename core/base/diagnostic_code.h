#pragma once

#include <string_view>

namespace marey {

/// Note: an assumption worth knowing. Warning: the text was repaired, or other tools would read it differently.
/// Error: something in the file could not be used.
enum class Severity { Note, Warning, Error };

/// "note", "warning", "error".
[[nodiscard]] std::string_view severity_name(Severity severity);

/// Every finding and refusal that core can report. `docs/diagnostics.md` explains each.
enum class DiagnosticCode {
  UnexpectedToken,
  UnexpectedEnd,
  NotBvh,
  EmptyFile,
  UnsupportedEncoding,
  Utf16Text,
  ByteOrderMark,
  WideBlank,
  TextAfterHierarchyEnd,
  MissingHierarchyKeyword,
  MissingRoot,
  JointOutsideRoot,
  MissingOpeningBrace,
  MissingClosingBrace,
  SurplusClosingBrace,
  JoinedTree,
  JointWithoutBlock,
  MissingName,
  DuplicateName,
  NamesNotUtf8,
  KeywordCase,
  ChannelCase,
  UnknownChannel,
  ChannelCountMismatch,
  RepeatedChannel,
  RepeatedChannelsLine,
  ScaleChannel,
  RepeatedOffset,
  MissingOffset,
  MissingChannels,
  OffsetValueCount,
  OffsetBracketed,
  LeafWithoutEndSite,
  EndSiteBesideChildren,
  EndSiteWithChannels,
  SeveralEndSites,
  NamedEndSite,
  SeveralRoots,
  ZeroLengthBone,
  MissingMotion,
  MissingFrameCount,
  MissingFrameTime,
  RepeatedFrameCount,
  RepeatedFrameTime,
  FrameCountMismatch,
  PartialFrame,
  RowLength,
  SurplusValues,
  BadNumber,
  NumbersRunTogether,
  DecimalComma,
  CommaBetweenNumbers,
  NotFinite,
  NumberRange,
  FrameTimeNotPositive,
  FrameTimeLooksLikeRate,
  Comment,
  TextAfterMotion,
  TrailingNul,
  PositionsReplaceOffset,
  PositionsAddToOffset,
  PositionsAmbiguous,
  LimitJoints,
  LimitDepth,
  LimitFrames,
  LimitMemory,
  LimitChannels,
  TableHeader,
  TableKind,
  TableUnit,
  TableColumnMissing,
  TableColumnUnknown,
  TableGap,
  TableTimeMissing,
  TableTimeRounded,
  TableTimeUneven,
  OutOfMemory,
  InvalidSkeleton,
  InvalidArgument,
  Cancelled,
};

inline constexpr int kDiagnosticCodeCount = static_cast<int>(DiagnosticCode::Cancelled) + 1;

/// What is fixed about a code.
struct DiagnosticTraits {
  DiagnosticCode code{};
  std::string_view id;  ///< for programs, e.g. "offset_value_count"; it never changes its meaning
  Severity severity = Severity::Error;
  bool refused_when_strict = true;  ///< a strict reader refuses the file instead of reporting this
};

[[nodiscard]] const DiagnosticTraits& traits_of(DiagnosticCode code);

/// Shorthand for `traits_of(code).id`.
[[nodiscard]] std::string_view diagnostic_id(DiagnosticCode code);

}  // namespace marey
