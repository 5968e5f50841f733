#include "core/biomechanics/body_guess.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <set>

#include "core/biomechanics/body_names.h"
#include "core/bvh/reader.h"
#include "core/document/document.h"
#include "tests/core/biomechanics/body_fixtures.h"
#include "tests/support/files.h"

namespace marey::test {
namespace {

// Self-tests of de Leva's table (shared theory, section 5.1).
TEST(BodyTables, AddUpToABody) {
  for (const auto& [table, expected] : {std::pair(BodyTable::DeLevaMale, 1.0), std::pair(BodyTable::DeLevaFemale, 0.9999)}) {
    const auto mass = [&, t = table](BodyPart part) { return proportions_of(t, part).mass; };
    double limbs = 0.0;
    for (const BodyPart part : {BodyPart::UpperArm, BodyPart::Forearm, BodyPart::Hand, BodyPart::Thigh, BodyPart::Shank, BodyPart::Foot}) {
      limbs += 2.0 * mass(part);
    }
    EXPECT_NEAR(mass(BodyPart::Head) + mass(BodyPart::Trunk) + limbs, expected, 1e-9);
    double pieces = 0.0;
    double moment = 0.0;
    for (const TrunkPiece& piece : trunk_pieces_of(table)) {
      pieces += piece.mass;
      moment += piece.mass * piece.com;
    }
    EXPECT_NEAR(pieces, mass(BodyPart::Trunk), 1e-9);
    EXPECT_NEAR(moment / pieces, proportions_of(table, BodyPart::Trunk).com, 0.012);
  }
}

Skeleton one_sided(const std::vector<std::string>& names) {
  std::vector<figures::JointPlan> plan;
  for (std::size_t i = 0; i < names.size(); ++i) {
    plan.push_back({names[i], static_cast<JointIndex>(i) - 1, glm::dvec3(0, -10, 0), figures::channels("ZXY"), {}});
  }
  plan.back().end_sites = {glm::dvec3(0, -5, 0)};
  return figures::make_skeleton(plan);
}

std::vector<std::string> parts_of(const std::vector<std::string>& names) {
  std::vector<std::string> parts;
  for (const auto& named : find_named_parts(one_sided(names))) {
    parts.push_back(named ? std::string(body_part_name(named->part)) : "-");
  }
  return parts;
}

// The names of shared theory, section 5.3.
TEST(BodyNames, OfTheFamilies) {
  using List = std::vector<std::string>;
  const List arm = {"trunk", "-", "upper arm", "forearm", "hand"};
  EXPECT_EQ(parts_of({"Hips", "LeftCollar", "LeftShoulder", "LeftElbow", "LeftWrist"}), arm);
  EXPECT_EQ(parts_of({"Chest", "LeftCollar", "LeftUpArm", "LeftLowArm", "LeftHand"}), arm);
  EXPECT_EQ(parts_of({"Spine1", "LeftShoulder", "LeftArm", "LeftForeArm", "LeftHand"}), arm);
  EXPECT_EQ(parts_of({"mixamorig:Spine2", "mixamorig:RightShoulder", "mixamorig:RightArm", "mixamorig:RightForeArm", "mixamorig:RightHand"}), arm);
  EXPECT_EQ(parts_of({"Trunk_comp", "x", "Left_Shoulder", "Left_Forearm", "Left_Hand"}), arm);
  EXPECT_EQ(parts_of({"abdomen", "lCollar", "lShldr", "lForeArm", "lHand"}), arm);
  const List leg = {"trunk", "thigh", "shank", "foot", "-"};
  EXPECT_EQ(parts_of({"Hips", "LeftHip", "LeftKnee", "LeftAnkle", "LeftToe"}), leg);
  EXPECT_EQ(parts_of({"Hips", "LeftUpLeg", "LeftLeg", "LeftFoot", "LeftToeBase"}), leg);
  EXPECT_EQ(parts_of({"Hips", "RightUpLeg", "RightLowLeg", "RightFoot", "RightToe"}), leg);
  EXPECT_EQ(parts_of({"Hip", "Left_Thigh", "Left_Shin", "Left_Foot", "x"}), leg);
  EXPECT_EQ(parts_of({"pelvis", "thigh_l", "calf_l", "foot_l", "ball_l"}), leg);
  EXPECT_EQ(parts_of({"Hips", "LHipJoint", "LeftUpLeg", "LeftLeg", "LeftFoot"}), (List{"trunk", "-", "thigh", "shank", "foot"}));
  EXPECT_EQ(parts_of({"base", "link1", "link2"}), (List{"-", "-", "-"}));
}

// The composite parts of fixture D (shared theory, section 7.3) come of the same table, but for the ends of hand and foot.
TEST(BodyGuess, OfTheGymnastIsNearTheWorkedModel) {
  const Clip gymnast = make_gymnast();
  const Result<GuessedBody> body = guess_body(gymnast.skeleton, BodyTable::DeLevaMale, 70.0, 0.055);
  ASSERT_TRUE(body);
  EXPECT_THAT(body->notes, testing::IsEmpty());
  std::map<JointIndex, double> mass;
  std::map<JointIndex, double> moment;
  for (const Segment& segment : body->model.segments) {
    mass[segment.joint] += segment.mass_kg;
    moment[segment.joint] += segment.mass_kg * segment.com_m.y;
  }
  for (const Segment& expected : make_gymnast_model().segments) {
    EXPECT_NEAR(mass[expected.joint], expected.mass_kg, 1e-9);
    EXPECT_NEAR(moment[expected.joint] / mass[expected.joint], expected.com_m.y, 0.04);
  }
}

TEST(BodyGuess, RodsGoWithAnyFigure) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    const Skeleton skeleton = figures::make_random_skeleton(9, seed);
    const Result<GuessedBody> body = guess_body(skeleton, BodyTable::Rods, 12.0, 0.01);
    if (!body) continue;
    EXPECT_NEAR(total_mass_kg(body->model), 12.0, 1e-9);
    EXPECT_TRUE(check_body_model(body->model, skeleton));
    const auto human = guess_body(skeleton, BodyTable::DeLevaMale, 70.0, 0.01);
    EXPECT_TRUE(human || human.error().message.starts_with("The joints do not tell"));
  }
}

// A figure whose names say nothing is a person once people say where its parts begin.
TEST(BodyGuess, TakesWhatPeopleSayOfJoints) {
  const auto channels = figures::channels("ZXY");
  const Skeleton skeleton = figures::make_skeleton({{"a", kNoParent, glm::dvec3(0.0), channels, {}},
                                                    {"b", 0, {0, 50, 0}, channels, {glm::dvec3(0, 40, 0)}},
                                                    {"c", 0, {10, 0, 0}, channels, {}},
                                                    {"d", 2, {0, -40, 0}, channels, {glm::dvec3(0, -40, 0)}},
                                                    {"e", 0, {-10, 0, 0}, channels, {}},
                                                    {"f", 4, {0, -40, 0}, channels, {glm::dvec3(0, -40, 0)}}});
  EXPECT_FALSE(guess_body(skeleton, BodyTable::DeLevaMale, 70.0, 0.01));
  const std::vector<OwnPart> own = {{0, BodyPart::Trunk},
                                    {1, BodyPart::Head},
                                    {2, BodyPart::Thigh, BodySide::Left},
                                    {3, BodyPart::Shank, BodySide::Left},
                                    {4, BodyPart::Thigh, BodySide::Right},
                                    {5, BodyPart::Shank, BodySide::Right}};
  const auto body = guess_body(skeleton, BodyTable::DeLevaMale, 70.0, 0.01, own);
  ASSERT_TRUE(body) << body.error().message;
  EXPECT_NEAR(total_mass_kg(body->model), 70.0, 1e-9);
  const auto mass_of = [&](const GuessedBody& found, std::string_view name) {
    double mass = 0.0;
    for (const GuessedPart& part : found.parts) mass += part.name == name ? part.mass_kg : 0.0;
    return mass;
  };
  EXPECT_NEAR(mass_of(*body, "left thigh") / mass_of(*body, "left shank"), 0.1416 / 0.0433, 1e-9);
  EXPECT_GT(mass_of(*body, "head"), 0.0);
  // Said to begin elsewhere, a part does not begin where the name told.
  const std::vector<std::optional<NamedPart>> named = find_named_parts(
      figures::make_skeleton({{"Hips", kNoParent, glm::dvec3(0.0), channels, {}},
                              {"LeftUpLeg", 0, {10, 0, 0}, channels, {}},
                              {"Stilt", 1, {0, -40, 0}, channels, {glm::dvec3(0, -40, 0)}}}),
      std::vector<OwnPart>{{2, BodyPart::Thigh, BodySide::Left}});
  EXPECT_FALSE(named[1]);
  ASSERT_TRUE(named[2]);
  EXPECT_EQ(named[2]->part, BodyPart::Thigh);
}

// Winter 2009, table 4.1: head, arms and trunk are .678 of the body, a leg .161, an arm .050.
TEST(BodyTables, OfWinterAddUp) {
  const auto mass = [](BodyPart part) { return proportions_of(BodyTable::Winter, part).mass; };
  const double leg = mass(BodyPart::Thigh) + mass(BodyPart::Shank) + mass(BodyPart::Foot);
  const double arm = mass(BodyPart::UpperArm) + mass(BodyPart::Forearm) + mass(BodyPart::Hand);
  EXPECT_NEAR(leg, 0.161, 1e-12);
  EXPECT_NEAR(arm, 0.050, 1e-12);
  EXPECT_NEAR(mass(BodyPart::Trunk) + mass(BodyPart::Head) + 2.0 * arm, 0.678, 1e-12);
  double trunk = 0.0;
  for (const TrunkPiece& piece : trunk_pieces_of(BodyTable::Winter)) trunk += piece.mass;
  EXPECT_NEAR(trunk, mass(BodyPart::Trunk), 1e-12);
  // Radii about the proximal ends, as the same table has them.
  const auto radius_at_end = [](BodyPart part) {
    const PartProportions& p = proportions_of(BodyTable::Winter, part);
    return std::hypot(p.radius_transverse, p.com);
  };
  EXPECT_NEAR(radius_at_end(BodyPart::Thigh), 0.540, 2e-3);
  EXPECT_NEAR(radius_at_end(BodyPart::Shank), 0.528, 2e-3);
  EXPECT_NEAR(radius_at_end(BodyPart::UpperArm), 0.542, 2e-3);
  EXPECT_NEAR(radius_at_end(BodyPart::Forearm), 0.526, 2e-3);
  EXPECT_NEAR(radius_at_end(BodyPart::Foot), 0.690, 2e-3);
}

// Real files: a mass where the names tell a body, both sides alike, and a centre between hips and head.
TEST(BodyGuess, OfRecordedFiles) {
  int files = 0;
  int humans = 0;
  for (const std::string& path : recorded_bvh_files()) {
    const auto text = read_shared_file(path);
    const auto read = text ? read_bvh(*text) : Result<BvhClip>(Error{});
    if (!read) continue;
    ++files;
    const Clip clip = make_clip(*read);
    const auto body = guess_body(clip.skeleton, BodyTable::DeLevaMale, 73.0, clip.settings.metres_per_unit);
    if (!body) continue;
    ++humans;
    SCOPED_TRACE(path);
    EXPECT_NEAR(total_mass_kg(body->model), 73.0, 1e-9);
    const Status sound = check_body_model(body->model, clip.skeleton);
    EXPECT_TRUE(sound) << (sound ? "" : sound.error().message);
    std::map<std::string, double> masses;
    for (const GuessedPart& part : body->parts) masses[part.name] += part.mass_kg;
    EXPECT_NEAR(masses["left thigh"], masses["right thigh"], 1e-9);
    EXPECT_NEAR(masses["left upper arm"], masses["right upper arm"], 1e-9);
  }
  if (files == 0) GTEST_SKIP() << "the recorded files are not here";
  std::cout << humans << " of " << files << " recorded files tell a human body\n";
  EXPECT_GT(humans, files / 2);
}

}  // namespace
}  // namespace marey::test
