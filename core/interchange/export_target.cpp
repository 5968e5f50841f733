#include "core/interchange/export_target.h"

#include <algorithm>
#include <array>

#include "core/base/text_cursor.h"

namespace marey {
namespace {

using R = Requirement;
using T = ExportTarget;

constexpr std::array<RequirementTraits, kRequirementCount> kRequirements = {{
    {R::OneRoot, "one_root", "One root; several are put below an added one."},
    {R::RootPositions, "root_positions", "The root has three position channels."},
    {R::PositionsOfRootOnly, "positions_of_root_only",
     "No joint below the root has position channels; its OFFSET is the usual one of its positions."},
    {R::WholePositions, "whole_positions", "A joint with a position channel has all three."},
    {R::PositionsAddToOffset, "positions_add_to_offset", "Positions are written as what is to be added to OFFSET."},
    {R::NoRootOffset, "no_root_offset", "The OFFSET of the root is 0 0 0; its positions hold the whole place."},
    {R::ThreeRotations, "three_rotations", "Every joint has three rotations about three axes."},
    {R::ThreeRotationsOrNone, "three_rotations_or_none",
     "A joint that rotates has three rotations about three axes."},
    {R::RotationOrderZxy, "rotation_order_zxy", "Every joint rotates in the order Zrotation Xrotation Yrotation."},
    {R::AsciiNames, "ascii_names",
     "Names of at most 63 ASCII letters, digits, '_', '-', '.' and ':', each only once."},
    {R::WordNames, "word_names", "Names of at most 63 ASCII letters, digits and '_', each only once."},
    {R::EndSites, "end_sites", "Every limb ends in an End Site."},
    {R::NoInnerEndSites, "no_inner_end_sites", "Joints with children have no End Site, and no joint has two."},
    {R::ReferencePose, "reference_pose", "The first frame is the rest pose, all angles 0."},
}};

constexpr std::array<TargetNeed, 9> kStrictNeeds = {{
    {R::OneRoot, "Many readers stop at a second root."},
    {R::RootPositions, "Readers with a fixed layout take the first three columns for the place of the figure."},
    {R::PositionsOfRootOnly, "Readers add them to OFFSET, let them replace it, refuse them or leave them out."},
    {R::NoRootOffset, "Readers add the OFFSET of the root to its positions, or leave it out."},
    {R::ThreeRotations, "Readers with a fixed layout count three columns for every joint."},
    {R::RotationOrderZxy, "Some readers know one order only, which is that of the 1999 text."},
    {R::WordNames, "Readers cut names at blanks, or take letters and digits only."},
    {R::EndSites, "Readers count on them for the length of the last bone."},
    {R::NoInnerEndSites, "Readers that know one of the two lose the other."},
}};

constexpr std::array<TargetNeed, 3> kBlenderNeeds = {{
    {R::ThreeRotationsOrNone, "It stops at joints with one or two rotations, and at an axis that comes back."},
    {R::WholePositions, "It takes an axis without a channel for 0, not for OFFSET."},
    {R::AsciiNames, "It drops joints with the name of another one, and cuts names at 63 bytes."},
}};

constexpr std::array<TargetNeed, 4> kThreeNeeds = {{
    {R::OneRoot, "It stops at a second root."},
    {R::PositionsAddToOffset, "It adds positions to OFFSET at every joint."},
    {R::NoRootOffset, "The way of the root is then the same to programs that do not add."},
    {R::WordNames, "It cuts names at blanks, plays by name, and takes ':', '/' and brackets for parts of a path."},
}};

constexpr std::array<TargetNeed, 4> kBvhViewNeeds = {{
    {R::OneRoot, "It stops at a second root."},
    {R::WholePositions, "Its positions replace OFFSET."},
    {R::ThreeRotationsOrNone, "A joint with more than six channels overruns its memory."},
    {R::AsciiNames, "It takes letters, digits, '_', ':', '.' and '-' only."},
}};

constexpr std::array<TargetNeed, 5> kPybvhNeeds = {{
    {R::OneRoot, "It refuses a second root."},
    {R::RootPositions, "It wants three positions and three rotations at the root."},
    {R::PositionsOfRootOnly, "It refuses positions below the root."},
    {R::ThreeRotations, "It wants three rotations at every other joint."},
    {R::AsciiNames, "It cuts names at blanks."},
}};

constexpr std::array<TargetNeed, 2> kMotionBuilderNeeds = {{
    {R::ReferencePose, "Characterising starts from a T pose in the first frame."},
    {R::AsciiNames, "Joint names should not contain blanks."},
}};

constexpr std::array<TargetNeed, 7> kSecondLifeNeeds = {{
    {R::OneRoot, "It animates one pelvis."},
    {R::RootPositions, "It takes the positions of the pelvis from the first of six columns."},
    {R::PositionsOfRootOnly, "It reads positions as part of six columns, for the pelvis."},
    {R::NoRootOffset, "It passes over every OFFSET."},
    {R::ThreeRotations, "It refuses a joint with fewer rotations."},
    {R::AsciiNames, "It cuts names at blanks."},
    {R::ReferencePose, "It takes the first frame for the reference and does not play it."},
}};

constexpr std::array<TargetTraits, kExportTargetCount> kTargets = {{
    {T::Strict, "strict", "Any strict reader",
     "For programs that are not in this list: what every reader of the 1999 text takes.",
     "J. Lander's text on Biovision BVH (University of Wisconsin, 1999), and the habits of the readers below",
     "", kStrictNeeds},
    {T::Blender, "blender", "Blender", "For File > Import > Motion Capture (.bvh).",
     "its add-on io_anim_bvh as of Blender 3.4, read and run",
     "Blender shows bones without length with a length of its own.", kBlenderNeeds},
    {T::Three, "three", "three.js", "For BVHLoader and programs made with it.", "BVHLoader of three 0.187, read and run",
     "", kThreeNeeds},
    {T::BvhView, "bvhview", "BVHView", "For the viewer BVHView, on the desktop and in the browser.",
     "its parser as of August 2025, read and run", "", kBvhViewNeeds},
    {T::Pybvh, "pybvh", "pybvh", "For Python programs that read with pybvh.", "pybvh 0.9, read and run", "",
     kPybvhNeeds},
    {T::MotionBuilder, "motionbuilder", "MotionBuilder", "For characterising in MotionBuilder and its relatives.",
     "Autodesk's help of MotionBuilder 2014 on BVH, and tutorials on characterising",
     "The rest pose is a T pose only if the file's OFFSETs draw one.", kMotionBuilderNeeds},
    {T::SecondLife, "second-life", "Second Life", "For uploading an animation to Second Life and its relatives.",
     "llbvhloader.cpp of the viewer, read; the wiki on the length of animations",
     "Only joints with the names of the avatar's bones move, the root being its hip. At most 60 seconds.",
     kSecondLifeNeeds},
}};

constexpr bool rows_follow_the_enums() {
  for (std::size_t i = 0; i < kRequirements.size(); ++i) {
    if (kRequirements[i].requirement != static_cast<R>(i)) return false;
  }
  for (std::size_t i = 0; i < kTargets.size(); ++i) {
    if (kTargets[i].target != static_cast<T>(i)) return false;
  }
  return true;
}
static_assert(rows_follow_the_enums());

}  // namespace

bool TargetTraits::asks_for(Requirement requirement) const {
  return std::any_of(needs.begin(), needs.end(),
                     [requirement](const TargetNeed& need) { return need.requirement == requirement; });
}

const RequirementTraits& traits_of(Requirement requirement) { return kRequirements[static_cast<std::size_t>(requirement)]; }

const TargetTraits& traits_of(ExportTarget target) { return kTargets[static_cast<std::size_t>(target)]; }

std::span<const TargetTraits> export_targets() { return kTargets; }

std::optional<ExportTarget> find_export_target(std::string_view id) {
  for (const TargetTraits& traits : kTargets) {
    if (equal_ignoring_case(traits.id, id)) return traits.target;
  }
  return std::nullopt;
}

}  // namespace marey
