#include "core/biomechanics/own_segments.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <set>

#include "core/biomechanics/chosen_body.h"

namespace marey {
namespace {

OwnSegment* find_own(BodyChoice& body, JointIndex joint) {
  const auto own = std::find_if(body.segments.begin(), body.segments.end(), [&](const OwnSegment& s) { return s.joint == joint; });
  return own == body.segments.end() ? nullptr : &*own;
}

void scale_mass(OwnSegment& own, double factor) {
  own.mass_kg *= factor;
  if (!own.shape) return;
  for (double& moment : own.shape->inertia_kgm2) moment *= factor;
}

double mass_of(const Clip& clip, const BodyChoice& body, JointIndex joint) {
  const Result<ChosenBody> chosen = find_chosen_body(clip.skeleton, body, clip.settings.metres_per_unit);
  const auto whole = chosen ? find_whole_segment(chosen->body.model, joint) : std::nullopt;
  return whole ? whole->mass_kg : 0.0;
}

}  // namespace

OwnSegment make_own_segment(const Segment& segment) {
  return {segment.joint, segment.mass_kg, OwnShape{segment.com_m, moments_of(segment.inertia_kgm2)}};
}

OwnSegment make_own_rod(const Clip& clip, JointIndex joint, double mass_kg) {
  const NodeIndex node = clip.skeleton.node_of(joint);
  glm::dvec3 end(0.0);
  for (NodeIndex child = node + 1; child < clip.skeleton.node_count(); ++child) {
    if (clip.skeleton.node(child).parent != node) continue;
    end = clip.settings.metres_per_unit * clip.skeleton.node(child).offset;
    break;
  }
  const glm::dmat3 inertia = mass_kg / 12.0 * (glm::dmat3(glm::dot(end, end)) - glm::outerProduct(end, end));
  return make_own_segment({joint, mass_kg, 0.5 * end, inertia});
}

void put_own_segment(BodyChoice& body, const OwnSegment& segment) {
  if (OwnSegment* own = find_own(body, segment.joint)) {
    *own = segment;
    return;
  }
  const auto behind = std::find_if(body.segments.begin(), body.segments.end(), [&](const OwnSegment& s) { return s.joint > segment.joint; });
  body.segments.insert(behind, segment);
}

BodyChoice with_segment_mass(const Clip& clip, JointIndex joint, double mass_kg) {
  BodyChoice body = clip.body;
  OwnSegment* own = find_own(body, joint);
  if (own != nullptr && own->shape && own->mass_kg > 0.0) {
    scale_mass(*own, mass_kg / own->mass_kg);
    own->mass_kg = mass_kg;
    return body;
  }
  BodyChoice by_table = clip.body;
  std::erase_if(by_table.segments, [&](const OwnSegment& segment) { return segment.joint == joint; });
  put_own_segment(body, mass_of(clip, by_table, joint) > 0.0 ? OwnSegment{joint, mass_kg, {}} : make_own_rod(clip, joint, mass_kg));
  return body;
}

BodyChoice with_body_mass(const Clip& clip, double mass_kg) {
  BodyChoice body = clip.body;
  if (body.segments.empty()) {
    body.mass_kg = mass_kg;
    return body;
  }
  const Result<ChosenBody> present = find_chosen_body(clip);
  if (!present) return body;
  const double factor = mass_kg / present->mass_kg;
  if (present->table) body.mass_kg = factor * body.mass_kg.value_or(usual_mass_kg(*present->table));
  for (OwnSegment& own : body.segments) scale_mass(own, factor);
  return body;
}

BodyChoice choose_model(const BodyChoice& present, const BodyModel& model) {
  BodyChoice choice = present;
  choice.table.reset();
  choice.mass_kg.reset();
  choice.is_only_own = true;
  choice.gravity_mps2 = model.gravity_mps2;
  choice.segments.clear();
  std::set<JointIndex> joints;
  for (const Segment& segment : model.segments) joints.insert(segment.joint);
  for (const JointIndex joint : joints) choice.segments.push_back(make_own_segment(*find_whole_segment(model, joint)));
  return choice;
}

}  // namespace marey
