#include "core/skeleton/body_side.h"

#include <gtest/gtest.h>

#include <string>

#include "core/skeleton/skeleton_builder.h"

namespace marey {
namespace {

std::string shown(BodySide side) {
  return side == BodySide::Left ? "left" : side == BodySide::Right ? "right" : "middle";
}

void expect_side(BodySide expected, std::initializer_list<const char*> names) {
  for (const char* name : names) EXPECT_EQ(shown(find_side_in_name(name)), shown(expected)) << name;
}

// Names from recorded files of many tools: CMU, Mixamo, DAZ, Biped, Blender, MakeHuman, ASF, MMD.
TEST(BodySide, FindsLeftInNames) {
  expect_side(BodySide::Left,
              {"LeftArm", "mixamorig:LeftUpLeg", "L_Hand", "Bip01 L Thigh", "lShldr", "lBigToe", "hip.L", "upperarm_l",
               "Finger.L.001", "lfemur", "lhipjoint", "LHipJoint", "LThumb", "LHAND", "thigh_left", "HandL", "eye-L",
               "Mão.Esquerda", "brazo izquierdo", "bras gauche", "linkes Knie", "левая рука", "ЛЕВОЕ_ПЛЕЧО", "Левый",
               "左腕", "왼팔", "leftHandIndex1", "L_UpperArm", "oculi01.L"});
}

TEST(BodySide, FindsRightInNames) {
  expect_side(BodySide::Right,
              {"RightArm", "mixamorig:RightUpLeg", "R_Hand", "Bip01 R Thigh", "rShldr", "rBigToe", "hip.R", "upperarm_r",
               "Finger.R.001", "rfemur", "rhipjoint", "RHipJoint", "RThumb", "RHAND", "thigh_right", "HandR", "eye-R",
               "Mão.Direita", "brazo derecho", "bras droit", "rechtes Knie", "правая рука", "ПРАВОЕ_ПЛЕЧО", "右腕",
               "오른팔", "rightHandIndex1"});
}

TEST(BodySide, FindsNoSideInOtherNames) {
  expect_side(BodySide::Middle,
              {"Hips", "Spine", "Chest2", "Head", "Neck", "lowerback", "root", "ROOT", "L5", "L3", "T12", "Legs", "Arms",
               "Body", "upright", "RearLeg", "rib", "lip", "jaw", "", "1", "Bip01", "pelvis", "Collar", "ring",
               "collar", "finger", "тело", "\xff\xfe"});
}

Skeleton build(SkeletonBuilder& builder) { return std::move(builder.build().value()); }

TEST(BodySide, JointsWithoutASideBelongToTheirParents) {
  SkeletonBuilder builder;
  builder.open_joint("Hips");
  builder.open_joint("LeftHand", {1, 0, 0});
  builder.open_joint("Thumb", {1, 0, 0});
  builder.close_joint();
  builder.close_joint();
  builder.open_joint("Head", {-1, 3, 0});
  builder.close_joint();
  builder.close_joint();
  const std::vector<BodySide> expected{BodySide::Middle, BodySide::Left, BodySide::Left, BodySide::Middle};
  EXPECT_EQ(compute_body_sides(build(builder)), expected);
}

// A trunk with two arms of two joints each, spread along `axis`, whose names say nothing.
Skeleton make_nameless_figure(int axis, double right_length = 1.0) {
  SkeletonBuilder builder;
  builder.open_joint("a");
  for (const double side : {1.0, -right_length}) {
    glm::dvec3 reach(0.0, 0.5, 0.0);
    reach[axis] = side;
    builder.open_joint("b", reach);
    builder.open_joint("c", reach);
    builder.close_joint();
    builder.close_joint();
  }
  builder.close_joint();
  return build(builder);
}

TEST(BodySide, PlaceDecidesForMirroredFiguresWithoutNames) {
  const auto l = BodySide::Left, r = BodySide::Right, m = BodySide::Middle;
  EXPECT_EQ(compute_body_sides(make_nameless_figure(0)), (std::vector{m, l, l, r, r}));
  EXPECT_EQ(compute_body_sides(make_nameless_figure(2)), (std::vector{m, r, r, l, l}));
}

TEST(BodySide, NoSideInFiguresThatAreNotMirrored) {
  EXPECT_EQ(compute_body_sides(make_nameless_figure(0, 1.5)), std::vector(5, BodySide::Middle));
  SkeletonBuilder chain;
  chain.open_joint("Arms");
  chain.open_joint("Body", {0, 10, 0});
  chain.open_joint("Legs", {0, 12, 0});
  for (int i = 0; i < 3; ++i) chain.close_joint();
  EXPECT_EQ(compute_body_sides(build(chain)), std::vector(3, BodySide::Middle));
}

}  // namespace
}  // namespace marey
