#include "core/biomechanics/analysed_clip.h"

#include <fmt/format.h>

#include <limits>
#include <utility>

#include "core/base/counted.h"

namespace marey {

AnalysedClip::AnalysedClip(const Clip& clip, const AnalysisRequest& request, BodyMotion body)
    : clip_(clip), request_(request), body_(std::move(body)) {
  gravity_[static_cast<int>(clip.settings.up_axis)] = -9.81;
  if (request.model && request.model->gravity_mps2) gravity_ = *request.model->gravity_mps2;
}

void AnalysedClip::find_mechanics() {
  const Skeleton& skeleton = clip_.skeleton;
  support_ = request_.support;
  if (support_ == SupportKind::Auto) {
    support_ = roots_stand_still(body_, skeleton) ? SupportKind::Pivot : SupportKind::Ground;
    follows_contacts_ = support_ == SupportKind::Ground;
  }
  contacts_ = find_contacts(body_, skeleton, clip_.settings.up_axis);
  loads_.resize(idx(body_.frame_count) * idx(body_.joint_count));
  for (FrameIndex frame = 0; frame < body_.frame_count; ++frame) {
    states_.push_back(find_body_state(body_, *request_.model, gravity_, frame));
    find_frame_loads(frame);
  }
}

bool AnalysedClip::is_ground(FrameIndex frame) const {
  return support_ == SupportKind::Ground && (!follows_contacts_ || contacts_.any_down(frame));
}

void AnalysedClip::find_frame_loads(FrameIndex frame) {
  const BodyModel& model = *request_.model;
  const std::span<JointLoad> loads = std::span(loads_).subspan(idx(frame) * idx(body_.joint_count), idx(body_.joint_count));
  GroundReaction reaction{glm::dvec3(0.0), glm::dvec3(std::numeric_limits<double>::quiet_NaN())};
  std::vector<OuterForce> outer;
  if (is_ground(frame)) {
    reaction = find_ground_reaction(states_.back(), total_mass_kg(model), gravity_, clip_.settings.up_axis, contacts_.floor_m);
    outer = share_out(reaction, states_.back(), body_, contacts_, frame);
    shared_frames_ += outer.size() > 1 ? 1 : 0;
  }
  find_joint_loads(body_, clip_.skeleton, model, gravity_, frame, outer, loads);
  if (support_ == SupportKind::Pivot) {
    for (JointIndex joint = 0; joint < body_.joint_count; ++joint) {
      if (clip_.skeleton.parent(joint) == kNoParent) reaction.force += loads[idx(joint)].force;
    }
  }
  reactions_.push_back(reaction);
}

void AnalysedClip::add_notes(AnalysisTable& table) const {
  if (!request_.model || !request_.model->metres_per_unit) {
    table.notes.push_back(fmt::format("A unit of the file is taken for {:g} m.", body_.metres_per_unit));
  }
  if (states_.empty()) return;
  if (support_ == SupportKind::Pivot) {
    table.notes.emplace_back("Held at its root; the torque there is a residual, as a bar passes on next to none.");
  } else if (support_ == SupportKind::Flight) {
    table.notes.emplace_back("In flight; force and torque at the root are residuals.");
  } else if (shared_frames_ > 0) {
    table.notes.push_back(fmt::format("On the ground with more than one point in {}: how they share the reaction is an estimate.",
                                      counted(shared_frames_, "frame")));
  }
}

}  // namespace marey
