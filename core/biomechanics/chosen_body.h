#pragma once

#include "core/biomechanics/body_guess.h"
#include "core/motion/clip.h"

namespace marey {

/// The body of a clip: its own unit of length, the table and mass that were chosen, and the masses that were typed in; what
/// has another mass than by the table keeps its shape, so inertia goes along.
struct ChosenBody {
  GuessedBody body;
  BodyTable table = BodyTable::Rods;  ///< the one that was taken
  double mass_kg = 0.0;               ///< of the whole body
};

/// Errors: those of guess_body(), where a table was chosen that the figure does not fit, or no bone has a length.
[[nodiscard]] Result<ChosenBody> find_chosen_body(const Clip& clip);
[[nodiscard]] Result<ChosenBody> find_chosen_body(const Skeleton& skeleton, const BodyChoice& choice, double metres_per_unit);

}  // namespace marey
