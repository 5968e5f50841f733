#pragma once

#include <string>
#include <vector>

#include "core/biomechanics/passive_chain.h"
#include "tests/core/biomechanics/body_fixtures.h"

namespace marey::test {

/// A figure that is let go, and what it is made of. Metres.
struct Figure {
  Skeleton skeleton;
  BodyModel model;
  ChainState state;
  PassiveSettings settings{.change_per_second = 1e-8};

  [[nodiscard]] PassiveChain let_go() const;
};

/// In the rest pose, at rest.
[[nodiscard]] Figure make_figure(Skeleton skeleton, BodyModel model);

/// A hanging chain of uniform rods of one length, the first on the world; rods as thin as they can be.
[[nodiscard]] Figure make_rods(const std::vector<double>& masses, double length, const std::string& channels);

/// One body on a ball joint, or free: its centre at `com`, moments about it.
[[nodiscard]] Figure make_top(double mass, const glm::dvec3& com, const glm::dvec3& moments);

/// Any tree of joints with any channels, turned and turning at random; lengths of some metres.
[[nodiscard]] Figure make_random_figure(int joint_count, unsigned seed, bool root_held);

/// The motion of one frame: the chain as it is now.
[[nodiscard]] BodyMotion body_of(const PassiveChain& chain);
[[nodiscard]] BodyState whole_of(const Figure& figure, const PassiveChain& chain);

/// The largest torque that a joint would have to give about an axis that it is free to turn about, a free root's whole load
/// too, as a share of the largest load of all or of the weight.
[[nodiscard]] double largest_torque_share(const Figure& figure, const PassiveChain& chain);

}  // namespace marey::test
