#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "core/biomechanics/chosen_body.h"
#include "core/biomechanics/own_segments.h"
#include "core/document/document.h"
#include "core/editing/figure_draft.h"
#include "core/motion/sampling.h"
#include "core/skeleton/skeleton_builder.h"
#include "tests/core/biomechanics/body_fixtures.h"
#include "tests/core/editing/operation_clips.h"

namespace marey::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

OperationTarget joint_target(const Clip& clip, std::vector<JointIndex> joints) {
  OperationTarget target = whole_clip(clip);
  target.joints = std::move(joints);
  return target;
}

// With words for the parameters that are texts.
Result<OperationOutcome> with_texts(const Clip& clip, std::string_view id, const OperationTarget& target,
                                    const std::vector<std::string>& texts) {
  const Operation& operation = *find_operation(id);
  OperationValues values = initial_values(operation);
  for (std::size_t i = 0; i < texts.size(); ++i) values.texts[i] = texts[i];
  return make_operation_edit(clip, operation, target, values);
}

// A chain of joints with three rotations each, moving.
Clip make_chain(Random& random, int frame_count) {
  Clip clip = make_clip(4, frame_count);
  for (ChannelIndex channel = 0; channel < clip.motion.channel_count(); ++channel) {
    double value = random.between(-80, 80);
    for (double& sample : clip.motion.channel_samples(channel)) sample = value += random.between(-5, 5);
  }
  return clip;
}

constexpr std::string_view kOrders[] = {"zxy", "zyx", "xyz", "xzy", "yxz", "yzx"};

TEST(ChangeOrder, KeepsAllPointsInAnyOrder) {
  Random random(61);
  for (const Clip& clip : {make_figure(40), make_wild_figure(random, 40)}) {
    for (const std::string_view order : kOrders) {
      const Clip changed = after(clip, "change-order", {{"order", choice_of("change-order", "order", order)}});
      EXPECT_LT(largest_difference(positions_of(changed), positions_of(clip)), 1e-9) << order;
      std::string upper(order);
      for (char& c : upper) c = static_cast<char>(c - 'a' + 'A');
      EXPECT_EQ(euler_order_label(changed.skeleton, 1), upper);
      EXPECT_EQ(euler_order_label(changed.skeleton, 2), "X");
      EXPECT_EQ(channel_label(changed.skeleton, 0), "Hips Xposition");
    }
  }
}

TEST(ChangeOrder, ThereAndBackIsTheStart) {
  Clip clip = make_figure(60);
  // A leap by a whole turn is no less part of the file.
  for (int frame = 30; frame < 60; ++frame) clip.motion.channel_samples(7)[idx(frame)] -= 360.0;
  for (const std::string_view order : kOrders) {
    const OperationTarget spine = joint_target(clip, {1});
    const Clip there = after(clip, "change-order", spine, {{"order", choice_of("change-order", "order", order)}});
    const Clip back = after(there, "change-order", spine, {{"order", choice_of("change-order", "order", "zxy")}});
    EXPECT_EQ(back.skeleton, clip.skeleton);
    for (ChannelIndex channel = 6; channel < 9; ++channel) {
      EXPECT_THAT(samples_of(back, channel), testing::Pointwise(testing::DoubleNear(1e-9), samples_of(clip, channel)));
    }
  }
  EXPECT_TRUE(outcome_of(clip, "change-order", joint_target(clip, {1})).edit.empty());
}

TEST(ChangeOrder, KeepsTheCountOfTurns) {
  Clip clip = make_clip(1, 100);
  for (int frame = 0; frame < 100; ++frame) clip.motion.channel_samples(4)[idx(frame)] = 10.0 * frame;
  const Clip changed = after(clip, "change-order", {{"order", choice_of("change-order", "order", "xyz")}});
  EXPECT_NEAR(changed.motion.sample(3, 99), 990.0, 1e-9);
}

template <class Turn>
void expect_same_loads(const Clip& before, const Clip& now, Turn turn) {
  AnalysisRequest request;
  request.quantities = {"torque:*", "force:*"};
  request.support = SupportKind::Pivot;
  request.model = find_chosen_body(before)->body.model;
  const AnalysisTable expected = table_of(before, request);
  request.model = find_chosen_body(now)->body.model;
  const AnalysisTable found = table_of(now, request);
  ASSERT_EQ(found.columns.size(), expected.columns.size());
  for (std::size_t i = 0; i < found.columns.size(); i += 3) {
    for (std::size_t frame = 2; frame + 2 < expected.columns[i].values.size(); ++frame) {
      const auto at = [&](const AnalysisTable& table) {
        return glm::dvec3(table.columns[i].values[frame], table.columns[i + 1].values[frame], table.columns[i + 2].values[frame]);
      };
      const glm::dvec3 wanted = turn(at(expected));
      EXPECT_LT(glm::distance(at(found), wanted), 1e-7 * (1.0 + glm::length(wanted))) << found.columns[i].name << " frame " << frame;
    }
  }
}

TEST(UpAxis, TurnsEverythingByAQuarter) {
  Random random(62);
  Clip clip = make_wild_figure(random, 20);
  clip.settings.up_axis = Axis::Y;
  const Clip turned = after(clip, "up-axis", {{"to", 2.0}});
  EXPECT_EQ(turned.settings.up_axis, Axis::Z);
  std::vector<double> expected = positions_of(clip);
  for (std::size_t i = 0; i < expected.size(); i += 3) {
    const double y = expected[i + 1];
    expected[i + 1] = -expected[i + 2];
    expected[i + 2] = y;
  }
  EXPECT_LT(largest_difference(positions_of(turned), expected), 1e-9);
  const Clip back = after(turned, "up-axis", {{"to", 1.0}});
  EXPECT_EQ(bits_of(back), bits_of(clip));
}

TEST(RestPose, IsThePoseOfTheFrameAndMovesNothing) {
  Random random(63);
  const Clip clip = make_chain(random, 30);
  const Clip changed = after(clip, "rest-pose", {{"frame", 7.0}});
  EXPECT_LT(largest_difference(positions_of(changed), positions_of(clip)), 1e-9);
  for (ChannelIndex channel = 3; channel < clip.motion.channel_count(); ++channel) {
    EXPECT_NEAR(changed.motion.sample(channel, 7), 0.0, 1e-9);
  }
}

// Own segments go with the bones: what they weigh on the joints stays, in the world's axes.
TEST(RestPose, TurnsOwnSegments) {
  Random random(64);
  Clip clip = make_chain(random, 30);
  clip.body = choose_model({}, make_random_model(clip.skeleton, 5));
  const Clip changed = after(clip, "rest-pose", {{"frame", 7.0}});
  ASSERT_FALSE(changed.body == clip.body);
  expect_same_loads(clip, changed, [](glm::dvec3 v) { return v; });
}

TEST(UpAxis, TurnsOwnSegments) {
  Random random(65);
  Clip clip = make_chain(random, 20);
  clip.settings.up_axis = Axis::Y;
  clip.body = choose_model({}, make_random_model(clip.skeleton, 6));
  clip.body.gravity_mps2 = glm::dvec3(1.0, -9.0, 2.0);
  const Clip turned = after(clip, "up-axis", {{"to", 2.0}});
  expect_same_loads(clip, turned, [](glm::dvec3 v) { return glm::dvec3(v.x, -v.z, v.y); });
  EXPECT_EQ(after(turned, "up-axis", {{"to", 1.0}}).body, clip.body);
}

TEST(ScaleFigure, ScalesOwnSegments) {
  Random random(66);
  Clip clip = make_chain(random, 5);
  clip.body = choose_model({}, make_random_model(clip.skeleton, 8));
  const Segment before = find_chosen_body(clip)->body.model.segments[1];
  const Segment bigger = find_chosen_body(after(clip, "scale-figure", {{"factor", 2.0}}))->body.model.segments[1];
  EXPECT_EQ(bigger.com_m, 2.0 * before.com_m);
  EXPECT_EQ(bigger.inertia_kgm2, 4.0 * before.inertia_kgm2);
  EXPECT_EQ(bigger.mass_kg, before.mass_kg);
  EXPECT_EQ(after(clip, "scale-figure", {{"factor", 2.0}, {"unit", 1.0}}).body, clip.body) << "as large as before, in other units";
}

TEST(RestPose, IsRefusedWhereAHingeWouldHaveToTurn) {
  const Clip clip = make_figure(10);
  const auto refused = with_texts(clip, "rest-pose", whole_clip(clip), {});
  ASSERT_FALSE(refused);
  EXPECT_TRUE(refused.error().message.starts_with("'Head' has not the three rotation channels"));
}

TEST(Rename, KnowsAStar) {
  const Clip clip = make_figure(3);
  const auto outcome = with_texts(clip, "rename", whole_clip(clip), {"left*", "L_*"});
  ASSERT_TRUE(outcome);
  const Clip changed = edited(clip, outcome->edit);
  EXPECT_EQ(changed.skeleton.name(3), "L_Arm");
  EXPECT_EQ(changed.skeleton.name(5), "RightArm");
  EXPECT_FALSE(with_texts(clip, "rename", whole_clip(clip), {"Nobody", "x"}));
  EXPECT_FALSE(with_texts(clip, "rename", whole_clip(clip), {"Hips", "a\nb"}));
  EXPECT_FALSE(with_texts(clip, "rename", whole_clip(clip), {"Hips", ""}));
  Clip chinese = clip;
  chinese.settings.names_in = CharacterSet::Gbk;
  EXPECT_FALSE(with_texts(chinese, "rename", whole_clip(chinese), {"Hips", "髋"}));
}

TEST(ScaleFigure, ScalesAllPoints) {
  const Clip clip = make_figure(10);
  const Clip scaled = after(clip, "scale-figure", {{"factor", 2.5}, {"unit", 1.0}});
  std::vector<double> expected = positions_of(clip);
  for (double& value : expected) value *= 2.5;
  EXPECT_LT(largest_difference(positions_of(scaled), expected), 1e-9);
  EXPECT_DOUBLE_EQ(scaled.settings.metres_per_unit, clip.settings.metres_per_unit / 2.5);
}

// Joints with six channels each, whose positions stay where the offsets are, as many programs write them.
Clip make_six_channel_clip(double wander) {
  SkeletonBuilder builder;
  for (int joint = 0; joint < 3; ++joint) {
    builder.open_joint("J" + std::to_string(joint), {0, joint * 10.0, 0});
    for (int kind = 0; kind < 6; ++kind) builder.add_channel(static_cast<ChannelKind>(kind));
  }
  builder.add_end_site({0, 5, 0});
  for (int joint = 0; joint < 3; ++joint) builder.close_joint();
  Clip clip;
  clip.skeleton = builder.build().value();
  clip.motion = Motion(18, 9, 0.1);
  for (int frame = 0; frame < 9; ++frame) {
    for (ChannelIndex channel = 0; channel < 18; ++channel) clip.motion.channel_samples(channel)[idx(frame)] = frame * channel;
    for (const ChannelIndex channel : {6, 7, 8, 12, 13, 14}) {
      clip.motion.channel_samples(channel)[idx(frame)] = 0.1 * channel + (channel == 13 ? wander * (frame % 3 - 1) : 0.0);
    }
  }
  return clip;
}

TEST(RemovePositions, MakesOffsetsOfThem) {
  const Clip clip = make_six_channel_clip(0.0);
  const OperationOutcome outcome = outcome_of(clip, "remove-positions", whole_clip(clip));
  EXPECT_THAT(outcome.notes, IsEmpty());
  const Clip changed = edited(clip, outcome.edit);
  EXPECT_EQ(changed.skeleton.channel_count(), 12);
  EXPECT_LT(largest_difference(positions_of(changed), positions_of(clip)), 1e-9);
  const Clip wandering = make_six_channel_clip(0.5);
  EXPECT_THAT(outcome_of(wandering, "remove-positions", whole_clip(wandering)).notes,
              ElementsAre("Points of the figure move by up to 0.5 file units."));
}

TEST(DeleteJoint, GivesItsRotationToItsChildren) {
  Random random(64);
  const Clip clip = make_chain(random, 10);
  const OperationOutcome outcome = outcome_of(clip, "delete-joint", joint_target(clip, {2}));
  ASSERT_EQ(outcome.notes.size(), 1u);
  EXPECT_TRUE(outcome.notes[0].starts_with("Points of the figure move by up to "));
  const Clip changed = edited(clip, outcome.edit);
  ASSERT_EQ(changed.skeleton.joint_count(), 3);
  EXPECT_EQ(changed.skeleton.name(2), "Joint3");
  EXPECT_EQ(changed.skeleton.offset(2), glm::dvec3(0, 20, 0));
  for (int frame = 0; frame < 10; ++frame) {
    const glm::dquat before = joint_rotation(clip.skeleton, clip.motion, 2, frame) * joint_rotation(clip.skeleton, clip.motion, 3, frame);
    EXPECT_NEAR(std::abs(glm::dot(before, joint_rotation(changed.skeleton, changed.motion, 2, frame))), 1.0, 1e-12);
  }
  const Operation& operation = *find_operation("delete-joint");
  EXPECT_FALSE(make_operation_edit(clip, operation, joint_target(clip, {0}), {}));
  EXPECT_FALSE(make_operation_edit(clip, operation, whole_clip(clip), {}));
}

TEST(InsertJoint, MovesNoPointAndDeletingItIsTheStart) {
  const Clip clip = make_figure(10);
  const auto outcome = with_texts(clip, "insert-joint", joint_target(clip, {7}), {"LeftHip"});
  ASSERT_TRUE(outcome) << outcome.error().message;
  const Clip changed = edited(clip, outcome->edit);
  ASSERT_EQ(changed.skeleton.joint_count(), 12);
  EXPECT_EQ(changed.skeleton.name(7), "LeftHip");
  EXPECT_EQ(changed.skeleton.parent(8), 7);
  const OperationOutcome back = outcome_of(changed, "delete-joint", joint_target(changed, {7}));
  EXPECT_THAT(back.notes, IsEmpty());
  const Clip restored = edited(changed, back.edit);
  EXPECT_EQ(restored.skeleton, clip.skeleton);
  EXPECT_LT(largest_difference(positions_of(restored), positions_of(clip)), 1e-9);
}

TEST(Reparent, KeepsTheRotationInTheWorld) {
  const Clip clip = make_figure(10);
  const auto outcome = with_texts(clip, "reparent", joint_target(clip, {3}), {"Hips"});
  ASSERT_TRUE(outcome) << outcome.error().message;
  const Clip changed = edited(clip, outcome->edit);
  ASSERT_EQ(changed.skeleton.joint_count(), 11);
  EXPECT_EQ(changed.skeleton.name(9), "LeftArm");
  EXPECT_EQ(changed.skeleton.name(10), "LeftHand");
  EXPECT_EQ(changed.skeleton.parent(9), 0);
  EXPECT_EQ(changed.skeleton.offset(9), glm::dvec3(15, 40, 0));
  EXPECT_TRUE(outcome->notes.at(0).starts_with("Points of the figure move by up to "));
  for (int frame = 0; frame < 10; ++frame) {
    const glm::dquat before = joint_rotation(clip.skeleton, clip.motion, 1, frame) * joint_rotation(clip.skeleton, clip.motion, 3, frame);
    EXPECT_NEAR(std::abs(glm::dot(before, joint_rotation(changed.skeleton, changed.motion, 9, frame))), 1.0, 1e-12);
  }
  const Clip back = edited(changed, with_texts(changed, "reparent", joint_target(changed, {9}), {"Spine"})->edit);
  // It is the last child of Spine now, behind the right arm, where every point is again where it was.
  std::vector<std::string> names;
  for (JointIndex joint = 0; joint < 11; ++joint) names.push_back(back.skeleton.name(joint));
  EXPECT_THAT(names, ElementsAre("Hips", "Spine", "Head", "RightArm", "RightHand", "LeftArm", "LeftHand", "LeftLeg", "LeftKnee",
                                 "RightLeg", "RightKnee"));
  const Clip again = edited(back, with_texts(back, "reparent", joint_target(back, {3}), {"Hips"})->edit);
  const Clip home = edited(again, with_texts(again, "reparent", joint_target(again, {9}), {"Spine"})->edit);
  EXPECT_LT(largest_difference(positions_of(home), positions_of(clip)), 1e-9);
}

TEST(Reparent, RefusesLoopsAndStrangers) {
  const Clip clip = make_figure(3);
  EXPECT_EQ(with_texts(clip, "reparent", joint_target(clip, {1}), {"LeftHand"}).error().message,
            "A joint cannot hang on itself or on one below it.");
  EXPECT_EQ(with_texts(clip, "reparent", joint_target(clip, {1}), {"Tail"}).error().message, "No joint is called \"Tail\".");
  EXPECT_FALSE(with_texts(clip, "reparent", joint_target(clip, {0}), {"Spine"}));
  EXPECT_FALSE(with_texts(clip, "reparent", joint_target(clip, {2}), {"Hips"}));
}

TEST(FigureDraft, PutTogetherUnchangedIsTheSame) {
  Random random(65);
  for (int round = 0; round < 50; ++round) {
    const Clip clip = make_random_clip(random);
    const auto figure = put_together(clip, take_apart(clip));
    ASSERT_TRUE(figure);
    EXPECT_EQ(figure->skeleton, clip.skeleton);
    Edit edit;
    edit.figure = *figure;
    ASSERT_TRUE(check_edit(clip, edit));
    EXPECT_TRUE(reduced_to_changes(clip, edit).empty());
  }
}

TEST(FigureChange, IsRefusedWhereItDoesNotFit) {
  const Clip clip = make_figure(5);
  Edit edit;
  edit.figure = FigureChange{clip.skeleton, clip.motion.frames_of({0, 3})};
  EXPECT_FALSE(check_edit(clip, edit));
  edit.figure = FigureChange{make_clip(1, 5).skeleton, clip.motion};
  EXPECT_FALSE(check_edit(clip, edit));
  edit.figure = FigureChange{clip.skeleton, clip.motion};
  EXPECT_TRUE(check_edit(clip, edit));
  edit.samples.push_back({0, 0, {1.0}});
  EXPECT_FALSE(check_edit(clip, edit));
}

TEST(FigureChange, IsSavedToldAndUndoneInADocument) {
  const Clip clip = make_figure(5);
  BvhClip read;
  read.skeleton = clip.skeleton;
  read.motion = clip.motion;
  Document document(std::move(read), "body.bvh");
  const std::string before = document.save_text();
  ASSERT_TRUE(document.apply(outcome_of(document.clip(), "offset", whole_clip(clip), {{"by", 1.0}}).edit));
  ASSERT_TRUE(document.apply(outcome_of(document.clip(), "delete-joint", joint_target(clip, {3})).edit));
  EXPECT_TRUE(document.find_changes().figure);
  EXPECT_EQ(describe(document.find_changes()), "the figure");
  EXPECT_TRUE(document.saved_samples(0).empty());
  EXPECT_EQ(document.save_text().find("LeftArm"), std::string::npos);
  ASSERT_TRUE(document.apply(outcome_of(document.clip(), "offset", whole_clip(document.clip()), {{"by", 1.0}}).edit));
  while (document.undo()) {}
  EXPECT_TRUE(document.find_changes().empty());
  EXPECT_EQ(document.save_text(), before);
  while (document.redo()) {}
  EXPECT_TRUE(document.find_changes().figure);
  document.mark_saved();
  EXPECT_TRUE(document.find_changes().empty());
  EXPECT_TRUE(document.undo());
  EXPECT_EQ(document.find_changes().samples, 5 * document.motion().channel_count());
  EXPECT_TRUE(document.undo());
  EXPECT_TRUE(document.find_changes().figure);
}

}  // namespace
}  // namespace marey::test
