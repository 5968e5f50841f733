#include "core/lint/finding.h"

#include <array>

namespace marey {
namespace {

using Kind = FindingKind;
using Tool = std::string_view;

constexpr std::array<Tool, 1> kBindByName = {"three.js"};
constexpr std::array<Tool, 6> kCutNamesAtBlanks = {"BVHView", "three.js", "pybvh", "bvh-python", "LaFAN1", "usdBVHAnim"};
constexpr std::array<Tool, 2> kAsciiNames = {"BVHView", "usdBVHAnim"};
constexpr std::array<Tool, 4> kOneRoot = {"BVHView", "three.js", "pybvh", "bvh-python"};
constexpr std::array<Tool, 2> kBonesWithLength = {"Blender", "MB-Lab"};
constexpr std::array<Tool, 3> kThreeRotations = {"pybvh", "pymotion", "Second Life"};
constexpr std::array<Tool, 4> kNoSingleChannel = {"Blender", "pybvh", "pymotion", "Second Life"};
constexpr std::array<Tool, 5> kPositionsOfRootOnly = {"three.js", "pybvh", "GenMM", "Anytop", "bvhio"};
constexpr std::array<Tool, 2> kOneOrder = {"Babylon.js", "3DEXPERIENCE"};
constexpr std::array<Tool, 3> kOneOrderForAll = {"Babylon.js", "3DEXPERIENCE", "bvhretarget"};
constexpr std::array<Tool, 1> kPositionsFirst = {"pymotion"};
constexpr std::span<const Tool> kNone;

constexpr std::array<FindingTraits, kFindingKindCount> kTraits = {{
    {Kind::DuplicateName, "duplicate_name", "Give each joint a name of its own.", kBindByName},
    {Kind::EmptyName, "empty_name", "Give each joint a name.", kNone},
    {Kind::NameWithBlank, "name_with_blank", "Write '_' in place of the blank.", kCutNamesAtBlanks},
    {Kind::NameNotAscii, "name_not_ascii", "Use letters, digits and '_' where the file goes to other programs.",
     kAsciiNames},
    {Kind::NameDiffersInCase, "name_differs_in_case", "Make the names differ in more than their case.", kNone},
    {Kind::SeveralRoots, "several_roots", "Put the figures into files of their own, or below one root.", kOneRoot},
    {Kind::ZeroLengthBone, "zero_length_bone", "Merge the joints, or give the bone a small length.", kBonesWithLength},
    {Kind::LeafWithoutEndSite, "leaf_without_end_site", "Add an End Site, which gives the last bone its length.", kNone},
    {Kind::JointWithoutChannels, "joint_without_channels", "Give the joint three rotations, or merge it with its parent.",
     kThreeRotations},
    {Kind::SingleChannelJoint, "single_channel_joint", "Add the other rotations with the value 0.", kNoSingleChannel},
    {Kind::PositionBelowRoot, "position_below_root",
     "Leave out positions that only repeat OFFSET or stay 0 beside it; else check that the figure looks the same elsewhere.",
     kPositionsOfRootOnly},
    {Kind::MixedRotationOrders, "mixed_rotation_orders", "Use programs that read the order of each joint.",
     kOneOrderForAll},
    {Kind::RareRotationOrder, "rare_rotation_order", "Check that the receiving program reads the order from the file.",
     kOneOrder},
    {Kind::UnusualChannelOrder, "unusual_channel_order",
     "Write Xposition Yposition Zposition before the rotations where a program expects them there.", kPositionsFirst},
    {Kind::ReferencePose, "reference_pose", "Leave the frame out before playing in a loop, filtering or measuring.",
     kNone},
    {Kind::Jump, "jump", "Look for a cut, or for lost markers, and smooth or cut there.", kNone},
    {Kind::Spike, "spike", "Replace the frame by the mean of its neighbours.", kNone},
    {Kind::AngleWrap, "angle_wrap", "Add or take whole turns from there on before filtering or resampling the curve.",
     kNone},
    {Kind::GimbalFlip, "gimbal_flip",
     "Filter and resample the rotation as a whole, not its angles, or choose another rotation order.", kNone},
    {Kind::FrozenFigure, "frozen_figure", "Check whether the recording stood still there, and cut it.", kNone},
    {Kind::FrozenChannel, "frozen_channel", "Check for lost tracking or a limit that was applied.", kNone},
    {Kind::BelowFloor, "below_floor", "Check the height of the root and the length of the legs there.", kNone},
}};

constexpr bool rows_follow_the_kinds() {
  for (std::size_t i = 0; i < kTraits.size(); ++i) {
    if (kTraits[i].kind != static_cast<Kind>(i)) return false;
  }
  return true;
}
static_assert(rows_follow_the_kinds());

}  // namespace

const FindingTraits& traits_of(FindingKind kind) { return kTraits[static_cast<std::size_t>(kind)]; }

}  // namespace marey
