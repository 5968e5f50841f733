// The recorded files of ../shared/bvh, where that folder is there.
#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <set>
#include <string>

#include "tests/core/bvh/bvh_texts.h"
#include "tests/support/files.h"
#include "tests/support/random.h"

namespace marey {
namespace {

using namespace test;
using Code = DiagnosticCode;

/// The files that must be refused, with the reason.
const std::map<std::string, Code>& refused_files() {
  static const std::map<std::string, Code> kRefused = {{"bvh/kv260/out.bvh", Code::EmptyFile}};
  return kRefused;
}

/// What an unedited file is allowed to say beyond notes.
const std::map<std::string, std::set<Code>>& files_with_warnings() {
  static const std::map<std::string, std::set<Code>> kWarnings = {
      {"bvh/tgriebel/TomTomTest.bvh", {Code::TextAfterMotion}}, {"bvh/trc2bvh/tst.bvh", {Code::MissingMotion}}};
  return kWarnings;
}

void expect_only_known_warnings(const std::string& path, const BvhClip& clip) {
  const auto known = files_with_warnings().find(path);
  for (const Diagnostic& diagnostic : clip.diagnostics.list()) {
    if (diagnostic.severity == Severity::Note) continue;
    EXPECT_TRUE(known != files_with_warnings().end() && known->second.contains(diagnostic.code))
        << path << "\n" << listing(clip);
  }
}

TEST(RecordedFiles, OpenOrAreRefusedForAStatedReasonAndComeOutByteForByte) {
  const std::vector<std::string> paths = recorded_bvh_files();
  if (paths.empty()) GTEST_SKIP() << "no recorded files at " << shared_dir();
  int read = 0;
  int same_bytes = 0;
  for (const std::string& path : paths) {
    const std::optional<std::string> text = read_shared_file(path);
    ASSERT_TRUE(text) << path;
    const auto refusal = refused_files().find(path);
    if (refusal != refused_files().end()) {
      EXPECT_EQ(refusal_of(*text).code, refusal->second) << path;
      continue;
    }
    const BvhClip clip = read_or_fail(*text);
    ++read;
    expect_only_known_warnings(path, clip);
    const std::string again = written(clip);
    EXPECT_EQ(again == *text, true) << path << " comes out differently";
    same_bytes += again == *text ? 1 : 0;
  }
  std::cout << paths.size() << " files, " << read << " read, " << same_bytes << " written byte for byte\n";
  EXPECT_EQ(read + static_cast<int>(refused_files().size()), static_cast<int>(paths.size()));
}

TEST(RecordedFiles, KeepTheirBitsAfterAnEdit) {
  const std::vector<std::string> paths = recorded_bvh_files();
  if (paths.empty()) GTEST_SKIP() << "no recorded files at " << shared_dir();
  Random random(31);
  for (const std::string& path : paths) {
    if (refused_files().contains(path)) continue;
    BvhClip clip = read_or_fail(read_shared_file(path).value_or(""));
    clip.skeleton.set_offset(random.below(clip.skeleton.node_count()), {random.unit(), -0.0, random.any_finite()});
    for (int edit = 0; edit < 20 && clip.motion.frame_count() > 0; ++edit) {
      const int channel = random.below(clip.motion.channel_count());
      const int frame = random.below(clip.motion.frame_count());
      clip.motion.channel_samples(channel)[static_cast<std::size_t>(frame)] = random.between(-180.0, 180.0);
    }
    const BvhClip again = read_or_fail(written(clip));
    EXPECT_TRUE(same_numbers(clip.skeleton, clip.motion, again.skeleton, again.motion)) << path;
    EXPECT_EQ(clip.skeleton, again.skeleton) << path;
  }
}

TEST(RecordedFiles, TellWhatTheirPositionsMean) {
  if (recorded_bvh_files().empty()) GTEST_SKIP() << "no recorded files at " << shared_dir();
  const std::set<std::string> additive = {"bvh/makehuman/benchmark.bvh", "bvh/makehuman/tpose.bvh"};
  for (const std::string& path : recorded_bvh_files()) {
    if (refused_files().contains(path)) continue;
    const BvhClip clip = read_or_fail(read_shared_file(path).value_or(""));
    EXPECT_EQ(clip.position_rule, additive.contains(path) ? PositionRule::Add : PositionRule::Replace) << path;
  }
}

}  // namespace
}  // namespace marey
