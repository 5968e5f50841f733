#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <string>
#include <vector>

#include "core/biomechanics/body_model.h"
#include "core/motion/clip.h"

namespace marey::test {

/// What moves a body in its parent as MuJoCo counts it. The joint of a skeleton has one Free or Turn or Hinge or none, and up
/// to three Slides before a Turn or a Hinge.
enum class FreedomKind {
  Free,   ///< three positions and more than one rotation channel, at a root; qvel: origin in the world, then as Turn
  Slide,  ///< a position channel: along an axis of the parent
  Hinge,  ///< the only rotation channel: about that axis
  Turn,   ///< more rotation channels (a ball joint): a quaternion; qvel: angular velocity in the parent, in the joint's own axes
};

struct Freedom {
  JointIndex joint = 0;
  FreedomKind kind = FreedomKind::Turn;
  Axis axis = Axis::X;  ///< of Slide and Hinge
  int position = 0;     ///< its first element of qpos
  int velocity = 0;     ///< its first element of qvel, qacc and qfrc_*
};

/// What a joint with two rotation channels is: Marey differentiates its rotation as any, but lets it go about its axes alone.
enum class TwoAxes { Turn, Hinges };

/// The freedoms of a skeleton in the order in which MuJoCo is told of them, places in qpos and qvel not yet known. With
/// TwoAxes::Hinges a joint may have two Hinges in place of a Turn, and a root with them three Slides in place of a Free.
[[nodiscard]] std::vector<Freedom> find_freedoms(const Skeleton& skeleton, TwoAxes two_axes = TwoAxes::Turn);

/// The MJCF text of a figure: a body "J<joint>" per joint, its rest pose as the offsets draw it, with the joint's first segment;
/// further ones are bodies welded to it. Where a joint has no segment, MuJoCo wants some mass: kSpeck kilograms. No shapes, so
/// nothing collides.
[[nodiscard]] std::string write_mjcf(const Clip& clip, const BodyModel& model, const glm::dvec3& gravity_mps2,
                                     const std::vector<Freedom>& freedoms);

/// In kg and kg m2: more than MuJoCo takes for nothing (mjMINVAL), less than is seen beside real masses. The mass matrix may be
/// singular with it: what has to be solved for accelerations needs a real mass on each joint.
inline constexpr double kSpeck = 1e-14;

/// A figure with masses as MuJoCo has it. The process ends with MuJoCo's message if it refuses the text or warns of anything.
class MujocoFigure {
 public:
  MujocoFigure(const Clip& clip, const BodyModel& model, const glm::dvec3& gravity_mps2, TwoAxes two_axes = TwoAxes::Turn);

  /// For MuJoCo's functions, which take plain pointers.
  [[nodiscard]] mjModel* model() const { return model_.get(); }
  [[nodiscard]] mjData* data() const { return data_.get(); }

  [[nodiscard]] const std::vector<Freedom>& freedoms() const { return freedoms_; }
  /// MuJoCo's number of a joint's body.
  [[nodiscard]] int body_of(JointIndex joint) const { return bodies_[idx(joint)]; }

 private:
  struct Deleter {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
    void operator()(mjData* data) const { mj_deleteData(data); }
  };
  std::vector<Freedom> freedoms_;
  std::unique_ptr<mjModel, Deleter> model_;
  std::unique_ptr<mjData, Deleter> data_;
  std::vector<int> bodies_;
};

}  // namespace marey::test
