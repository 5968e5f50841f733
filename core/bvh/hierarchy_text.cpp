#include "core/bvh/hierarchy_text.h"

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/bvh/joint_name.h"
#include "core/bvh/keyword.h"
#include "core/bvh/keyword_reader.h"
#include "core/bvh/row_text.h"

namespace marey {
namespace {

class HierarchyParser {
 public:
  HierarchyParser(TextCursor& cursor, const ReadLimits& limits, Report& report)
      : cursor_(cursor), limits_(limits), report_(report) {}

  HierarchyText read();

 private:
  bool read_statement();
  void read_keyword(Keyword keyword, std::size_t place);
  void skip_unknown_word();
  void check_start(std::size_t begin);

  void open_block(RawBlock::Kind kind, std::size_t place, std::string_view name_bytes);
  void read_joint(RawBlock::Kind kind, std::size_t place);
  void read_end_site(std::size_t place);
  void open_brace();
  void close_brace();
  void settle_missing_body(bool block_goes_on);
  void push_open(int block, std::size_t place);

  void read_offset(std::size_t place);
  void read_channels(std::size_t place);
  void check_channel_line(RawBlock& block, std::size_t place);

  RawBlock* current_block();

  TextCursor& cursor_;
  const ReadLimits& limits_;
  Report& report_;
  HierarchyText result_;
  std::vector<int> open_;
  bool awaits_brace_ = false;
  bool seen_keyword_ = false;
  std::size_t first_keyword_ = 0;
  std::size_t keyword_end_ = 0;
  int joints_ = 0;
  int end_sites_ = 0;
  int nameless_blocks_ = 0;
  int channels_ = 0;
};

HierarchyText HierarchyParser::read() {
  const std::size_t begin = cursor_.offset();
  while (!report_.failed() && read_statement()) {
  }
  if (awaits_brace_) settle_missing_body(false);
  result_.end = cursor_.offset();
  if (!report_.failed()) check_start(begin);
  return std::move(result_);
}

/// False at the end of the section.
bool HierarchyParser::read_statement() {
  skip_blanks_and_comments(cursor_, report_);
  if (cursor_.at_end()) return false;
  const std::size_t place = cursor_.offset();
  if (cursor_.peek() == '{') {
    open_brace();
    return true;
  }
  if (cursor_.peek() == '}') {
    close_brace();
    return true;
  }
  Keyword keyword = find_keyword(cursor_.peek_word());
  if (keyword == Keyword::None) keyword = find_misspelled_keyword(cursor_.peek_word());
  if (!seen_keyword_ && is_text_before_hierarchy(keyword, cursor_.rest())) keyword = Keyword::None;
  if (keyword == Keyword::Motion || keyword == Keyword::Frames || keyword == Keyword::Frame) return false;
  if (keyword == Keyword::None) {
    skip_unknown_word();
  } else {
    read_keyword(keyword, place);
  }
  return true;
}

void HierarchyParser::read_keyword(Keyword keyword, std::size_t place) {
  if (awaits_brace_) settle_missing_body(keyword == Keyword::Offset || keyword == Keyword::Channels);
  if (!seen_keyword_) first_keyword_ = place;
  const bool first = !seen_keyword_;
  seen_keyword_ = true;
  if (first && keyword != Keyword::Hierarchy) {
    result_.patches.insert(place, std::string(keyword_text(Keyword::Hierarchy)) + "\n");
    report_.add(DiagnosticCode::MissingHierarchyKeyword, place, "The file does not begin with HIERARCHY; it was added.",
                "HIERARCHY", std::string(keyword_text(keyword)));
  }
  take_keyword(cursor_, keyword, result_.patches, report_);
  switch (keyword) {
    case Keyword::Root: read_joint(RawBlock::Kind::Root, place); break;
    case Keyword::Joint: read_joint(RawBlock::Kind::Joint, place); break;
    case Keyword::End: read_end_site(place); break;
    case Keyword::Offset: read_offset(place); break;
    case Keyword::Channels: read_channels(place); break;
    default: break;
  }
}

void HierarchyParser::skip_unknown_word() {
  const std::size_t place = cursor_.offset();
  const std::string_view word = cursor_.take_word();
  if (!seen_keyword_) return;  // check_start() says what the text is
  result_.patches.remove(place, word.size());
  const bool behind_tree = open_.empty() && !result_.blocks.empty() && !awaits_brace_;
  report_.add_each(behind_tree ? DiagnosticCode::TextAfterHierarchyEnd : DiagnosticCode::UnexpectedToken, place,
                   fmt::format("'{}' means nothing here and was left out.", shown(word)),
                   behind_tree ? "MOTION" : "OFFSET, CHANNELS, JOINT, End Site or '}'", shown(word));
}

/// Judges what stands before the first keyword, once it is known whether there is one.
void HierarchyParser::check_start(std::size_t begin) {
  TextCursor start(cursor_.text(), begin);
  pass_blanks_and_comments(start);
  const std::string_view word = start.peek_word().empty() ? start.rest().substr(0, 1) : start.peek_word();
  const Keyword keyword = find_keyword(word);
  if (!seen_keyword_ && keyword != Keyword::Motion && keyword != Keyword::Frames) {
    report_.fail(DiagnosticCode::NotBvh, start.offset(),
                 "This is not a BVH file: it has neither HIERARCHY nor ROOT. Open a file written as BVH.", "HIERARCHY",
                 shown(word));
  } else if (seen_keyword_ && start.offset() < first_keyword_) {
    result_.patches.remove(start.offset(), first_keyword_ - start.offset());
    report_.add(DiagnosticCode::UnexpectedToken, start.offset(),
                fmt::format("The text before HIERARCHY, beginning with '{}', was left out.", shown(word)), "HIERARCHY",
                shown(word));
  }
}

RawBlock* HierarchyParser::current_block() {
  for (auto i = open_.rbegin(); i != open_.rend(); ++i) {
    if (*i != kNamelessBlock) return &result_.blocks[idx(*i)];
  }
  return nullptr;
}

void HierarchyParser::open_block(RawBlock::Kind kind, std::size_t place, std::string_view name_bytes) {
  if (RawBlock* parent = current_block(); parent != nullptr && kind != RawBlock::Kind::Root) parent->has_child = true;
  int& count = kind == RawBlock::Kind::EndSite ? end_sites_ : joints_;
  if (++count > limits_.max_joints) {
    report_.fail(DiagnosticCode::LimitJoints, place,
                 fmt::format("The figure has more than {} {}, which is the limit for a file.", limits_.max_joints,
                             kind == RawBlock::Kind::EndSite ? "end sites" : "joints"));
    return;
  }
  RawBlock block;
  block.kind = kind;
  block.name = trimmed(name_bytes);
  block.name_bytes = name_bytes;
  block.place = place;
  block.keyword_end = keyword_end_;
  result_.blocks.push_back(std::move(block));
  awaits_brace_ = true;
}

void HierarchyParser::read_joint(RawBlock::Kind kind, std::size_t place) {
  keyword_end_ = cursor_.offset();
  std::string_view name = take_joint_name(cursor_);
  if (name.empty()) {
    cursor_.skip_blanks();
    if (find_keyword(cursor_.peek_word()) == Keyword::None) name = take_joint_name(cursor_);
  }
  if (name.empty()) {
    report_.add_each(DiagnosticCode::MissingName, place, "The joint has no name; it is told apart by its place only.",
                     "a name", "");
  }
  open_block(kind, place, name);
}

void HierarchyParser::read_end_site(std::size_t place) {
  take_site(cursor_, place, result_.patches, report_);
  keyword_end_ = cursor_.offset();
  cursor_.skip_blanks_in_line();
  const std::string_view name = starts_comment(cursor_.rest()) ? std::string_view() : take_joint_name(cursor_);
  if (!name.empty()) {
    report_.add(DiagnosticCode::NamedEndSite, place,
                fmt::format("The end site has a name ('{}'), which was kept; some other programs refuse it.", shown(trimmed(name))),
                "End Site", shown(trimmed(name)));
  }
  open_block(RawBlock::Kind::EndSite, place, name);
}

void HierarchyParser::push_open(int block, std::size_t place) {
  if (size_of(open_) >= limits_.max_depth) {
    report_.fail(DiagnosticCode::LimitDepth, place,
                 fmt::format("The joints are nested more than {} deep, which is the limit for a file.", limits_.max_depth));
    return;
  }
  open_.push_back(block);
}

void HierarchyParser::open_brace() {
  const std::size_t place = cursor_.offset();
  cursor_.take_word();
  if (awaits_brace_) {
    awaits_brace_ = false;
    result_.events.push_back({size_of(result_.blocks) - 1, 0, place});
    push_open(size_of(result_.blocks) - 1, place);
    return;
  }
  if (!seen_keyword_) return;
  result_.patches.give_up();
  report_.add_each(DiagnosticCode::UnexpectedToken, place, "'{' opens a block that no JOINT announces; it was passed over.",
                   "OFFSET, CHANNELS, JOINT, End Site or '}'", "{");
  if (++nameless_blocks_ > limits_.max_joints) {
    report_.fail(DiagnosticCode::LimitJoints, place,
                 fmt::format("The file has more than {} blocks that no JOINT announces, which is the limit.",
                             limits_.max_joints));
  }
  result_.events.push_back({kNamelessBlock, 0, place});
  push_open(kNamelessBlock, place);
}

void HierarchyParser::close_brace() {
  if (awaits_brace_) settle_missing_body(false);
  const std::size_t place = cursor_.offset();
  cursor_.take_word();
  if (!seen_keyword_) return;
  if (!open_.empty()) open_.pop_back();
  if (!result_.events.empty() && result_.events.back().closings > 0) {
    ++result_.events.back().closings;
  } else {
    result_.events.push_back({kNamelessBlock, 1, place});
  }
}

void HierarchyParser::settle_missing_body(bool block_goes_on) {
  awaits_brace_ = false;
  RawBlock& block = result_.blocks.back();
  const int index = size_of(result_.blocks) - 1;
  result_.events.push_back({index, 0, block.place});
  if (block_goes_on) {
    const std::size_t at = cursor_.offset();
    result_.patches.insert(at, "{\n" + indent_before(cursor_.text(), at));
    report_.add_each(DiagnosticCode::MissingOpeningBrace, cursor_.offset(),
                     fmt::format("The '{{' of {} is missing; it was added.", description_of(block)), "{",
                     shown(cursor_.peek_word()));
    push_open(index, block.place);
    return;
  }
  block.has_body = false;
  result_.patches.give_up();
  const std::string what = block.kind == RawBlock::Kind::EndSite ? "The end site" : "Joint " + description_of(block);
  report_.add_each(DiagnosticCode::JointWithoutBlock, block.place,
                   what + " has no block; it was read as a point at its parent, without channels.", "{",
                   shown(cursor_.peek_word().empty() ? cursor_.rest().substr(0, 1) : cursor_.peek_word()));
}

void HierarchyParser::read_offset(std::size_t place) {
  RawBlock* block = current_block();
  const std::size_t keyword_end = cursor_.offset();
  OffsetRead read = read_offset_values(cursor_, report_);
  if (block == nullptr) {
    result_.patches.remove(place, read.end - place);
    report_.add_each(DiagnosticCode::UnexpectedToken, place, "This OFFSET belongs to no joint; it was left out.",
                     "ROOT", "OFFSET");
    return;
  }
  result_.patches.append(read.patches);
  if (block->has_offset) {
    result_.patches.remove(block->offset_place, block->offset.end - block->offset_place);
    report_.add_each(DiagnosticCode::RepeatedOffset, place,
                     fmt::format("{} has a second OFFSET; the last one is used.", description_of(*block)), "CHANNELS",
                     "OFFSET");
  }
  block->has_offset = true;
  block->offset_place = place;
  block->offset_end = keyword_end;
  block->offset = std::move(read);
  if (block->offset.count == 3) return;
  block->offset_readings = find_offset_readings(cursor_.text(), block->offset);
  const bool decided = block->offset_readings.size() == 1 || report_.strict();
  if (!decided) return;
  patch_offset(block->offset, keyword_end, block->offset_readings.front(), result_.patches);
  report_offset_reading(description_of(*block), place, block->offset.count, block->offset_readings.front(), report_);
}

void HierarchyParser::check_channel_line(RawBlock& block, std::size_t place) {
  if (block.has_channels) {
    result_.patches.give_up();
    report_.add_each(DiagnosticCode::RepeatedChannelsLine, place,
                     fmt::format("{} has a second CHANNELS line; its channels were added to the first.",
                                 description_of(block)),
                     "JOINT or End Site", "CHANNELS");
  }
  if (block.has_child) {
    result_.patches.give_up();
    report_.add_each(DiagnosticCode::UnexpectedToken, place,
                     fmt::format("The CHANNELS of {} stand behind its first child; they were read before it.",
                                 description_of(block)),
                     "JOINT, End Site or '}'", "CHANNELS");
  }
  block.has_channels = true;
}

void HierarchyParser::read_channels(std::size_t place) {
  RawBlock stray;
  RawBlock* block = current_block();
  if (block == nullptr) {
    report_.add_each(DiagnosticCode::UnexpectedToken, place, "These CHANNELS belong to no joint; they were left out.",
                     "ROOT", "CHANNELS");
    block = &stray;
  }
  check_channel_line(*block, place);
  const ChannelsRead read = read_channel_names(cursor_, limits_.max_channels + 1 - channels_, report_);
  if (block == &stray) {
    result_.patches.remove(place, read.end - place);
  } else {
    result_.patches.append(read.patches);
  }
  block->channels.insert(block->channels.end(), read.channels.begin(), read.channels.end());
  channels_ += size_of(read.channels);
  if (channels_ > limits_.max_channels) {
    report_.fail(DiagnosticCode::LimitChannels, place,
                 fmt::format("The file has more than {} channels, which is the limit.", limits_.max_channels));
  }
}

}  // namespace

std::string description_of(const RawBlock& block) {
  if (block.kind == RawBlock::Kind::EndSite) return "the end site";
  return block.name.empty() ? "the joint without a name" : fmt::format("'{}'", shown(block.name));
}

HierarchyText read_hierarchy_text(TextCursor& cursor, const ReadLimits& limits, Report& report) {
  return HierarchyParser(cursor, limits, report).read();
}

}  // namespace marey
