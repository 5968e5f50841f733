// Known answers for the single steps of an export.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/interchange/ascii_name.h"
#include "tests/core/interchange/export_checks.h"
#include "tests/core/kinematics/figures.h"

namespace marey {
namespace {

using namespace test;
using figures::channels;
using testing::ElementsAre;
using testing::HasSubstr;
using Kind = ExportChangeKind;

std::vector<std::string> names_of(const ExportedClip& clip) {
  std::vector<std::string> names;
  for (JointIndex joint = 0; joint < clip.skeleton.joint_count(); ++joint) names.push_back(clip.skeleton.name(joint));
  return names;
}

std::vector<double> curve_of(const ExportedClip& clip, ChannelIndex channel) {
  const auto samples = clip.motion.channel_samples(channel);
  return {samples.begin(), samples.end()};
}

ExportedClip exported(const Skeleton& skeleton, const std::vector<std::vector<double>>& rows, ExportTarget target) {
  return *export_for_target({skeleton, figures::make_motion(rows, 0.1), {}}, target);
}

TEST(Rewriting, BonesKeepTheMedianOfTheirPositions) {
  const Skeleton skeleton = figures::make_skeleton({{"Hips", kNoParent, {}, channels("xyzZXY"), {}},
                                                    {"Still", 0, {9.0, 9.0, 9.0}, channels("xyzZXY"), {}},
                                                    {"Loose", 0, {9.0, 9.0, 9.0}, channels("yZXY"), {{0.0, 1.0, 0.0}}}});
  const std::vector<double> hips(6, 0.0);
  std::vector<std::vector<double>> rows;
  for (const double loose : {9.0, 4.0, 4.5}) {
    rows.push_back({0, 0, 0, 0, 0, 0, 1, 2, 3, 0, 0, 0, loose, 0, 0, 0});
  }
  const ExportedClip clip = exported(skeleton, rows, ExportTarget::Strict);
  EXPECT_EQ(clip.skeleton.offset(1), glm::dvec3(1.0, 2.0, 3.0));
  EXPECT_EQ(clip.skeleton.offset(2), glm::dvec3(9.0, 4.5, 9.0));
  EXPECT_DOUBLE_EQ(clip.largest_move, 4.5);
  EXPECT_THAT(find_change(clip, Kind::JointsMoved)->message, HasSubstr("4.5 units"));
  EXPECT_THAT(listing(clip), HasSubstr("1 joint loses position channels that never change"));
  EXPECT_THAT(listing(clip), HasSubstr("1 joint loses its position channels; bones that changed by up to 4.5 units keep one length: 'Loose'."));
}

TEST(Rewriting, WholeTurnsStayWhereZerosArePutBetween) {
  const Skeleton skeleton = figures::make_skeleton({{"Hips", kNoParent, {}, channels("xyzZXY"), {}},
                                                    {"Knee", 0, {0.0, -4.0, 0.0}, channels("X"), {{0.0, -4.0, 0.0}}}});
  const ExportedClip clip = exported(skeleton, {{0, 0, 0, 1, 2, 3, 355}, {0, 0, 0, 1, 2, 3, 725}}, ExportTarget::Blender);
  EXPECT_EQ(euler_order_label(clip.skeleton, 1), "ZXY");
  EXPECT_THAT(curve_of(clip, 7), ElementsAre(355.0, 725.0));
  EXPECT_THAT(curve_of(clip, 6), ElementsAre(0.0, 0.0));
  EXPECT_EQ(find_change(clip, Kind::RotationsAdded)->count, 1);
}

TEST(Rewriting, SolvedAnglesGoOnWithoutLeaps) {
  const Skeleton skeleton = figures::make_skeleton({{"Hips", kNoParent, {}, channels("xyzYXZ"), {{0.0, 1.0, 0.0}}}});
  std::vector<std::vector<double>> rows;
  for (int frame = 0; frame < 200; ++frame) rows.push_back({0, 0, 0, 360.0 + 5.0 * frame, 20.0, 10.0});
  const ExportedClip clip = exported(skeleton, rows, ExportTarget::Strict);
  EXPECT_EQ(euler_order_label(clip.skeleton, 0), "ZXY");
  for (ChannelIndex channel = 3; channel < 6; ++channel) {
    const std::vector<double> curve = curve_of(clip, channel);
    for (std::size_t i = 1; i < curve.size(); ++i) EXPECT_LT(std::abs(curve[i] - curve[i - 1]), 30.0) << channel << " " << i;
  }
  EXPECT_GT(curve_of(clip, 5).front(), 300.0) << "the turn before the first frame is lost";
}

TEST(Rewriting, SeveralRootsFollowTheFirst) {
  const Skeleton skeleton = figures::make_skeleton({{"A", kNoParent, {}, channels("xyzZXY"), {{0.0, 1.0, 0.0}}},
                                                    {"B", kNoParent, {5.0, 0.0, 0.0}, channels("ZXY"), {{0.0, 1.0, 0.0}}}});
  const std::vector<std::vector<double>> rows = {{1, 2, 3, 0, 0, 0, 0, 0, 0}, {2, 3, 4, 0, 0, 0, 0, 0, 0}};
  const ExportedClip strict = exported(skeleton, rows, ExportTarget::Strict);
  EXPECT_THAT(names_of(strict), ElementsAre("Root", "A", "B"));
  EXPECT_THAT(curve_of(strict, 0), ElementsAre(1.0, 2.0));
  EXPECT_EQ(strict.skeleton.offset(1), glm::dvec3(0.0));
  EXPECT_NEAR(strict.largest_move, std::sqrt(3.0), 1e-12) << "B stands still in the clip";
  const ExportedClip three = exported(skeleton, rows, ExportTarget::Three);
  EXPECT_LE(three.largest_move, 1e-12);
  EXPECT_THAT(names_of(exported(skeleton, rows, ExportTarget::Blender)), ElementsAre("A", "B"));
}

TEST(Rewriting, PositionsBecomeWhatThreeAdds) {
  const Skeleton skeleton = figures::make_skeleton({{"Hips", kNoParent, {0.0, 90.0, 0.0}, channels("xyzZXY"), {}},
                                                    {"Spine", 0, {0.0, 9.0, 0.0}, channels("xyzZXY"), {{0.0, 1.0, 0.0}}}});
  const ExportedClip clip = exported(skeleton, {{1, 92, 3, 0, 0, 0, 0, 10, 0, 0, 0, 0}}, ExportTarget::Three);
  EXPECT_EQ(clip.position_rule, PositionRule::Add);
  EXPECT_EQ(clip.skeleton.offset(0), glm::dvec3(0.0));
  EXPECT_THAT(curve_of(clip, 1), ElementsAre(92.0));
  EXPECT_EQ(clip.skeleton.offset(1), glm::dvec3(0.0, 9.0, 0.0));
  EXPECT_THAT(curve_of(clip, 7), ElementsAre(1.0));
}

TEST(Rewriting, ARootWithAnOffsetAlonePutsItIntoPositions) {
  const Skeleton skeleton = figures::make_skeleton({{"Hips", kNoParent, {0.0, 90.0, 0.0}, channels("ZXY"), {{0.0, 1.0, 0.0}}}});
  const ExportedClip clip = exported(skeleton, {{1, 2, 3}, {4, 5, 6}}, ExportTarget::SecondLife);
  EXPECT_EQ(clip.skeleton.offset(0), glm::dvec3(0.0));
  EXPECT_THAT(curve_of(clip, 1), ElementsAre(90.0, 90.0, 90.0));
  EXPECT_THAT(curve_of(clip, 3), ElementsAre(0.0, 1.0, 4.0));
}

TEST(Rewriting, SecondLifeIsToldOfLongClips) {
  const Skeleton skeleton = figures::make_gymnast();
  const Clip clip{skeleton, Motion(skeleton.channel_count(), 62, 1.0), {}};
  EXPECT_NE(find_change(*export_for_target(clip, ExportTarget::SecondLife), Kind::TooLong), nullptr);
  EXPECT_EQ(find_change(*export_for_target(clip, ExportTarget::Pybvh), Kind::TooLong), nullptr);
}

TEST(Rewriting, NamesBecomePlainAndStayApart) {
  const Skeleton skeleton = figures::make_skeleton({{"Bip01 Pelvis", kNoParent, {}, channels("xyzZXY"), {}},
                                                    {"Плечо", 0, {0.0, 1.0, 0.0}, channels("ZXY"), {}},
                                                    {"plecho.L", 1, {0.0, 1.0, 0.0}, channels("ZXY"), {}},
                                                    {"左腕_L", 2, {0.0, 1.0, 0.0}, channels("ZXY"), {}},
                                                    {"", 3, {0.0, 1.0, 0.0}, channels("ZXY"), {}},
                                                    {"Mão", 4, {0.0, 1.0, 0.0}, channels("ZXY"), {}},
                                                    {"Mao", 5, {0.0, 1.0, 0.0}, channels("ZXY"), {{0.0, 1.0, 0.0}}}});
  const Clip clip{skeleton, Motion(skeleton.channel_count(), 1, 0.1), {}};
  const ExportedClip words = *export_for_target(clip, ExportTarget::Strict);
  EXPECT_THAT(names_of(words), ElementsAre("Bip01_Pelvis", "Plecho", "plecho_L", "Joint4_L", "Joint5", "Mao", "Mao_2"));
  EXPECT_EQ(words.names.size(), 7U);
  EXPECT_EQ(words.names[1].before, "Плечо");
  EXPECT_EQ(names_of(*export_for_target(clip, ExportTarget::Blender))[2], "plecho.L");
}

TEST(Rewriting, LongNamesStayApartWithin63Bytes) {
  const std::string name(80, 'a');
  const Skeleton skeleton = figures::make_skeleton(
      {{name, kNoParent, {}, channels("xyzZXY"), {}}, {name + "b", 0, {0.0, 1.0, 0.0}, channels("ZXY"), {{0.0, 1.0, 0.0}}}});
  const Clip clip{skeleton, Motion(skeleton.channel_count(), 1, 0.1), {}};
  EXPECT_THAT(names_of(*export_for_target(clip, ExportTarget::Blender)), ElementsAre(std::string(63, 'a'), std::string(61, 'a') + "_2"));
}

TEST(Rewriting, BytesThatAreNoTextAreLeftOut) {
  bool is_complete = true;
  EXPECT_EQ(ascii_name("a\x8f\xe5z", NameLetters::Words, is_complete), "az");
  EXPECT_FALSE(is_complete);
  EXPECT_EQ(ascii_name("mixamorig:Hips-1.x", NameLetters::Words, is_complete), "mixamorig_Hips_1_x");
  EXPECT_EQ(ascii_name("mixamorig:Hips-1.x", NameLetters::Ascii, is_complete), "mixamorig:Hips-1.x");
  EXPECT_TRUE(is_complete);
}

TEST(Rewriting, LimbsEndInOneEndSite) {
  const Skeleton skeleton =
      figures::make_skeleton({{"Hips", kNoParent, {}, channels("xyzZXY"), {{1.0, 0.0, 0.0}}},
                              {"Arm", 0, {0.0, 8.0, 0.0}, channels("ZXY"), {}},
                              {"Leg", 0, {0.0, -8.0, 0.0}, channels("ZXY"), {{0.0, -1.0, 0.0}, {0.0, -2.0, 0.0}}}});
  const Clip clip{skeleton, Motion(skeleton.channel_count(), 1, 0.1), {}};
  const ExportedClip strict = *export_for_target(clip, ExportTarget::Strict);
  EXPECT_EQ(strict.skeleton.node_count(), 5);
  EXPECT_EQ(strict.skeleton.node(2).offset, glm::dvec3(0.0, 2.0, 0.0));
  EXPECT_THAT(strict.nodes, ElementsAre(0, kNoParent, 1, 3, 4, kNoParent));
  EXPECT_EQ(find_change(strict, Kind::EndSitesDropped)->count, 2);
  EXPECT_TRUE(find_change(strict, Kind::EndSitesDropped)->is_loss);
}

}  // namespace
}  // namespace marey
