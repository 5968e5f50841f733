// After an edit, everything that was not edited keeps its bytes: shown word by word over generated and recorded files.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/index.h"
#include "core/base/text_cursor.h"
#include "tests/core/bvh/bvh_texts.h"
#include "tests/support/files.h"
#include "tests/support/random.h"

namespace marey {
namespace {

using namespace test;

/// A word with the blanks before it.
struct Token {
  std::string_view gap;
  std::string_view word;
  int line = 0;
};

std::vector<Token> tokens_of(std::string_view text) {
  std::vector<Token> tokens;
  int line = 1;
  std::size_t at = 0;
  while (at < text.size()) {
    std::size_t begin = at;
    for (; begin < text.size() && is_blank(text[begin]); ++begin) line += text[begin] == '\n' ? 1 : 0;
    std::size_t end = begin;
    while (end < text.size() && !is_blank(text[end])) ++end;
    tokens.push_back({text.substr(at, begin - at), text.substr(begin, end - begin), line});
    at = end;
  }
  return tokens;
}

/// The edits of a clip: what its text has to say anew.
struct Edits {
  std::set<std::pair<FrameIndex, ChannelIndex>> samples;
  int other_numbers = 0;
};

Edits edit_at_random(BvhClip& clip, Random& random) {
  Edits edits;
  for (int i = 0; i < 6 && clip.motion.samples().size() > 0; ++i) {
    const FrameIndex frame = random.below(clip.motion.frame_count());
    const ChannelIndex channel = random.below(clip.motion.channel_count());
    if (!edits.samples.emplace(frame, channel).second) continue;
    clip.motion.channel_samples(channel)[idx(frame)] += 0.25 + random.unit();
  }
  const NodeIndex node = random.below(clip.skeleton.node_count());
  glm::dvec3 offset = clip.skeleton.node(node).offset;
  offset.y += 0.5;
  clip.skeleton.set_offset(node, offset);
  ++edits.other_numbers;
  if (clip.motion.frame_count() > 0) {
    clip.motion.set_frame_time_s(clip.motion.frame_time_s() * 1.5);
    ++edits.other_numbers;
  }
  return edits;
}

/// Lines that differ. Fails unless exactly the edited numbers differ.
int expect_only_edits(const std::string& text, const std::string& edited, const Edits& edits) {
  const std::vector<Token> before = tokens_of(text);
  const std::vector<Token> after = tokens_of(edited);
  if (before.size() != after.size()) {
    ADD_FAILURE() << before.size() << " words became " << after.size();
    return 0;
  }
  int changed = 0;
  std::set<int> lines;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (before[i].gap != after[i].gap) ADD_FAILURE() << "the blanks in line " << before[i].line << " changed";
    if (before[i].word == after[i].word) continue;
    ++changed;
    lines.insert(before[i].line);
  }
  EXPECT_EQ(changed, size_of(edits.samples) + edits.other_numbers);
  return size_of(lines);
}

TEST(EditedLines, AreTheOnlyOnesThatChangeInRecordedFiles) {
  Random random(41);
  int files = 0;
  int lines = 0;
  int changed_lines = 0;
  for (const std::string& path : recorded_bvh_files()) {
    const std::string text = read_shared_file(path).value_or("");
    Result<BvhClip> clip = read_bvh(text);
    if (!clip) continue;
    SCOPED_TRACE(path);
    const Edits edits = edit_at_random(*clip, random);
    const std::string edited = written(*clip);
    changed_lines += expect_only_edits(text, edited, edits);
    lines += static_cast<int>(std::count(text.begin(), text.end(), '\n'));
    const BvhClip again = read_or_fail(edited);
    EXPECT_TRUE(same_numbers(clip->skeleton, clip->motion, again.skeleton, again.motion));
    ++files;
  }
  if (files == 0) GTEST_SKIP() << "no recorded files at " << shared_dir();
  std::cout << files << " files edited: " << changed_lines << " of " << lines << " lines changed, each by an edit\n";
}

TEST(EditedLines, AreTheOnlyOnesThatChangeInOddTexts) {
  Random random(42);
  const std::vector<std::string> texts = {
      one_joint_file("3", "1.50 2.25 3.00\r\n 4.50  5.25 6\n7.50 8.25 9.00"),
      one_joint_file("3", "# first\n1 2 3\n4 5 6 # second\n// third\n7 8 9\n\n\n"),
      one_joint_file("3", "1\n2 3\n4\n5 6\n7\n8 9\n"), one_joint_file("3", "1 2 3 4 5 6 7 8 9\n"),
      one_joint_file("2", "\t.5\t-.25\t1e-007\t\n\t+1.50\t007\t-0\t\nnotes 1 2 3\n"),
      "\xef\xbb\xbf# mark\r\n" + replaced(one_joint_file("2", "1 2 3\n4 5 6\n"), "\n", "\r\n")};
  for (const std::string& text : texts) {
    for (int i = 0; i < 50; ++i) {
      SCOPED_TRACE(text);
      BvhClip clip = read_or_fail(text);
      const Edits edits = edit_at_random(clip, random);
      expect_only_edits(text, written(clip), edits);
      if (HasFailure()) return;
    }
  }
}

}  // namespace
}  // namespace marey
