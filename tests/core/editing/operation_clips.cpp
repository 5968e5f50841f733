#include "tests/core/editing/operation_clips.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/skeleton/skeleton_builder.h"

namespace marey::test {
namespace {

void add_rotations(SkeletonBuilder& builder, std::string_view axes) {
  for (const char axis : axes) builder.add_channel(static_cast<ChannelKind>(static_cast<int>(ChannelKind::Xrotation) + axis - 'X'));
}

void add_limb(SkeletonBuilder& builder, const std::string& side, double sign) {
  builder.open_joint(side + "Leg", {sign * 10.0, -5.0, 0.0});
  add_rotations(builder, "ZXY");
  builder.open_joint(side + "Knee", {0.0, -40.0, 0.0});
  add_rotations(builder, "X");
  builder.add_end_site({0.0, -40.0, 5.0});
  builder.close_joint();
  builder.close_joint();
}

void add_arm(SkeletonBuilder& builder, const std::string& side, double sign) {
  builder.open_joint(side + "Arm", {sign * 15.0, 20.0, 0.0});
  add_rotations(builder, "XYZ");
  builder.open_joint(side + "Hand", {sign * 30.0, 0.0, 2.0});
  add_rotations(builder, "ZY");
  builder.add_end_site({sign * 10.0, 0.0, 0.0});
  builder.close_joint();
  builder.close_joint();
}

Skeleton make_body() {
  SkeletonBuilder builder;
  builder.open_joint("Hips");
  for (int kind = 0; kind < 3; ++kind) builder.add_channel(static_cast<ChannelKind>(kind));
  add_rotations(builder, "YXZ");
  builder.open_joint("Spine", {0.0, 20.0, 0.0});
  add_rotations(builder, "ZXY");
  builder.open_joint("Head", {0.0, 40.0, 0.0});
  add_rotations(builder, "X");
  builder.add_end_site({0.0, 15.0, 0.0});
  builder.close_joint();
  add_arm(builder, "Left", 1.0);
  add_arm(builder, "Right", -1.0);
  builder.close_joint();
  add_limb(builder, "Left", 1.0);
  add_limb(builder, "Right", -1.0);
  builder.close_joint();
  return builder.build().value();
}

}  // namespace

Clip make_figure(int frame_count) {
  Clip clip;
  clip.skeleton = make_body();
  clip.motion = Motion(clip.skeleton.channel_count(), frame_count, 1.0 / 30.0);
  for (ChannelIndex channel = 0; channel < clip.motion.channel_count(); ++channel) {
    const std::span<double> samples = clip.motion.channel_samples(channel);
    for (int frame = 0; frame < frame_count; ++frame) {
      samples[idx(frame)] = 20.0 * std::sin(0.2 * frame + 0.7 * channel) + 3.0 * std::sin(1.1 * frame + channel);
    }
  }
  for (int frame = 0; frame < frame_count; ++frame) {
    clip.motion.channel_samples(0)[idx(frame)] = 5.0 + 2.0 * std::sin(0.1 * frame);
    clip.motion.channel_samples(1)[idx(frame)] = 90.0 + std::sin(0.4 * frame);
    clip.motion.channel_samples(2)[idx(frame)] = 7.0 + 3.0 * frame;
    clip.motion.channel_samples(3)[idx(frame)] = 25.0 + 1.5 * frame;
  }
  return clip;
}

Clip make_wild_figure(Random& random, int frame_count) {
  Clip clip = make_figure(frame_count);
  for (ChannelIndex channel = 0; channel < clip.motion.channel_count(); ++channel) {
    double value = random.between(-300, 300);
    for (double& sample : clip.motion.channel_samples(channel)) {
      value += random.between(-25, 25);
      sample = random.one_in(15) ? value + 360.0 * (random.below(5) - 2) : value;
    }
  }
  return clip;
}

OperationValues values_of(const Operation& operation, std::initializer_list<Given> given, const Clip* other) {
  OperationValues values = initial_values(operation);
  values.other = other;
  for (const auto& [name, number] : given) {
    const int place = find_parameter(operation, name);
    EXPECT_GE(place, 0) << operation.id << " has no " << name;
    if (place >= 0) values.numbers[idx(place)] = number;
  }
  return values;
}

double choice_of(std::string_view operation, std::string_view parameter, std::string_view choice) {
  const Operation& found = *find_operation(operation);
  const auto choices = found.parameters[idx(find_parameter(found, parameter))].choices;
  const auto place = std::find(choices.begin(), choices.end(), choice);
  EXPECT_NE(place, choices.end()) << choice;
  return static_cast<double>(place - choices.begin());
}

OperationOutcome outcome_of(const Clip& clip, std::string_view operation, const OperationTarget& target,
                            std::initializer_list<Given> given, const Clip* other) {
  const Operation* found = find_operation(operation);
  EXPECT_NE(found, nullptr) << operation;
  if (found == nullptr) return {};
  const auto outcome = make_operation_edit(clip, *found, target, values_of(*found, given, other));
  EXPECT_TRUE(outcome) << (outcome ? "" : outcome.error().message);
  return outcome ? *outcome : OperationOutcome{};
}

Clip after(const Clip& clip, std::string_view operation, std::initializer_list<Given> given) {
  return after(clip, operation, whole_clip(clip), given);
}

Clip after(const Clip& clip, std::string_view operation, const OperationTarget& target, std::initializer_list<Given> given) {
  return edited(clip, outcome_of(clip, operation, target, given).edit);
}

OperationValues make_random_values(Random& random, const Operation& operation, const Clip* other) {
  OperationValues values = initial_values(operation);
  values.other = other;
  for (std::size_t i = 0; i < operation.parameters.size(); ++i) {
    const OperationParameter& parameter = operation.parameters[i];
    if (parameter.kind == ParameterKind::Points) values.texts[i] = random.one_in(2) ? "2:1,9:20" : "1:1";
    if (parameter.kind == ParameterKind::Text) values.texts[i] = random.one_in(2) ? "Left*" : "*_x";
    if (is_text(parameter.kind) || random.one_in(3)) continue;
    // Mostly near the low end, where the numbers are that people choose.
    const double most = std::min(parameter.most, std::max(parameter.least + 1.0, random.one_in(5) ? 60.0 : 12.0));
    const double least = std::max(parameter.least, -12.0);
    double value = random.between(least, most);
    if (parameter.kind != ParameterKind::Number) value = std::round(value);
    if (parameter.odd) value = 2.0 * std::floor(0.5 * value) + 1.0;
    values.numbers[i] = std::clamp(value, parameter.least, parameter.most);
  }
  // Wild figures take it long.
  if (operation.id == "let-go") values.numbers[idx(find_parameter(operation, "seconds"))] = random.between(0.01, 0.06);
  return values;
}

OperationTarget make_random_target(Random& random, const Clip& clip) {
  OperationTarget target = whole_clip(clip);
  if (random.one_in(3)) std::erase_if(target.channels, [&](int) { return random.one_in(2); });
  if (random.one_in(3)) std::erase_if(target.joints, [&](int) { return random.one_in(2); });
  if (random.one_in(2)) target.frames = {random.below(clip.motion.frame_count() + 3) - 1, random.below(clip.motion.frame_count() + 2)};
  target.blend_in_frames = random.below(6);
  target.blend_out_frames = random.below(6);
  if (random.one_in(3)) target.weight = random.unit();
  return target;
}

std::vector<double> positions_of(const Clip& clip) {
  std::vector<double> positions(idx(clip.motion.frame_count()) * idx(clip.skeleton.node_count()) * 3);
  compute_world_positions(clip.skeleton, clip.motion, {0, clip.motion.frame_count()}, clip.settings.position_rule, positions);
  return positions;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  EXPECT_EQ(a.size(), b.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

}  // namespace marey::test
