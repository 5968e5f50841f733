#include "core/biomechanics/chosen_body.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/biomechanics/body_model_json.h"
#include "core/biomechanics/own_segments.h"
#include "core/document/document.h"
#include "core/editing/clip_operations.h"
#include "core/editing/recipe.h"
#include "tests/core/biomechanics/body_fixtures.h"

namespace marey::test {
namespace {

double mass_of(const ChosenBody& chosen, JointIndex joint) {
  double mass = 0.0;
  for (const Segment& segment : chosen.body.model.segments) mass += segment.joint == joint ? segment.mass_kg : 0.0;
  return mass;
}

TEST(ChosenBody, IsOfRodsWhereNoHumanIsTold) {
  EXPECT_EQ(find_chosen_body(make_gymnast())->table, BodyTable::DeLevaMale);
  Clip crane = make_gymnast();
  crane.skeleton = figures::make_skeleton({{"Base", kNoParent, glm::dvec3(0.0), figures::channels("ZXY"), {}},
                                           {"Boom", 0, glm::dvec3(0, 10, 0), figures::channels("Z"), {glm::dvec3(10, 0, 0)}}});
  const auto chosen = find_chosen_body(crane);
  ASSERT_TRUE(chosen);
  EXPECT_EQ(chosen->table, BodyTable::Rods);
  EXPECT_DOUBLE_EQ(chosen->mass_kg, 70.0);
  crane.body.table = BodyTable::DeLevaFemale;
  EXPECT_FALSE(find_chosen_body(crane));
}

TEST(ChosenBody, HasTheMassesThatWereTypedIn) {
  Clip clip = make_gymnast();
  clip.body.mass_kg = 50.0;
  const auto by_table = find_chosen_body(clip);
  clip.body.segments = {{1, 20.0, {}}};
  const auto own = find_chosen_body(clip);
  ASSERT_TRUE(by_table && own);
  EXPECT_DOUBLE_EQ(by_table->mass_kg, 50.0);
  EXPECT_DOUBLE_EQ(mass_of(*own, 1), 20.0);
  EXPECT_DOUBLE_EQ(mass_of(*own, 2), mass_of(*by_table, 2));
  EXPECT_DOUBLE_EQ(own->mass_kg, 50.0 - mass_of(*by_table, 1) + 20.0);
  for (std::size_t i = 0; i < own->body.model.segments.size(); ++i) {
    const Segment& segment = own->body.model.segments[i];
    const Segment& before = by_table->body.model.segments[i];
    if (segment.joint != 1 || !(before.mass_kg > 0.0)) continue;
    EXPECT_NEAR(segment.inertia_kgm2[0][0], before.inertia_kgm2[0][0] * segment.mass_kg / before.mass_kg, 1e-12);
  }
}

TEST(ChosenBody, TakesAWholeSegmentInPlaceOfTheTables) {
  Clip clip = make_gymnast();
  clip.body.mass_kg = 50.0;
  const auto by_table = find_chosen_body(clip);
  const OwnShape shape{{0.1, 0.2, 0.3}, {3.0, 2.0, 4.0, 0.1, -0.2, 0.3}};
  clip.body.segments = {{1, 20.0, shape}};
  const auto own = find_chosen_body(clip);
  ASSERT_TRUE(by_table && own);
  const auto segment = find_whole_segment(own->body.model, 1);
  ASSERT_TRUE(segment);
  EXPECT_EQ(make_own_segment(*segment), (OwnSegment{1, 20.0, shape}));
  EXPECT_DOUBLE_EQ(mass_of(*own, 2), mass_of(*by_table, 2));
  EXPECT_EQ(describe_source(*by_table), "deleva-male");
  EXPECT_EQ(describe_source(*own), "deleva-male and own values of 1 segment");
}

TEST(ChosenBody, GivesASegmentToAJointThatCarriesNone) {
  Clip clip = make_gymnast();
  clip.body.parts = {{0, std::nullopt, BodySide::Middle}};
  clip.body.table = BodyTable::Rods;
  clip.skeleton = figures::make_skeleton({{"Base", kNoParent, glm::dvec3(0.0), figures::channels("ZXY"), {}},
                                          {"Tool", 0, glm::dvec3(0, 10, 0), figures::channels("Z"), {glm::dvec3(0.0)}}});
  EXPECT_EQ(mass_of(*find_chosen_body(clip), 1), 0.0);
  clip.body.segments = {{1, 2.5, OwnShape{}}};
  const auto chosen = find_chosen_body(clip);
  ASSERT_TRUE(chosen);
  EXPECT_EQ(mass_of(*chosen, 1), 2.5);
  ASSERT_EQ(chosen->body.parts.size(), 2u);
  EXPECT_EQ(chosen->body.parts[1].joint, 1);
}

TEST(ChosenBody, CanBeOwnValuesAlone) {
  Clip clip = make_gymnast();
  clip.body.is_only_own = true;
  EXPECT_FALSE(find_chosen_body(clip)) << "no mass at all";
  clip.body.segments = {{2, 5.0, OwnShape{{0.0, 0.1, 0.0}, {}}}};
  clip.body.gravity_mps2 = glm::dvec3(0.0, -1.62, 0.0);
  const auto chosen = find_chosen_body(clip);
  ASSERT_TRUE(chosen);
  EXPECT_EQ(chosen->mass_kg, 5.0);
  EXPECT_FALSE(chosen->table);
  EXPECT_EQ(chosen->body.model.gravity_mps2, glm::dvec3(0.0, -1.62, 0.0));
  EXPECT_EQ(describe_source(*chosen), "own values of 1 segment");
}

TEST(OwnSegments, KeepTheirShapeWithAnotherMass) {
  Clip clip = make_gymnast();
  clip.body = with_segment_mass(clip, 1, 20.0);
  EXPECT_THAT(clip.body.segments, testing::ElementsAre(OwnSegment{1, 20.0, {}})) << "the table's shape";
  put_own_segment(clip.body, {0, 4.0, OwnShape{{0.0, 0.1, 0.0}, {1.0, 2.0, 3.0, 0.0, 0.0, 0.5}}});
  clip.body = with_segment_mass(clip, 0, 6.0);
  const OwnSegment heavier{0, 6.0, OwnShape{{0.0, 0.1, 0.0}, {1.5, 3.0, 4.5, 0.0, 0.0, 0.75}}};
  EXPECT_THAT(clip.body.segments, testing::ElementsAre(heavier, OwnSegment{1, 20.0, {}}));
  clip.body = with_segment_mass(clip, 0, 0.0);
  EXPECT_EQ(clip.body.segments[0].shape, (OwnShape{heavier.shape->com_m, {}})) << "nothing that could turn";
  clip.body = with_segment_mass(clip, 0, 6.0);
  EXPECT_EQ(clip.body.segments[0], (OwnSegment{0, 6.0, {}})) << "the table's shape again";
}

// A mass that was typed in where another table gives none.
TEST(OwnSegments, AreRodsWhereAMassAloneTellsNothing) {
  Clip clip = make_gymnast();
  clip.body.is_only_own = true;
  clip.body.segments = {{1, 3.0, {}}, {2, 4.0, OwnShape{}}};
  EXPECT_EQ(find_chosen_body(clip)->own_count, 1);
  clip.body = with_segment_mass(clip, 1, 5.0);
  EXPECT_TRUE(clip.body.segments[0].shape);
  EXPECT_EQ(find_chosen_body(clip)->mass_kg, 9.0);
  EXPECT_EQ(find_chosen_body(clip)->own_count, 2);
}

// A third of the mass times the square of the length about the end.
TEST(OwnSegments, AreRodsWhereAJointCarriedNothing) {
  Clip clip = make_gymnast();
  clip.body.is_only_own = true;
  clip.body = with_segment_mass(clip, 1, 3.0);
  const auto body = find_chosen_body(clip);
  ASSERT_TRUE(body);
  const Segment segment = *find_whole_segment(body->body.model, 1);
  const double length = 0.055 * 12.0;
  EXPECT_NEAR(glm::length(segment.com_m), 0.5 * length, 1e-12);
  const double about_end = segment.inertia_kgm2[0][0] + segment.mass_kg * glm::dot(segment.com_m, segment.com_m);
  EXPECT_NEAR(about_end, 3.0 * length * length / 3.0, 1e-12);
}

TEST(OwnSegments, ShareOutTheMassOfTheBody) {
  Clip clip = make_gymnast();
  clip.body.segments = {{1, 20.0, {}}};
  EXPECT_NEAR(find_chosen_body(clip.skeleton, with_body_mass(clip, 80.0), 0.055)->mass_kg, 80.0, 1e-9);
  clip.body = choose_model(clip.body, make_gymnast_model());
  const auto before = find_chosen_body(clip);
  clip.body = with_body_mass(clip, 140.0);
  const auto doubled = find_chosen_body(clip);
  ASSERT_TRUE(before && doubled);
  EXPECT_NEAR(doubled->mass_kg, 140.0, 1e-9);
  for (JointIndex joint = 0; joint < 3; ++joint) {
    const Segment a = *find_whole_segment(before->body.model, joint);
    const Segment b = *find_whole_segment(doubled->body.model, joint);
    EXPECT_NEAR(b.inertia_kgm2[0][0], 2.0 * a.inertia_kgm2[0][0], 1e-9);
    EXPECT_EQ(b.com_m, a.com_m);
  }
}

// A rod has no moment about itself, and rounding may leave less than nothing.
TEST(BodyModelCheck, HasRoomForRounding) {
  const Skeleton skeleton = make_gymnast().skeleton;
  BodyModel model;
  model.segments = {{0, 1.0, {}, symmetric_tensor(std::array{0.3, -1e-18, 0.3, 0.0, 0.0, 0.0})}};
  EXPECT_TRUE(check_body_model(model, skeleton));
  model.segments[0].inertia_kgm2[1][1] = -1e-6;
  EXPECT_FALSE(check_body_model(model, skeleton));
}

// Two segments on a joint move as one with their mass, centre and tensor.
TEST(WholeSegment, HasTheLoadsOfItsParts) {
  const Clip clip = make_gymnast();
  AnalysisRequest request;
  request.quantities = {"torque:*", "force:*", "kinetic_energy", "angular_momentum"};
  request.support = SupportKind::Pivot;
  request.model = make_random_model(clip.skeleton, 1);
  for (Segment segment : make_random_model(clip.skeleton, 2).segments) request.model->segments.push_back(segment);
  const AnalysisTable parts = table_of(clip, request);
  BodyModel whole;
  for (JointIndex joint = 0; joint < 3; ++joint) whole.segments.push_back(*find_whole_segment(*request.model, joint));
  EXPECT_FALSE(find_whole_segment(whole, 3));
  request.model = whole;
  const AnalysisTable wholes = table_of(clip, request);
  ASSERT_EQ(parts.columns.size(), wholes.columns.size());
  for (std::size_t i = 0; i < parts.columns.size(); ++i) {
    for (std::size_t f = 0; f < parts.columns[i].values.size(); ++f) {
      const double expected = parts.columns[i].values[f];
      if (!std::isfinite(expected)) continue;
      EXPECT_NEAR(wholes.columns[i].values[f], expected, 1e-9 * (1.0 + std::abs(expected))) << parts.columns[i].name;
    }
  }
}

TEST(BodyModelText, IsReadAsItWasWritten) {
  const Clip clip = make_gymnast();
  BodyModel model = make_random_model(clip.skeleton, 7);
  model.metres_per_unit = 0.055;
  model.gravity_mps2 = glm::dvec3(0.1, -1.62, 1.0 / 3.0);
  const auto text = write_body_model(model, clip.skeleton);
  ASSERT_TRUE(text);
  const auto read = read_body_model(nlohmann::json::parse(*text, nullptr, false), clip.skeleton);
  ASSERT_TRUE(read) << *text;
  EXPECT_EQ(read->metres_per_unit, model.metres_per_unit);
  EXPECT_EQ(read->gravity_mps2, model.gravity_mps2);
  ASSERT_EQ(read->segments.size(), model.segments.size());
  for (std::size_t i = 0; i < model.segments.size(); ++i) {
    EXPECT_EQ(make_own_segment(read->segments[i]), make_own_segment(model.segments[i])) << i;
  }
}

TEST(BodyModelText, IsRefusedWhereANameWouldMeanAnotherJoint) {
  const Skeleton skeleton = figures::make_skeleton({{"Arm", kNoParent, glm::dvec3(0.0), figures::channels("ZXY"), {}},
                                                    {"Arm", 0, glm::dvec3(0, 10, 0), figures::channels("Z"), {glm::dvec3(0.0)}}});
  BodyModel model;
  model.segments = {{0, 1.0, {}, {}}};
  EXPECT_TRUE(write_body_model(model, skeleton));
  model.segments = {{1, 1.0, {}, {}}};
  EXPECT_FALSE(write_body_model(model, skeleton));
}

TEST(BodyEdits, AreUndoneAndRefuseWhatIsNoMass) {
  Clip clip = make_gymnast();
  BodyChoice heavy;
  heavy.mass_kg = 90.0;
  heavy.segments = {{0, 5.0, {}}};
  Edit edit = reduced_to_changes(clip, make_body_edit(clip, heavy));
  ASSERT_TRUE(check_edit(clip, edit));
  EXPECT_EQ(edit.name, "Change mass of the body");
  swap_edit(clip, edit);
  EXPECT_EQ(clip.body, heavy);
  EXPECT_EQ(edited_frames(clip, edit).count, 0);
  swap_edit(clip, edit);
  EXPECT_EQ(clip.body, BodyChoice{});
  EXPECT_TRUE(reduced_to_changes(clip, make_body_edit(clip, BodyChoice{})).empty());
  for (const BodyChoice& bad : {BodyChoice{{}, 0.0, {}}, BodyChoice{{}, 70.0, {{99, 1.0, {}}}}, BodyChoice{{}, 70.0, {{0, -1.0, {}}}},
                                BodyChoice{{}, 70.0, {{1, 1.0, {}}, {0, 1.0, {}}}},
                                BodyChoice{{}, 70.0, {{0, 1.0, OwnShape{{}, {1.0, -1.0, 1.0, 0.0, 0.0, 0.0}}}}},
                                BodyChoice{{}, 70.0, {{0, 1.0, OwnShape{{}, {1.0, 1.0, 1.0, 0.0, 2.0, 0.0}}}}}}) {
    EXPECT_FALSE(check_edit(clip, make_body_edit(clip, bad)));
  }
}

// The model's numbers are those of the file, whichever way it is given.
TEST(BodyEdits, OpenAModel) {
  Clip clip = make_gymnast();
  clip.settings.metres_per_unit = 0.01;
  clip.body.table = BodyTable::DeLevaFemale;
  AnalysisRequest request;
  request.quantities = {"torque:*", "com", "reaction"};
  request.support = SupportKind::Pivot;
  request.model = make_gymnast_model();
  request.model->gravity_mps2 = glm::dvec3(0.0, -3.7, 0.0);
  const AnalysisTable expected = table_of(clip, request);
  Edit edit = make_model_edit(clip, *request.model);
  ASSERT_TRUE(check_edit(clip, edit));
  const Clip before = clip;
  swap_edit(clip, edit);
  EXPECT_EQ(clip.settings.metres_per_unit, 0.055);
  request.model = find_chosen_body(clip)->body.model;
  const AnalysisTable found = table_of(clip, request);
  ASSERT_EQ(found.columns.size(), expected.columns.size());
  for (std::size_t i = 0; i < found.columns.size(); ++i) EXPECT_THAT(found.columns[i].values, testing::Pointwise(testing::NanSensitiveDoubleEq(), expected.columns[i].values));
  swap_edit(clip, edit);
  EXPECT_EQ(clip.body, before.body);
  EXPECT_EQ(clip.settings, before.settings);
}

TEST(BodyEdits, KeepOwnSegmentsOfTheJointsThatStay) {
  Clip clip = make_gymnast();
  const OwnSegment legs{2, 5.0, OwnShape{{0.0, 0.1, 0.0}, {}}};
  clip.body.mass_kg = 60.0;
  clip.body.segments = {{1, 6.0, {}}, legs};
  clip.body.parts = {{2, BodyPart::Thigh, BodySide::Middle}};
  const auto step = parse_recipe_step("delete-joint joints=" + std::string(clip.skeleton.name(1)));
  const auto bound = bind_step(*step, clip);
  ASSERT_TRUE(bound);
  auto outcome = make_operation_edit(clip, *bound->operation, bound->target, bound->values);
  ASSERT_TRUE(outcome && outcome->edit.figure);
  ASSERT_TRUE(outcome->edit.body);
  ASSERT_EQ(outcome->edit.figure->skeleton.joint_count(), 2);
  EXPECT_EQ(outcome->edit.body->mass_kg, 60.0);
  EXPECT_THAT(outcome->edit.body->segments, testing::ElementsAre(OwnSegment{1, legs.mass_kg, legs.shape}));
  EXPECT_THAT(outcome->edit.body->parts, testing::ElementsAre(OwnPart{1, BodyPart::Thigh, BodySide::Middle}));
  EXPECT_THAT(outcome->notes, testing::Contains("1 segment of your own went with the joints."));
  ASSERT_TRUE(check_edit(clip, outcome->edit));
}

}  // namespace
}  // namespace marey::test
