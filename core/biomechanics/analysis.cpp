#include "core/biomechanics/analysis.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/biomechanics/analysis_columns.h"
#include "core/biomechanics/rate_check.h"

namespace marey {
namespace {

Error refusal(std::string message) { return {DiagnosticCode::InvalidArgument, {}, std::move(message), {}, {}}; }

/// Of what was asked for: poses need no rate.
std::string rate_warning(const BodyMotion& body, std::span<const AskedQuantity> asked) {
  const auto needs = [&](DerivativeLevel level) {
    return std::any_of(asked.begin(), asked.end(), [&](const AskedQuantity& a) { return a.quantity->level == level; });
  };
  const bool accelerations = needs(DerivativeLevel::Acceleration);
  if (!accelerations && !needs(DerivativeLevel::Velocity)) return {};
  return describe_rate(check_rate(body), body.frame_time_s, accelerations);
}

}  // namespace

Result<AnalysisTable> analyse(const Clip& clip, const AnalysisRequest& request) {
  Result<std::vector<AskedQuantity>> asked = find_quantities(clip.skeleton, request.quantities);
  if (!asked) return asked.error();
  asked->insert(asked->end(), request.asked.begin(), request.asked.end());
  const auto needs_body = std::find_if(asked->begin(), asked->end(), [](const AskedQuantity& a) { return a.quantity->needs_body; });
  if (needs_body != asked->end()) {
    if (!request.model) {
      return refusal(fmt::format("'{}' needs the masses of the segments; give a model of the body, or a table to make one by.",
                                 needs_body->quantity->name));
    }
    if (Status status = check_body_model(*request.model, clip.skeleton); !status) return status.error();
  }
  const bool has_unit = request.model && request.model->metres_per_unit;
  const double unit = has_unit ? *request.model->metres_per_unit : clip.settings.metres_per_unit;
  const double frame_time = request.frame_time_s.value_or(clip.motion.frame_time_s());
  if (!(frame_time > 0.0)) return refusal("The clip has no frame time; give one.");
  Result<BodyMotion> body = find_body_motion(clip, request.derivation, frame_time, unit);
  if (!body) return body.error();
  AnalysedClip analysed(clip, request, std::move(*body));
  if (std::any_of(asked->begin(), asked->end(), needs_poses)) {
    analysed.find_poses(std::any_of(asked->begin(), asked->end(), needs_rotations));
  }
  if (needs_body != asked->end()) analysed.find_mechanics();
  AnalysisTable table;
  for (const AskedQuantity& quantity : *asked) add_analysis_columns(analysed, quantity, table);
  analysed.add_notes(table);
  if (std::string warning = rate_warning(analysed.body(), *asked); !warning.empty()) table.notes.push_back(std::move(warning));
  if (needs_body != asked->end()) table.support = analysed.support();
  return table;
}

}  // namespace marey
