#include "core/interchange/export.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <set>
#include <vector>

#include "core/bvh/reader.h"
#include "core/lint/lint.h"
#include "core/motion/resampling.h"
#include "tests/core/interchange/export_checks.h"
#include "tests/core/kinematics/figures.h"
#include "tests/support/files.h"

namespace marey {
namespace {

using namespace test;
using Kind = ExportChangeKind;

Clip random_clip(unsigned seed) {
  Skeleton skeleton = figures::make_random_skeleton(1 + static_cast<int>(seed % 23), seed);
  Motion motion = figures::make_random_motion(skeleton, 7, 200.0, seed + 1);
  Clip clip{std::move(skeleton), std::move(motion), {}};
  clip.settings.position_rule = seed % 2 == 0 ? PositionRule::Replace : PositionRule::Add;
  return clip;
}

/// True if positions for the root only cannot give the movement.
bool has_more_than_one_way(const Skeleton& skeleton) {
  int roots = 0;
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    const bool is_root = skeleton.parent(joint) == kNoParent;
    roots += is_root ? 1 : 0;
    if (is_root && roots < 2) continue;
    for (const Channel& channel : skeleton.channels(joint)) {
      if (is_position(channel.kind)) return true;
    }
  }
  return roots > 1;
}

void expect_good(const Clip& clip, const TargetTraits& target, double extent, const std::string& what) {
  const Result<ExportedClip> exported = export_for_target(clip, target.target);
  ASSERT_TRUE(exported) << what;
  for (const TargetNeed& need : target.needs) {
    EXPECT_EQ(fault_of(*exported, need.requirement), "") << what << " " << traits_of(need.requirement).id;
  }
  const double distance = largest_distance(clip, *exported);
  EXPECT_NEAR(exported->largest_move, distance, 1e-9 * extent) << what;
  const bool may_move = target.asks_for(Requirement::PositionsOfRootOnly) && has_more_than_one_way(clip.skeleton);
  EXPECT_TRUE(may_move || distance <= 1e-9 * extent) << what << ": " << distance << "\n" << listing(*exported);
  const bool is_told = find_change(*exported, Kind::JointsMoved) != nullptr;
  EXPECT_TRUE(is_told || distance <= 1e-8 * extent) << what;
  const Result<BvhClip> again = read_bvh(write_exported(*exported));
  ASSERT_TRUE(again) << what;
  EXPECT_EQ(again->skeleton, exported->skeleton) << what;
  for (const Diagnostic& finding : again->diagnostics.list()) {
    const bool is_clean = finding.severity == Severity::Note || finding.code == DiagnosticCode::PositionsAmbiguous;
    EXPECT_TRUE(is_clean) << what << ": " << finding.message;
  }
}

TEST(Export, RandomClipsMeetWhatTheTargetAsksForAndMoveTheSame) {
  constexpr double kExtent = 1000.0;  // positions of up to 200 units down a chain
  for (unsigned seed = 0; seed < 120; ++seed) {
    const Clip clip = random_clip(seed);
    for (const TargetTraits& target : export_targets()) {
      expect_good(clip, target, kExtent, "seed " + std::to_string(seed) + " for " + std::string(target.id));
    }
  }
}

TEST(Export, RecordedFilesMeetWhatTheTargetAsksForAndMoveTheSame) {
  const std::vector<std::string> paths = recorded_bvh_files();
  if (paths.empty()) GTEST_SKIP() << "no recorded files at " << shared_dir();
  constexpr int kMostFrames = 40;
  int files = 0;
  int nodes = 0;
  for (const std::string& path : paths) {
    Result<BvhClip> read = read_bvh(read_shared_file(path).value_or(""));
    if (!read) continue;
    Clip clip{std::move(read->skeleton), trimmed(read->motion, {0, kMostFrames}), {}};
    clip.settings.position_rule = read->position_rule;
    ++files;
    nodes += clip.skeleton.node_count();
    double extent = compute_stature(clip.skeleton);
    for (const double sample : clip.motion.samples()) extent = std::max(extent, std::abs(sample));
    for (const TargetTraits& target : export_targets()) expect_good(clip, target, extent, path + " for " + std::string(target.id));
  }
  std::cout << files << " files with " << nodes << " nodes exported for " << export_targets().size() << " targets\n";
  EXPECT_GE(files, 40);
}

TEST(Export, StrictFilesAreReadStrictly) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const Result<ExportedClip> exported = export_for_target(random_clip(seed), ExportTarget::Strict);
    ASSERT_TRUE(exported);
    const std::string text = write_exported(*exported);
    EXPECT_TRUE(read_bvh(text, {.strict = true, .limits = {}})) << text.substr(0, 2000);
    const std::size_t rows = text.find("Frame Time:");
    EXPECT_EQ(text.find_first_of("eE", text.find('\n', rows)), std::string::npos) << "an exponent";
  }
}

TEST(Export, TheLinterFindsNothingAboutTheTreeOfAStrictFile) {
  int before = 0;
  const auto count = [](const Clip& clip, std::string* found) {
    int findings = 0;
    for (const Finding& finding : lint_clip(clip).findings) {
      if (finding.kind > FindingKind::UnusualChannelOrder || finding.kind == FindingKind::ZeroLengthBone) continue;
      ++findings;
      if (found != nullptr) *found += finding.message + "\n";
    }
    return findings;
  };
  for (unsigned seed = 0; seed < 40; ++seed) {
    const Clip clip = random_clip(seed);
    before += count(clip, nullptr);
    const ExportedClip exported = *export_for_target(clip, ExportTarget::Strict);
    std::string found;
    EXPECT_EQ(count({exported.skeleton, exported.motion, {}}, &found), 0) << seed << ": " << found;
  }
  EXPECT_GT(before, 40);
}

TEST(Export, WhatIsStrictAlreadyStaysAsItIs) {
  const Skeleton skeleton = figures::make_gymnast();
  const Motion motion = figures::make_giant_swing();
  for (const ExportTarget target : {ExportTarget::Strict, ExportTarget::Blender, ExportTarget::Pybvh, ExportTarget::BvhView,
                                    ExportTarget::Three}) {
    const Result<ExportedClip> exported = export_for_target({skeleton, motion, {}}, target);
    ASSERT_TRUE(exported);
    EXPECT_EQ(exported->skeleton, skeleton);
    EXPECT_TRUE(std::equal(motion.samples().begin(), motion.samples().end(), exported->motion.samples().begin()));
    EXPECT_TRUE(exported->changes.empty()) << listing(*exported);
  }
}

TEST(Export, AReferencePoseIsAddedOnceAndOnWish) {
  const Clip clip{figures::make_gymnast(), figures::make_giant_swing(), {}};
  const ExportedClip with = *export_for_target(clip, ExportTarget::Blender, {.reference_pose = true});
  EXPECT_EQ(with.motion.frame_count(), clip.motion.frame_count() + 1);
  EXPECT_EQ(with.added_frames, 1);
  EXPECT_EQ(fault_of(with, Requirement::ReferencePose), "");
  const ExportedClip again =
      *export_for_target({with.skeleton, with.motion, {}}, ExportTarget::Blender, {.reference_pose = true});
  EXPECT_EQ(again.added_frames, 0);
  const ExportedClip without = *export_for_target(clip, ExportTarget::MotionBuilder, {.reference_pose = false});
  EXPECT_EQ(without.motion.frame_count(), clip.motion.frame_count());
}

TEST(Export, AClipWithoutFramesGetsItsRestPose) {
  const Skeleton skeleton = figures::make_skeleton(
      {{"Hips", kNoParent, {1.0, 2.0, 3.0}, figures::channels("xyzZXY"), {}}, {"Spine", 0, {0.0, 4.0, 0.0}, figures::channels("xX"), {}}});
  const ExportedClip exported = *export_for_target({skeleton, Motion(8, 0, 0.1), {}}, ExportTarget::Three);
  EXPECT_EQ(exported.motion.frame_count(), 1);
  const auto points = figures::positions_of(exported.skeleton, exported.motion, exported.position_rule);
  EXPECT_EQ(points[0][0], glm::dvec3(1.0, 2.0, 3.0));
  EXPECT_EQ(points[0][1], glm::dvec3(1.0, 6.0, 3.0));
}

TEST(Export, TooLongAClipIsRefused) {
  const Clip clip{figures::make_gymnast(), Motion(0, 2'000'000'000, 0.01), {}};
  const Result<ExportedClip> exported = export_for_target(clip, ExportTarget::Strict);
  ASSERT_FALSE(exported);
  EXPECT_EQ(exported.error().code, DiagnosticCode::InvalidArgument);
}

TEST(Export, ChangesHaveIdsOfTheirOwn) {
  std::set<std::string_view> ids;
  for (int kind = 0; kind < kExportChangeKindCount; ++kind) ids.insert(export_change_id(static_cast<Kind>(kind)));
  EXPECT_EQ(static_cast<int>(ids.size()), kExportChangeKindCount);
}

}  // namespace
}  // namespace marey
