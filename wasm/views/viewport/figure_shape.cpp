#include "wasm/views/viewport/figure_shape.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

namespace marey::app {
namespace {

// All in statures.
constexpr double kThickest = 0.026;
constexpr double kThinnest = 0.0022;
constexpr double kZeroLength = 1e-4;
// Radius by the length of the longest chain that hangs on a bone, tuned on captures: thigh 0.6, hand 0.1, finger 0.05.
constexpr double kThicknessOfReach = 0.045;
constexpr double kThicknessExponent = 0.6;
constexpr double kThickestOfLength = 0.30;

constexpr double kHeadThickest = 0.050;
constexpr double kHeadOfLength = 0.46;

constexpr double kBallOfBone = 0.80;
constexpr double kTipOfBone = 0.46;

double compute_size(const Skeleton& skeleton, const WorldPose& reference) {
  const double stature = compute_stature(skeleton);
  if (stature > 0.0) return stature;
  if (reference.world_positions.empty()) return 1.0;
  glm::dvec3 low = reference.world_positions.front();
  glm::dvec3 high = low;
  for (const glm::dvec3& position : reference.world_positions) {
    low = glm::min(low, position);
    high = glm::max(high, position);
  }
  const glm::dvec3 extent = high - low;
  const double largest = std::max({extent.x, extent.y, extent.z});
  return largest > 0.0 ? largest : 1.0;
}

double bone_length(const Skeleton& skeleton, const WorldPose& pose, NodeIndex node) {
  const NodeIndex parent = skeleton.node(node).parent;
  if (parent == kNoParent) return 0.0;
  return glm::distance(pose.world_positions[idx(node)], pose.world_positions[idx(parent)]);
}

// Per node: the length of the longest chain from its parent through it to a tip.
std::vector<double> compute_reaches(const Skeleton& skeleton, const WorldPose& reference) {
  std::vector<double> below(idx(skeleton.node_count()), 0.0);
  std::vector<double> reaches(below.size(), 0.0);
  for (NodeIndex node = skeleton.node_count() - 1; node >= 0; --node) {
    const NodeIndex parent = skeleton.node(node).parent;
    reaches[idx(node)] = below[idx(node)] + bone_length(skeleton, reference, node);
    if (parent != kNoParent) below[idx(parent)] = std::max(below[idx(parent)], reaches[idx(node)]);
  }
  return reaches;
}

double bone_radius(double length, double reach) {
  const double wanted = kThicknessOfReach * std::pow(reach, kThicknessExponent);
  return std::max(std::min({wanted, kThickest, kThickestOfLength * length}), std::min(kThinnest, 0.5 * length));
}

// The top of a head.
bool is_head(const Skeleton& skeleton, const Node& to) {
  if (!to.is_end_site) return false;
  std::string name = skeleton.name(to.joint);
  std::transform(name.begin(), name.end(), name.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  constexpr std::string_view kHeads[] = {"head", "голов", "Голов", "kopf", "cabeza", "cabeça", "头", "頭", "머리"};
  return std::any_of(std::begin(kHeads), std::end(kHeads),
                     [&](std::string_view word) { return name.find(word) != std::string::npos; });
}

// A direction across the bone, as level as can be: where the roll is 0.
glm::dvec3 across(const glm::dvec3& bone) {
  const glm::dvec3 along = glm::normalize(bone);
  const glm::dvec3 other = std::abs(along.x) < 0.8 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
  return glm::normalize(other - along * glm::dot(other, along));
}

bool moves_freely(const Skeleton& skeleton, JointIndex joint) {
  const auto channels = skeleton.channels(joint);
  return std::count_if(channels.begin(), channels.end(), [](const Channel& c) { return is_position(c.kind); }) == 3;
}

// A root with one child that has its own place: the origin of the capture volume, not a part of the body.
bool is_tether(const Skeleton& skeleton, const Node& to, double length) {
  if (to.is_end_site || to.parent == kNoParent) return false;
  const JointIndex root = skeleton.parent(to.joint);
  if (skeleton.parent(root) != kNoParent || !moves_freely(skeleton, to.joint)) return false;
  const auto nodes = skeleton.nodes();
  const auto children = std::count_if(nodes.begin(), nodes.end(), [&](const Node& n) { return n.parent == to.parent; });
  return children == 1 && std::abs(length - glm::length(to.offset)) > 0.05 * std::max(length, glm::length(to.offset));
}

// Largest radius of the bones that start or end at each node.
struct JointThickness {
  std::vector<double> starting;
  std::vector<double> ending;
};

JointThickness measure_joints(const Skeleton& skeleton, const FigureShape& shape) {
  JointThickness thickness{std::vector(idx(skeleton.node_count()), 0.0), std::vector(idx(skeleton.node_count()), 0.0)};
  for (const FigureBone& bone : shape.bones) {
    thickness.starting[idx(bone.from)] = std::max(thickness.starting[idx(bone.from)], bone.radius);
    thickness.ending[idx(bone.to)] = std::max(thickness.ending[idx(bone.to)], bone.radius);
  }
  return thickness;
}

void add_bones(const Skeleton& skeleton, const WorldPose& reference, FigureShape& shape) {
  const std::vector<double> reaches = compute_reaches(skeleton, reference);
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    const double length = bone_length(skeleton, reference, node);
    if (!(length > kZeroLength * shape.size)) continue;
    const Node& to = skeleton.node(node);
    FigureBone bone{.from = to.parent, .to = node, .joint = skeleton.node(to.parent).joint};
    bone.radius = shape.size * bone_radius(length / shape.size, reaches[idx(node)] / shape.size);
    bone.side = shape.sides[idx(bone.joint)];
    const glm::dvec3 along = reference.world_positions[idx(node)] - reference.world_positions[idx(to.parent)];
    bone.local_side = across(glm::inverse(reference.world_rotations[idx(bone.joint)]) * along);
    (is_tether(skeleton, to, length) ? shape.tethers : shape.bones).push_back(bone);
  }
  if (shape.bones.empty()) std::swap(shape.bones, shape.tethers);
}

void add_balls(const Skeleton& skeleton, const WorldPose& reference, FigureShape& shape) {
  const JointThickness thickness = measure_joints(skeleton, shape);
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    const Node& here = skeleton.node(node);
    const double starting = thickness.starting[idx(node)];
    const double ending = thickness.ending[idx(node)];
    const bool at_parent =
        here.parent != kNoParent && !(bone_length(skeleton, reference, node) > kZeroLength * shape.size);
    // Joints in one place share the ball of the first, unless theirs is the only one that bones start at.
    if (at_parent && (here.is_end_site || starting <= thickness.starting[idx(here.parent)])) continue;
    const double least = kThinnest * shape.size;
    FigureBall ball{node, here.parent == kNoParent ? node : here.parent, here.joint, std::max({kBallOfBone * starting, kTipOfBone * ending, least}),
                    shape.sides[idx(here.joint)], here.is_end_site};
    if (is_head(skeleton, here)) {
      const double length = bone_length(skeleton, reference, node);
      ball.radius = std::min(kHeadThickest * shape.size, kHeadOfLength * length);
      ball.is_head = true;
      ball.share_to_parent = std::min(ball.radius / length, 0.5);
    }
    shape.balls.push_back(ball);
  }
}

}  // namespace

FigureShape make_figure_shape(const Clip& clip, const WorldPose& reference) {
  FigureShape shape;
  if (clip.skeleton.joint_count() == 0) return shape;
  shape.size = compute_size(clip.skeleton, reference);
  shape.sides = compute_body_sides(clip.skeleton);
  add_bones(clip.skeleton, reference, shape);
  add_balls(clip.skeleton, reference, shape);
  return shape;
}

}  // namespace marey::app
