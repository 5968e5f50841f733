#include "core/biomechanics/analysed_clip.h"

#include <fmt/format.h>

#include <limits>
#include <utility>

#include "core/base/counted.h"

namespace marey {

AnalysedClip::AnalysedClip(const Clip& clip, const AnalysisRequest& request, BodyMotion body)
    : clip_(clip), request_(request), body_(std::move(body)) {
  gravity_ = find_gravity(request.model ? request.model->gravity_mps2 : std::nullopt, clip.settings.up_axis);
}

SettledSupport AnalysedClip::settle_support() const {
  const Skeleton& skeleton = clip_.skeleton;
  SettledSupport support{request_.support, false, apply_own_contacts(find_contacts(body_, skeleton, clip_.settings.up_axis), request_.contacts)};
  if (support.kind != SupportKind::Auto) return support;
  support.kind = roots_stand_still(body_, skeleton) ? SupportKind::Pivot : SupportKind::Ground;
  support.follows_contacts = support.kind == SupportKind::Ground;
  return support;
}

void AnalysedClip::find_mechanics() {
  support_ = request_.settled ? *request_.settled : settle_support();
  loads_.resize(idx(body_.frame_count) * idx(body_.joint_count));
  for (FrameIndex frame = 0; frame < body_.frame_count; ++frame) {
    states_.push_back(find_body_state(body_, *request_.model, gravity_, frame));
    find_frame_loads(frame);
  }
}

void AnalysedClip::find_frame_loads(FrameIndex frame) {
  const BodyModel& model = *request_.model;
  const std::span<JointLoad> loads = std::span(loads_).subspan(idx(frame) * idx(body_.joint_count), idx(body_.joint_count));
  GroundReaction reaction{glm::dvec3(0.0), glm::dvec3(std::numeric_limits<double>::quiet_NaN())};
  std::vector<OuterForce> outer;
  if (support_.is_ground(frame)) {
    reaction = find_ground_reaction(states_.back(), total_mass_kg(model), gravity_, clip_.settings.up_axis, support_.contacts.floor_m);
    outer = share_out(reaction, states_.back(), body_, support_.contacts, frame);
    shared_frames_ += outer.size() > 1 ? 1 : 0;
  }
  find_joint_loads(body_, clip_.skeleton, model, gravity_, frame, outer, loads);
  if (support_.kind == SupportKind::Pivot) {
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
  if (support_.kind == SupportKind::Pivot) {
    table.notes.emplace_back("Held at its root; the torque there is a residual, as a bar passes on next to none.");
  } else if (support_.kind == SupportKind::Flight) {
    table.notes.emplace_back("In flight; force and torque at the root are residuals.");
  } else if (shared_frames_ > 0) {
    table.notes.push_back(fmt::format("On the ground with more than one point in {}: how they share the reaction is an estimate.",
                                      counted(shared_frames_, "frame")));
  }
}

}  // namespace marey
