#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/biomechanics/body_tables.h"
#include "core/motion/body_choice.h"
#include "core/skeleton/body_side.h"
#include "core/skeleton/skeleton.h"

namespace marey {

/// The part of the body that begins at a joint.
struct NamedPart {
  BodyPart part = BodyPart::Trunk;
  BodySide side = BodySide::Middle;
  bool is_both = false;  ///< both limbs in one, as "Arms" of a figure seen from the side
};

/// Per joint what its name and its place in the tree speak for; nothing for joints that carry no part of their own: collar
/// bones, fingers, toes, helpers, and all of a figure that is no human. Names of the families of Biovision, CMU, LaFAN1, Mixamo,
/// SD/FAST and Daz: "LeftShoulder" is the upper arm where its child is an elbow or a forearm, else the collar bone; "LeftLeg"
/// is the shank where the same side has a thigh above it.
[[nodiscard]] std::vector<std::optional<NamedPart>> find_named_parts(const Skeleton& skeleton);

/// The same, with what people say of some joints. A part of a limb or a head that is said to begin elsewhere begins there only.
[[nodiscard]] std::vector<std::optional<NamedPart>> find_named_parts(const Skeleton& skeleton, std::span<const OwnPart> own);

}  // namespace marey
