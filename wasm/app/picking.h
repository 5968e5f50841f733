#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "core/base/index.h"
#include "wasm/app/camera.h"

namespace marey::app {

/// What can be clicked: a capsule between two world points, or a ball where they are the same.
struct PickSolid {
  glm::dvec3 from{0.0};
  glm::dvec3 to{0.0};
  double radius = 0.0;
  JointIndex joint = kNoParent;
};

/// The joint whose solid is under the pointer and nearest to the eye; when there is none, the joint of the solid that
/// comes nearest to the pointer within `tolerance` ImGui units; kNoParent when there is none either.
[[nodiscard]] JointIndex pick_joint(std::span<const PickSolid> solids, const CameraView& camera,
                                    const glm::dvec2& pointer, double tolerance);

}  // namespace marey::app
