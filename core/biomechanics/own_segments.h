#pragma once

#include "core/biomechanics/body_model.h"
#include "core/motion/clip.h"

/// What people say of segments, as choices of a clip's body. Whether a value can be is for check_edit().
namespace marey {

/// A segment as people's own values.
[[nodiscard]] OwnSegment make_own_segment(const Segment& segment);

/// A uniform rod from a joint to its first child or end site; a point mass where that is at the joint.
[[nodiscard]] OwnSegment make_own_rod(const Clip& clip, JointIndex joint, double mass_kg);

/// Puts a segment in the place of what is said of its joint.
void put_own_segment(BodyChoice& body, const OwnSegment& segment);

/// Another mass for all that a joint carries: its shape stays, so inertia goes along, also to 0. A joint that carried nothing gets
/// a rod.
[[nodiscard]] BodyChoice with_segment_mass(const Clip& clip, JointIndex joint, double mass_kg);

/// Another mass of the body: every segment keeps its share and its shape.
[[nodiscard]] BodyChoice with_body_mass(const Clip& clip, double mass_kg);

/// The same contacts and parts with the masses and the gravity of a model and no others; what hangs on one joint becomes one
/// segment. A model's unit of length is the clip's matter, and not in it.
[[nodiscard]] BodyChoice choose_model(const BodyChoice& present, const BodyModel& model);

}  // namespace marey
