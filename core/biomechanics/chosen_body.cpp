#include "core/biomechanics/chosen_body.h"

#include <utility>

namespace marey {
namespace {

void give_mass(GuessedBody& body, const OwnMass& own) {
  double present_kg = 0.0;
  for (const Segment& segment : body.model.segments) present_kg += segment.joint == own.joint ? segment.mass_kg : 0.0;
  if (!(present_kg > 0.0)) return;
  const double factor = own.mass_kg / present_kg;
  for (Segment& segment : body.model.segments) {
    if (segment.joint != own.joint) continue;
    segment.mass_kg *= factor;
    segment.inertia_kgm2 *= factor;
  }
  for (GuessedPart& part : body.parts) part.mass_kg *= part.joint == own.joint ? factor : 1.0;
}

}  // namespace

Result<ChosenBody> find_chosen_body(const Skeleton& skeleton, const BodyChoice& choice, double metres_per_unit) {
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
  for (const OwnMass& own : choice.own) give_mass(*body, own);
  const double mass_kg = total_mass_kg(body->model);
  return ChosenBody{std::move(*body), table, mass_kg};
}

Result<ChosenBody> find_chosen_body(const Clip& clip) {
  return find_chosen_body(clip.skeleton, clip.body, clip.settings.metres_per_unit);
}

}  // namespace marey
