#pragma once

#include <vector>

#include "core/biomechanics/analysis.h"
#include "core/biomechanics/body_motion.h"
#include "core/biomechanics/file_poses.h"

namespace marey {

/// What the columns of an analysis are made of: poses, movement, and the mechanics where the request needs them.
class AnalysedClip {
 public:
  /// `clip` and `request` must outlive it.
  AnalysedClip(const Clip& clip, const AnalysisRequest& request, BodyMotion body);

  void find_poses(bool with_rotations) { poses_ = find_file_poses(clip_, body_.metres_per_unit, with_rotations); }
  /// Precondition: the request has a model, and that is checked.
  void find_mechanics();
  /// What people should know of the numbers.
  void add_notes(AnalysisTable& table) const;

  [[nodiscard]] const Clip& clip() const { return clip_; }
  [[nodiscard]] const AnalysisRequest& request() const { return request_; }
  [[nodiscard]] const BodyMotion& body() const { return body_; }
  [[nodiscard]] const FilePoses& poses() const { return poses_; }
  [[nodiscard]] const BodyState& state(FrameIndex frame) const { return states_[idx(frame)]; }
  [[nodiscard]] const GroundReaction& reaction(FrameIndex frame) const { return reactions_[idx(frame)]; }
  [[nodiscard]] const JointLoad& load(FrameIndex frame, JointIndex joint) const {
    return loads_[idx(frame) * idx(body_.joint_count) + idx(joint)];
  }
  /// The floor, in metres; where the support has none, that of find_contacts().
  [[nodiscard]] double floor_m() const { return support_.contacts.floor_m; }
  [[nodiscard]] const SettledSupport& support() const { return support_; }
  [[nodiscard]] const glm::dvec3& gravity() const { return gravity_; }

 private:
  [[nodiscard]] SettledSupport settle_support() const;
  void find_frame_loads(FrameIndex frame);

  const Clip& clip_;
  const AnalysisRequest& request_;
  BodyMotion body_;
  glm::dvec3 gravity_{0.0};
  FilePoses poses_;
  SettledSupport support_;
  std::vector<BodyState> states_;
  std::vector<GroundReaction> reactions_;
  std::vector<JointLoad> loads_;
  int shared_frames_ = 0;  // in which more than one point touches
};

}  // namespace marey
