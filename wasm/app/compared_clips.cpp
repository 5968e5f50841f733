#include "wasm/app/compared_clips.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "wasm/app/widgets.h"

namespace marey::app {
namespace {

/// A body for another clip: that of the open one where the figures are the same, else its table, mass and gravity, else what the
/// other figure tells. Without masses the unit alone.
BodyModel model_beside(const Clip& open, const ChosenBody* body, const Clip& other) {
  if (open.skeleton == other.skeleton) {
    BodyModel model = body != nullptr ? body->body.model : BodyModel{};
    model.metres_per_unit = open.settings.metres_per_unit;
    return model;
  }
  BodyChoice choice;
  choice.table = open.body.table;
  if (body != nullptr) choice.mass_kg = body->mass_kg;
  if (open.body.gravity_mps2) {
    choice.gravity_mps2 = glm::dvec3(0.0);
    (*choice.gravity_mps2)[static_cast<int>(other.settings.up_axis)] = -glm::length(*open.body.gravity_mps2);
  }
  const double unit = other.settings.metres_per_unit;
  Result<ChosenBody> found = find_chosen_body(other.skeleton, choice, unit);
  if (!found) {
    choice.table.reset();
    found = find_chosen_body(other.skeleton, choice, unit);
  }
  if (found) return std::move(found->body.model);
  BodyModel without_masses;
  without_masses.metres_per_unit = unit;
  return without_masses;
}

AskedQuantity asked_of(const Skeleton& skeleton, const AnalysisPlot& plot) {
  if (!plot.problem.empty()) return {};
  const Quantity& quantity = *plot.choice.quantity;
  const NodeIndex node = plot.node == kNoParent ? kNoParent : find_owner(skeleton, quantity, plot.owner);
  if (plot.node != kNoParent && node == kNoParent) return {};
  const auto asked = ask_for(skeleton, quantity, node, plot.asked.point_m, plot.choice.frame);
  return asked ? *asked : AskedQuantity{};
}

bool asks_the_same_or_nothing(const AskedQuantity& a, const AskedQuantity& b) {
  if (a.quantity == nullptr || b.quantity == nullptr) return a.quantity == b.quantity;
  return asks_the_same(a, b);
}

}  // namespace

bool ComparedClips::is_same(const Answer& a, const Answer& b) {
  return a.other == b.other && a.model == b.model && a.support == b.support && a.derivation == b.derivation &&
         std::equal(a.asked.begin(), a.asked.end(), b.asked.begin(), b.asked.end(), asks_the_same_or_nothing);
}

void ComparedClips::compute(Answer& answer, const AnalysisRequest& usual) {
  const Clip& clip = answer.other->clip;
  AnalysisRequest request = usual;
  request.quantities.clear();
  request.contacts = clip.body.contacts;
  request.model = answer.model;
  answer.lines.resize(answer.asked.size());
  for (std::size_t i = 0; i < answer.asked.size(); ++i) {
    if (answer.asked[i].quantity == nullptr) continue;
    request.asked = {answer.asked[i]};
    const Result<AnalysisTable> table = analyse(clip, request);
    if (table) {
      answer.lines[i] = lines_of(*table, answer.asked[i]);
      continue;
    }
    std::string note = fmt::format("{}: {}", ui::displayable(answer.other->file_name), table.error().message);
    if (std::find(answer.notes.begin(), answer.notes.end(), note) == answer.notes.end()) answer.notes.push_back(std::move(note));
  }
}

void ComparedClips::add_to(std::vector<AnalysisPlot>& plots, const Session& session, const AnalysisRequest& request, const ChosenBody* body,
                           std::vector<std::string>& notes) {
  const Clip& open = session.document.clip();
  answers_.resize(session.others.size());
  for (std::size_t other = 0; other < answers_.size(); ++other) {
    Answer wanted;
    wanted.other = session.others[other];
    const Clip& clip = wanted.other->clip;
    wanted.model = model_beside(open, body, clip);
    wanted.support = request.support;
    wanted.derivation = request.derivation;
    for (const AnalysisPlot& plot : plots) wanted.asked.push_back(asked_of(clip.skeleton, plot));
    if (!is_same(answers_[other], wanted)) {
      compute(wanted, request);
      answers_[other] = std::move(wanted);
    }
    const Answer& answer = answers_[other];
    notes.insert(notes.end(), answer.notes.begin(), answer.notes.end());
    const double frames_per_frame = open.motion.frame_time_s() / clip.motion.frame_time_s();
    for (std::size_t i = 0; i < plots.size(); ++i) {
      OtherLines lines{answer.lines[i], answer.lines[i], clip.motion.frame_time_s()};
      for (PlotLine& line : lines.lines) line.values = at_other_times(line.values, frames_per_frame, open.motion.frame_count());
      plots[i].others.push_back(std::move(lines));
    }
  }
}

}  // namespace marey::app
