#include "core/biomechanics/chosen_body.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/base/counted.h"

namespace marey {
namespace {

// What the table gave keeps its shape, so inertia goes along.
bool give_mass(GuessedBody& body, const OwnSegment& own) {
  double present_kg = 0.0;
  for (const Segment& segment : body.model.segments) present_kg += segment.joint == own.joint ? segment.mass_kg : 0.0;
  if (!(present_kg > 0.0)) return false;
  const double factor = own.mass_kg / present_kg;
  for (Segment& segment : body.model.segments) {
    if (segment.joint != own.joint) continue;
    segment.mass_kg *= factor;
    segment.inertia_kgm2 *= factor;
  }
  for (GuessedPart& part : body.parts) part.mass_kg *= part.joint == own.joint ? factor : 1.0;
  return true;
}

// Whether it tells something: a mass without a shape needs a segment of the table.
bool give_segment(GuessedBody& body, const OwnSegment& own) {
  if (!own.shape) return give_mass(body, own);
  const auto same = std::find_if(body.parts.begin(), body.parts.end(), [&](const GuessedPart& part) { return part.joint == own.joint; });
  GuessedPart part{own.joint, same == body.parts.end() ? std::string("own segment") : same->name, own.mass_kg};
  std::erase_if(body.model.segments, [&](const Segment& segment) { return segment.joint == own.joint; });
  std::erase_if(body.parts, [&](const GuessedPart& p) { return p.joint == own.joint; });
  body.model.segments.push_back({own.joint, own.mass_kg, own.shape->com_m, symmetric_tensor(own.shape->inertia_kgm2)});
  const auto behind = std::find_if(body.parts.begin(), body.parts.end(), [&](const GuessedPart& p) { return p.joint > own.joint; });
  body.parts.insert(behind, std::move(part));
  return true;
}

Result<ChosenBody> find_own_body(const BodyChoice& choice, double metres_per_unit) {
  ChosenBody chosen;
  for (const OwnSegment& own : choice.segments) chosen.own_count += give_segment(chosen.body, own) ? 1 : 0;
  chosen.body.model.metres_per_unit = metres_per_unit;
  if (total_mass_kg(chosen.body.model) > 0.0) return chosen;
  return Error{DiagnosticCode::InvalidArgument, {}, "No segment has a mass. Give one to a joint, open a model, or choose a table.", {}, {}};
}

Result<ChosenBody> find_table_body(const Skeleton& skeleton, const BodyChoice& choice, double metres_per_unit) {
  const auto guess = [&](BodyTable table) {
    return guess_body(skeleton, table, choice.mass_kg.value_or(usual_mass_kg(table)), metres_per_unit, choice.parts);
  };
  BodyTable table = choice.table.value_or(BodyTable::DeLevaMale);
  Result<GuessedBody> body = guess(table);
  if (!body && !choice.table) {
    table = BodyTable::Rods;
    body = guess(table);
  }
  if (!body) return body.error();
  ChosenBody chosen;
  chosen.body = std::move(*body);
  chosen.table = table;
  for (const OwnSegment& own : choice.segments) chosen.own_count += give_segment(chosen.body, own) ? 1 : 0;
  return chosen;
}

}  // namespace

std::string describe_source(const ChosenBody& body) {
  const std::string own = body.own_count == 0 ? std::string() : fmt::format("own values of {}", counted(body.own_count, "segment"));
  if (!body.table) return own;
  return fmt::format("{}{}{}", body_table_name(*body.table), own.empty() ? "" : " and ", own);
}

Result<ChosenBody> find_chosen_body(const Skeleton& skeleton, const BodyChoice& choice, double metres_per_unit) {
  Result<ChosenBody> chosen = choice.is_only_own ? find_own_body(choice, metres_per_unit) : find_table_body(skeleton, choice, metres_per_unit);
  if (!chosen) return chosen;
  chosen->body.model.gravity_mps2 = choice.gravity_mps2;
  chosen->mass_kg = total_mass_kg(chosen->body.model);
  return chosen;
}

Result<ChosenBody> find_chosen_body(const Clip& clip) {
  return find_chosen_body(clip.skeleton, clip.body, clip.settings.metres_per_unit);
}

}  // namespace marey
