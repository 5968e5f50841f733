#include "core/base/diagnostic_code.h"

namespace marey {

std::string_view diagnostic_id(DiagnosticCode code) {
  switch (code) {
    case DiagnosticCode::UnexpectedToken: return "unexpected_token";
    case DiagnosticCode::UnexpectedEnd: return "unexpected_end";
    case DiagnosticCode::NotBvh: return "not_bvh";
    case DiagnosticCode::EmptyFile: return "empty_file";
    case DiagnosticCode::UnsupportedEncoding: return "unsupported_encoding";
    case DiagnosticCode::ByteOrderMark: return "byte_order_mark";
    case DiagnosticCode::TextAfterHierarchyEnd: return "text_after_hierarchy_end";
    case DiagnosticCode::MissingHierarchyKeyword: return "missing_hierarchy_keyword";
    case DiagnosticCode::MissingRoot: return "missing_root";
    case DiagnosticCode::MissingOpeningBrace: return "missing_opening_brace";
    case DiagnosticCode::MissingClosingBrace: return "missing_closing_brace";
    case DiagnosticCode::SurplusClosingBrace: return "surplus_closing_brace";
    case DiagnosticCode::JoinedTree: return "joined_tree";
    case DiagnosticCode::JointWithoutBlock: return "joint_without_block";
    case DiagnosticCode::MissingName: return "missing_name";
    case DiagnosticCode::DuplicateName: return "duplicate_name";
    case DiagnosticCode::KeywordCase: return "keyword_case";
    case DiagnosticCode::ChannelCase: return "channel_case";
    case DiagnosticCode::UnknownChannel: return "unknown_channel";
    case DiagnosticCode::ChannelCountMismatch: return "channel_count_mismatch";
    case DiagnosticCode::RepeatedChannel: return "repeated_channel";
    case DiagnosticCode::RepeatedChannelsLine: return "repeated_channels_line";
    case DiagnosticCode::RepeatedOffset: return "repeated_offset";
    case DiagnosticCode::MissingOffset: return "missing_offset";
    case DiagnosticCode::MissingChannels: return "missing_channels";
    case DiagnosticCode::OffsetValueCount: return "offset_value_count";
    case DiagnosticCode::OffsetBracketed: return "offset_bracketed";
    case DiagnosticCode::LeafWithoutEndSite: return "leaf_without_end_site";
    case DiagnosticCode::EndSiteBesideChildren: return "end_site_beside_children";
    case DiagnosticCode::SeveralEndSites: return "several_end_sites";
    case DiagnosticCode::NamedEndSite: return "named_end_site";
    case DiagnosticCode::SeveralRoots: return "several_roots";
    case DiagnosticCode::ZeroLengthBone: return "zero_length_bone";
    case DiagnosticCode::MissingMotion: return "missing_motion";
    case DiagnosticCode::MissingFrameCount: return "missing_frame_count";
    case DiagnosticCode::MissingFrameTime: return "missing_frame_time";
    case DiagnosticCode::FrameCountMismatch: return "frame_count_mismatch";
    case DiagnosticCode::PartialFrame: return "partial_frame";
    case DiagnosticCode::RowLength: return "row_length";
    case DiagnosticCode::SurplusValues: return "surplus_values";
    case DiagnosticCode::BadNumber: return "bad_number";
    case DiagnosticCode::NumbersRunTogether: return "numbers_run_together";
    case DiagnosticCode::DecimalComma: return "decimal_comma";
    case DiagnosticCode::NotFinite: return "not_finite";
    case DiagnosticCode::NumberRange: return "number_range";
    case DiagnosticCode::FrameTimeNotPositive: return "frame_time_not_positive";
    case DiagnosticCode::FrameTimeLooksLikeRate: return "frame_time_looks_like_rate";
    case DiagnosticCode::Comment: return "comment";
    case DiagnosticCode::TextAfterMotion: return "text_after_motion";
    case DiagnosticCode::TrailingNul: return "trailing_nul";
    case DiagnosticCode::PositionsReplaceOffset: return "positions_replace_offset";
    case DiagnosticCode::PositionsAddToOffset: return "positions_add_to_offset";
    case DiagnosticCode::PositionsAmbiguous: return "positions_ambiguous";
    case DiagnosticCode::LimitJoints: return "limit_joints";
    case DiagnosticCode::LimitDepth: return "limit_depth";
    case DiagnosticCode::LimitFrames: return "limit_frames";
    case DiagnosticCode::LimitMemory: return "limit_memory";
    case DiagnosticCode::LimitChannels: return "limit_channels";
    case DiagnosticCode::InvalidSkeleton: return "invalid_skeleton";
    case DiagnosticCode::InvalidArgument: return "invalid_argument";
    case DiagnosticCode::NothingSelected: return "nothing_selected";
    case DiagnosticCode::NoFrames: return "no_frames";
  }
  return "unknown";
}

}  // namespace marey
