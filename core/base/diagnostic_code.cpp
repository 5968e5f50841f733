#include "core/base/diagnostic_code.h"

#include <array>
#include <cstddef>

namespace marey {
namespace {

using Code = DiagnosticCode;

constexpr std::array<DiagnosticTraits, kDiagnosticCodeCount> kTraits = {{
    {Code::UnexpectedToken, "unexpected_token", Severity::Warning, true},
    {Code::UnexpectedEnd, "unexpected_end", Severity::Error, true},
    {Code::NotBvh, "not_bvh", Severity::Error, true},
    {Code::EmptyFile, "empty_file", Severity::Error, true},
    {Code::UnsupportedEncoding, "unsupported_encoding", Severity::Error, true},
    {Code::Utf16Text, "utf16_text", Severity::Note, true},
    {Code::ByteOrderMark, "byte_order_mark", Severity::Note, true},
    {Code::WideBlank, "wide_blank", Severity::Warning, true},
    {Code::TextAfterHierarchyEnd, "text_after_hierarchy_end", Severity::Warning, true},
    {Code::MissingHierarchyKeyword, "missing_hierarchy_keyword", Severity::Warning, true},
    {Code::MissingRoot, "missing_root", Severity::Error, true},
    {Code::JointOutsideRoot, "joint_outside_root", Severity::Warning, true},
    {Code::MissingOpeningBrace, "missing_opening_brace", Severity::Warning, true},
    {Code::MissingClosingBrace, "missing_closing_brace", Severity::Warning, true},
    {Code::SurplusClosingBrace, "surplus_closing_brace", Severity::Warning, true},
    {Code::JoinedTree, "joined_tree", Severity::Warning, true},
    {Code::JointWithoutBlock, "joint_without_block", Severity::Warning, true},
    {Code::MissingName, "missing_name", Severity::Warning, true},
    {Code::DuplicateName, "duplicate_name", Severity::Note, false},
    {Code::NamesNotUtf8, "names_not_utf8", Severity::Note, false},
    {Code::KeywordCase, "keyword_case", Severity::Warning, true},
    {Code::ChannelCase, "channel_case", Severity::Warning, true},
    {Code::UnknownChannel, "unknown_channel", Severity::Warning, true},
    {Code::ChannelCountMismatch, "channel_count_mismatch", Severity::Warning, true},
    {Code::RepeatedChannel, "repeated_channel", Severity::Note, false},
    {Code::RepeatedChannelsLine, "repeated_channels_line", Severity::Warning, true},
    {Code::ScaleChannel, "scale_channel", Severity::Warning, false},
    {Code::RepeatedOffset, "repeated_offset", Severity::Warning, true},
    {Code::MissingOffset, "missing_offset", Severity::Warning, true},
    {Code::MissingChannels, "missing_channels", Severity::Warning, true},
    {Code::OffsetValueCount, "offset_value_count", Severity::Warning, true},
    {Code::OffsetBracketed, "offset_bracketed", Severity::Warning, true},
    {Code::LeafWithoutEndSite, "leaf_without_end_site", Severity::Note, true},
    {Code::EndSiteBesideChildren, "end_site_beside_children", Severity::Note, true},
    {Code::EndSiteWithChannels, "end_site_with_channels", Severity::Warning, true},
    {Code::SeveralEndSites, "several_end_sites", Severity::Note, true},
    {Code::NamedEndSite, "named_end_site", Severity::Note, true},
    {Code::SeveralRoots, "several_roots", Severity::Note, false},
    {Code::ZeroLengthBone, "zero_length_bone", Severity::Note, false},
    {Code::MissingMotion, "missing_motion", Severity::Warning, true},
    {Code::MissingFrameCount, "missing_frame_count", Severity::Warning, true},
    {Code::MissingFrameTime, "missing_frame_time", Severity::Warning, true},
    {Code::RepeatedFrameCount, "repeated_frame_count", Severity::Warning, true},
    {Code::RepeatedFrameTime, "repeated_frame_time", Severity::Warning, true},
    {Code::FrameCountMismatch, "frame_count_mismatch", Severity::Warning, true},
    {Code::PartialFrame, "partial_frame", Severity::Error, true},
    {Code::RowLength, "row_length", Severity::Warning, true},
    {Code::SurplusValues, "surplus_values", Severity::Warning, true},
    {Code::BadNumber, "bad_number", Severity::Error, true},
    {Code::NumbersRunTogether, "numbers_run_together", Severity::Warning, true},
    {Code::DecimalComma, "decimal_comma", Severity::Warning, true},
    {Code::CommaBetweenNumbers, "comma_between_numbers", Severity::Warning, true},
    {Code::NotFinite, "not_finite", Severity::Error, true},
    {Code::NumberRange, "number_range", Severity::Warning, true},
    {Code::FrameTimeNotPositive, "frame_time_not_positive", Severity::Warning, true},
    {Code::FrameTimeLooksLikeRate, "frame_time_looks_like_rate", Severity::Warning, false},
    {Code::Comment, "comment", Severity::Note, true},
    {Code::TextAfterMotion, "text_after_motion", Severity::Warning, true},
    {Code::TrailingNul, "trailing_nul", Severity::Warning, true},
    {Code::PositionsReplaceOffset, "positions_replace_offset", Severity::Note, false},
    {Code::PositionsAddToOffset, "positions_add_to_offset", Severity::Note, false},
    {Code::PositionsAmbiguous, "positions_ambiguous", Severity::Warning, false},
    {Code::LimitJoints, "limit_joints", Severity::Error, true},
    {Code::LimitDepth, "limit_depth", Severity::Error, true},
    {Code::LimitFrames, "limit_frames", Severity::Error, true},
    {Code::LimitMemory, "limit_memory", Severity::Error, true},
    {Code::LimitChannels, "limit_channels", Severity::Error, true},
    {Code::TableHeader, "table_header", Severity::Error, true},
    {Code::TableKind, "table_kind", Severity::Error, true},
    {Code::TableUnit, "table_unit", Severity::Error, true},
    {Code::TableColumnMissing, "table_column_missing", Severity::Warning, true},
    {Code::TableColumnUnknown, "table_column_unknown", Severity::Warning, true},
    {Code::TableGap, "table_gap", Severity::Warning, true},
    {Code::TableTimeMissing, "table_time_missing", Severity::Note, false},
    {Code::TableTimeRounded, "table_time_rounded", Severity::Note, false},
    {Code::TableTimeUneven, "table_time_uneven", Severity::Error, true},
    {Code::OutOfMemory, "out_of_memory", Severity::Error, true},
    {Code::InvalidSkeleton, "invalid_skeleton", Severity::Error, true},
    {Code::InvalidArgument, "invalid_argument", Severity::Error, true},
    {Code::Cancelled, "cancelled", Severity::Error, true},
}};

constexpr bool rows_follow_the_enum() {
  for (std::size_t i = 0; i < kTraits.size(); ++i) {
    if (kTraits[i].code != static_cast<Code>(i) || kTraits[i].id.empty()) return false;
  }
  return true;
}
static_assert(rows_follow_the_enum());

}  // namespace

std::string_view severity_name(Severity severity) {
  switch (severity) {
    case Severity::Note: return "note";
    case Severity::Warning: return "warning";
    case Severity::Error: return "error";
  }
  return "error";
}

const DiagnosticTraits& traits_of(DiagnosticCode code) { return kTraits[static_cast<std::size_t>(code)]; }

std::string_view diagnostic_id(DiagnosticCode code) { return traits_of(code).id; }

}  // namespace marey
