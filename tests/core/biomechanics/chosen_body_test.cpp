#include "core/biomechanics/chosen_body.h"

#include <gmock/gmock.h>

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
  clip.body.own = {{1, 20.0}};
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

TEST(BodyEdits, AreUndoneAndRefuseWhatIsNoMass) {
  Clip clip = make_gymnast();
  BodyChoice heavy;
  heavy.mass_kg = 90.0;
  heavy.own = {{0, 5.0}};
  Edit edit = reduced_to_changes(clip, make_body_edit(clip, heavy));
  ASSERT_TRUE(check_edit(clip, edit));
  EXPECT_EQ(edit.name, "Change mass of the body");
  swap_edit(clip, edit);
  EXPECT_EQ(clip.body, heavy);
  EXPECT_EQ(edited_frames(clip, edit).count, 0);
  swap_edit(clip, edit);
  EXPECT_EQ(clip.body, BodyChoice{});
  EXPECT_TRUE(reduced_to_changes(clip, make_body_edit(clip, BodyChoice{})).empty());
  for (const BodyChoice& bad : {BodyChoice{{}, 0.0, {}}, BodyChoice{{}, 70.0, {{99, 1.0}}}, BodyChoice{{}, 70.0, {{0, -1.0}}}}) {
    EXPECT_FALSE(check_edit(clip, make_body_edit(clip, bad)));
  }
}

TEST(BodyEdits, LoseOwnMassesWithTheJointsThatHadThem) {
  Clip clip = make_gymnast();
  clip.body.mass_kg = 60.0;
  clip.body.own = {{2, 5.0}};
  const auto step = parse_recipe_step("delete-joint joints=" + std::string(clip.skeleton.name(1)));
  ASSERT_TRUE(step);
  const auto bound = bind_step(*step, clip);
  ASSERT_TRUE(bound);
  auto outcome = make_operation_edit(clip, *bound->operation, bound->target, bound->values);
  ASSERT_TRUE(outcome);
  ASSERT_TRUE(outcome->edit.body);
  EXPECT_TRUE(outcome->edit.body->own.empty());
  EXPECT_EQ(outcome->edit.body->mass_kg, 60.0);
  ASSERT_TRUE(check_edit(clip, outcome->edit));
}

}  // namespace
}  // namespace marey::test
