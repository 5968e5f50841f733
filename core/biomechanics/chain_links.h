#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/biomechanics/articulated_body.h"
#include "core/biomechanics/body_model.h"
#include "core/motion/clip.h"

namespace marey {

/// A pose and how it moves: by joint, in its parent (a root: in the world), in the parent's axes, SI.
struct ChainState {
  std::vector<glm::dquat> rotations;
  std::vector<glm::dvec3> angular_velocities;
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> velocities;  ///< of the positions; of roots alone they count
};

/// The state of a clip at one frame; at rest, or moving as differences of the samples say, central ones but at the ends.
/// Errors: InvalidArgument for a frame that the clip does not have, NotFinite for a sample that is not.
[[nodiscard]] Result<ChainState> find_chain_state(const Clip& clip, FrameIndex frame, bool is_moving);

/// A figure as links: for each joint with mass below it a hinge, two of them one behind the other, a ball or a fixed link, as
/// its rotation channels ask for; before that of a free root a slide.
struct ChainLinks {
  std::vector<Link> links;
  std::vector<LinkState> states;
  std::vector<int> first_links;  ///< by joint, and one behind the last: the links of a joint end where those of the next begin
};

/// Precondition: the model fits the figure, the state has all its joints, with rotations that their channels can give.
[[nodiscard]] ChainLinks make_chain_links(const Skeleton& skeleton, const BodyModel& model, const ChainState& state, bool root_held);

}  // namespace marey
