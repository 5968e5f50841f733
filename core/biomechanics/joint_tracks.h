#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "core/biomechanics/derivation.h"
#include "core/motion/clip.h"

namespace marey {

/// How a point moves, by frame, in SI units.
struct PointTrack {
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> velocities;
  std::vector<glm::dvec3> accelerations;
};

/// How one joint moves in its parent, a root in the world: by frame, in the parent's axes, SI units and radians.
struct JointTrack {
  std::vector<glm::dquat> rotations;  ///< unit length
  std::vector<glm::dvec3> angular_velocities;
  std::vector<glm::dvec3> angular_accelerations;
  PointTrack origin;  ///< from that of the parent
};

/// Smooths and differentiates a path, coordinate by coordinate. Differences are one-sided at the ends, of second order.
/// Precondition: find_joint_tracks() takes the method for as many frames.
[[nodiscard]] PointTrack differentiate_path(std::vector<glm::dvec3> positions, const Derivation& derivation, double rate_hz);

/// The tracks of all joints of a clip whose frames are `frame_time_s` apart. Rotations are differentiated as rotations: about
/// each frame by logarithms, log(q[n + k] q[n]^-1), at which weights of the method are laid; so angles may wrap and pass
/// gimbal lock. With central differences that is the mean of two half steps, and their difference (theory.md 4). At the ends
/// differences are one-sided, of second order. A smoothed clip has the smoothed pose too.
/// Errors: InvalidArgument where the method does not fit the clip (a cut-off of half the frame rate or more, fewer frames than
/// a window or a spline needs), NotFinite for samples that are not.
[[nodiscard]] Result<std::vector<JointTrack>> find_joint_tracks(const Clip& clip, const Derivation& derivation, double frame_time_s,
                                                                double metres_per_unit);

}  // namespace marey
