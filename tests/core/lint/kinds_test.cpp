// The kinds of findings, their page, and what is found in the samples and in recorded files.
#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include "core/bvh/reader.h"
#include "core/kinematics/clip_bounds.h"
#include "tests/core/lint/lint_clips.h"
#include "tests/support/files.h"

namespace marey {
namespace {

using namespace test;

Clip make_clip(BvhClip file) {
  Clip clip{std::move(file.skeleton), std::move(file.motion), {}};
  clip.settings.position_rule = file.position_rule;
  clip.settings.up_axis = find_up_axis(clip.skeleton, clip.motion, clip.settings.position_rule);
  return clip;
}

std::set<std::string> all_ids() {
  std::set<std::string> ids;
  for (int kind = 0; kind < kFindingKindCount; ++kind) ids.emplace(traits_of(static_cast<FindingKind>(kind)).id);
  return ids;
}

TEST(FindingKinds, HaveIdsOfTheirOwnAndWholeSentences) {
  EXPECT_EQ(all_ids().size(), idx(kFindingKindCount));
  for (int kind = 0; kind < kFindingKindCount; ++kind) {
    const FindingTraits& traits = traits_of(static_cast<FindingKind>(kind));
    EXPECT_EQ(traits.kind, static_cast<FindingKind>(kind));
    EXPECT_EQ(traits.suggestion.back(), '.') << traits.id;
  }
}

TEST(FindingKinds, HaveOneRowEachOnTheirPage) {
  std::istringstream page(read_repository_file("docs/command-line.md"));
  std::multiset<std::string> rows;
  bool is_table = false;
  for (std::string line; std::getline(page, line);) {
    if (line.rfind("| kind |", 0) == 0) is_table = true;
    if (line.empty()) is_table = false;
    if (is_table && line.rfind("| `", 0) == 0) rows.insert(line.substr(3, line.find('`', 3) - 3));
  }
  const std::set<std::string> ids = all_ids();
  EXPECT_EQ(rows, std::multiset<std::string>(ids.begin(), ids.end()));
}

TEST(Samples, HaveNoFindingsButTheirSingleChannels) {
  const std::map<std::string, std::string> expected = {{"double-pendulum", "single_channel_joint"},
                                                       {"giant-swing", ""},
                                                       {"pendulum", "single_channel_joint"},
                                                       {"robot-arm", "single_channel_joint"},
                                                       {"walk", ""}};
  for (const auto& [name, kinds] : expected) {
    const LintReport report = lint_clip(make_clip(read_bvh(read_repository_file("web/samples/" + name + ".bvh"), {}).value()));
    EXPECT_EQ(kinds_of(report), kinds) << name;
  }
}

TEST(RecordedFiles, HaveFewFindingsEach) {
  const std::vector<std::string> paths = recorded_bvh_files();
  if (paths.empty()) GTEST_SKIP() << "no recorded files at " << shared_dir();
  std::map<std::string, int> files_with;
  for (const std::string& path : paths) {
    Result<BvhClip> file = read_bvh(read_shared_file(path).value_or(""), {});
    if (!file) continue;
    const LintReport report = lint_clip(make_clip(std::move(*file)));
    std::set<std::string> kinds;
    for (const Finding& finding : report.findings) kinds.emplace(traits_of(finding.kind).id);
    for (const std::string& kind : kinds) ++files_with[kind];
    EXPECT_LE(report.findings.size(), 40U) << path;
  }
  for (const auto& [kind, count] : files_with) std::cout << kind << " in " << count << " of " << paths.size() << " files\n";
}

}  // namespace
}  // namespace marey
