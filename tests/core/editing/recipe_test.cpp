#include "core/editing/recipe.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/editing/name_match.h"
#include "tests/core/editing/operation_clips.h"

namespace marey::test {
namespace {

using testing::ElementsAre;

Error refusal_of(std::string_view text) {
  const Result<RecipeStep> step = parse_recipe_step(text);
  if (!step) return step.error();
  const Result<BoundStep> bound = bind_step(*step, make_figure(20));
  EXPECT_FALSE(bound) << text;
  return bound ? Error{} : bound.error();
}

BoundStep bound(std::string_view text) {
  const Result<RecipeStep> step = parse_recipe_step(text);
  EXPECT_TRUE(step) << text;
  const Result<BoundStep> result = bind_step(*step, make_figure(20));
  EXPECT_TRUE(result) << (result ? "" : result.error().message);
  return result ? *result : BoundStep{};
}

TEST(Recipe, StepsAreTakenApartAtBlanks) {
  const RecipeStep step = parse_recipe_step("  smooth sigma=2  joints='Left Arm',\"Neck\" frames=1:5").value();
  EXPECT_EQ(step.operation, "smooth");
  ASSERT_EQ(step.words.size(), 3u);
  EXPECT_EQ(step.words[0].name, "sigma");
  EXPECT_EQ(step.words[0].value, "2");
  EXPECT_EQ(step.words[0].column, 10);
  EXPECT_EQ(step.words[1].value, "Left Arm,Neck");
  EXPECT_EQ(step.words[2].column, 44);
}

TEST(Recipe, BindsParametersAndTarget) {
  const BoundStep step = bound("smooth sigma=3.5 joints=left*,Head channels=Xrotation frames=5:10 blend-in=2 blend-out=3 weight=0.5");
  EXPECT_EQ(step.operation->id, "smooth");
  EXPECT_THAT(step.values.numbers, ElementsAre(3.5));
  EXPECT_EQ(step.target.frames, (FrameRange{4, 6}));
  EXPECT_EQ(step.target.blend_in_frames, 2);
  EXPECT_EQ(step.target.blend_out_frames, 3);
  EXPECT_EQ(step.target.weight, 0.5);
  const Clip clip = make_figure(1);
  std::vector<std::string> labels;
  for (const ChannelIndex channel : step.target.channels) labels.push_back(channel_label(clip.skeleton, channel));
  EXPECT_THAT(labels, ElementsAre("Head Xrotation", "LeftArm Xrotation", "LeftLeg Xrotation", "LeftKnee Xrotation"));
  EXPECT_EQ(step.target.joints.size(), 4u);
}

TEST(Recipe, WithoutATargetTakesAll) {
  const BoundStep step = bound("despike");
  EXPECT_EQ(step.target.frames, (FrameRange{0, 20}));
  EXPECT_EQ(step.target.channels.size(), idx(make_figure(1).skeleton.channel_count()));
  EXPECT_EQ(step.target.joints.size(), 11u);
  EXPECT_EQ(bound("despike frames=7:").target.frames, (FrameRange{6, 14}));
  EXPECT_EQ(bound("despike frames=:7").target.frames, (FrameRange{0, 7}));
  EXPECT_EQ(bound("despike frames=7").target.frames, (FrameRange{6, 1}));
  EXPECT_EQ(bound("despike channels='LeftArm Z*'").target.channels.size(), 1u);
}

TEST(Recipe, ReadsEveryKindOfValue) {
  EXPECT_EQ(bound("scale pivot=last").values.numbers[1], 3.0);
  EXPECT_EQ(bound("zero-start heading=no").values.numbers[1], 0.0);
  EXPECT_EQ(bound("insert at=5").values.numbers[0], 4.0);
  EXPECT_EQ(bound("warp points=1:1,5:9").values.texts[0], "1:1,5:9");
  EXPECT_EQ(bound("append from=walk.bvh").other_file, "walk.bvh");
}

TEST(Recipe, RefusalsNameTheWordItsPlaceAndTheNearestName) {
  struct Row {
    std::string_view text;
    int column;
    std::string_view message;
  };
  const Row rows[] = {
      {"", 1, "The step names no operation."},
      {"smoth sigma=2", 1, "'smoth' is no operation. Did you mean 'smooth'?"},
      {"sigma=2", 1, "\"sigma=2\" stands where the name of an operation is expected."},
      {"smooth sigma", 8, "\"sigma\" is not NAME=VALUE, such as frames=10:60."},
      {"smooth sigma='2", 8, "A quote is not closed."},
      {"smooth sigm=2", 8, "'smooth' has no 'sigm', but sigma, joints, channels, frames, blend-in, blend-out, weight. Did you mean 'sigma'?"},
      {"smooth sigma=2 sigma=3", 16, "'sigma' stands twice."},
      {"smooth sigma=two", 8, "'sigma' is a number, not \"two\"."},
      {"smooth sigma=0", 8, "'sigma' is 0.1 to 1000 frames, not 0."},
      {"smooth weight=2", 8, "'weight' is a number from 0 to 1, not \"2\"."},
      {"smooth blend-in=1.5", 8, "'blend-in' is a whole number from 0 to 1000000, not \"1.5\"."},
      {"smooth joints=LeftArn", 8, "No joint is called \"LeftArn\". Did you mean 'LeftArm'?"},
      {"smooth channels=Zrotatoin", 8, "No channel is called \"Zrotatoin\". Did you mean 'Zrotation'?"},
      {"smooth frames=5-9", 8, "\"5-9\" is not FIRST:LAST, counted from 1, such as 10:60."},
      {"smooth frames=0:9", 8, "\"0:9\" is not FIRST:LAST, counted from 1, such as 10:60."},
      {"smooth frames=5:21", 8, "The clip has 20 frames, so 5:21 cannot be taken."},
      {"scale pivot=men", 7, "'pivot' is one of value, mean, first, last, not \"men\". Did you mean 'mean'?"},
      {"append blend=3", 0, "'append' wants a file as 'from'."},
  };
  for (const Row& row : rows) {
    const Error error = refusal_of(row.text);
    EXPECT_EQ(error.message, row.message);
    EXPECT_EQ(error.place.column, row.column) << row.text;
    EXPECT_FALSE(error.expected.empty()) << row.text;
  }
}

// Any words, in any order: a step is made or refused with a sentence.
TEST(Recipe, TakesOrRefusesAnything) {
  const std::string_view pieces[] = {"smooth",  "scale",   "mirror", "warp",  "rename", "trim",   " ",     "=",      ":",     ",",
                                     "sigma=",  "joints=", "frames=", "to=",   "from=",  "points=", "*",     "?",      "'",     "\"",
                                     "Left*",   "2",       "-1e308", "nan",   "1e9:1e9", "0:0",   "5:9",   "weight=", "\xff", "\t",
                                     "blend-in=", "channels=", "Z", "pivot=", "mean"};
  Random random(81);
  const Clip clip = make_figure(8);
  int made = 0;
  for (int round = 0; round < 20000; ++round) {
    std::string text(operations()[idx(random.below(size_of(operations())))].id);
    for (int i = random.below(9); i > 0; --i) text += (random.one_in(2) ? " " : "") + std::string(pieces[random.below(35)]);
    const Result<RecipeStep> step = parse_recipe_step(text);
    const Result<BoundStep> result = step ? bind_step(*step, clip) : Result<BoundStep>(step.error());
    if (!result) {
      EXPECT_TRUE(result.error().message.ends_with('.') || result.error().message.ends_with('?')) << text;
      continue;
    }
    OperationValues values = result->values;
    values.other = &clip;
    const auto outcome = make_operation_edit(clip, *result->operation, result->target, values);
    made += outcome ? 1 : 0;
  }
  EXPECT_GT(made, 1000);
}

TEST(NameMatch, KnowsStarsAndQuestionMarks) {
  EXPECT_TRUE(matches_pattern("Left*", "LeftArm"));
  EXPECT_TRUE(matches_pattern("*arm", "LeftArm"));
  EXPECT_TRUE(matches_pattern("*f*a*", "LeftArm"));
  EXPECT_TRUE(matches_pattern("L?ftArm", "LeftArm"));
  EXPECT_TRUE(matches_pattern("*", ""));
  EXPECT_FALSE(matches_pattern("Left", "LeftArm"));
  EXPECT_FALSE(matches_pattern("?", ""));
  // A pattern of many stars takes no longer.
  EXPECT_FALSE(matches_pattern("*a*a*a*a*a*a*a*a*b", std::string(2000, 'a')));
}

TEST(NameMatch, FindsTheNearestName) {
  const std::string_view names[] = {"smooth", "scale", "splice"};
  EXPECT_EQ(nearest_name("smoot", names), "smooth");
  EXPECT_EQ(nearest_name("SCALE", names), "scale");
  EXPECT_EQ(nearest_name("juggle", names), "");
}

}  // namespace
}  // namespace marey::test
