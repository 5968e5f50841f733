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

Result<GuessedBody> guess(const Clip& clip, BodyTable table) {
  const double mass_kg = clip.body.mass_kg.value_or(usual_mass_kg(table));
  return guess_body(clip.skeleton, table, mass_kg, clip.settings.metres_per_unit);
}

}  // namespace

Result<ChosenBody> find_chosen_body(const Clip& clip) {
  BodyTable table = clip.body.table.value_or(BodyTable::DeLevaMale);
  Result<GuessedBody> body = guess(clip, table);
  if (!body && !clip.body.table) {
    table = BodyTable::Rods;
    body = guess(clip, table);
  }
  if (!body) return body.error();
  for (const OwnMass& own : clip.body.own) give_mass(*body, own);
  const double mass_kg = total_mass_kg(body->model);
  return ChosenBody{std::move(*body), table, mass_kg};
}

}  // namespace marey
