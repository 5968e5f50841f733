#pragma once

#include <optional>
#include <string>

#include "core/biomechanics/body_guess.h"
#include "core/motion/clip.h"

namespace marey {

/// The body of a clip: its own unit of length, the table and mass that were chosen, and the segments that were typed in or came
/// with a model.
struct ChosenBody {
  GuessedBody body;
  std::optional<BodyTable> table;  ///< the one that was taken; none where all values are people's own
  int own_count = 0;               ///< segments that are people's own, wholly or by their mass
  double mass_kg = 0.0;            ///< of the whole body
};

/// "deleva-male", "deleva-male and own values of 2 segments", "own values of 3 segments".
[[nodiscard]] std::string describe_source(const ChosenBody& body);

/// Errors: those of guess_body(), where a table was chosen that the figure does not fit, or no bone has a length; InvalidArgument
/// where only own values count and no segment has a mass.
[[nodiscard]] Result<ChosenBody> find_chosen_body(const Clip& clip);
[[nodiscard]] Result<ChosenBody> find_chosen_body(const Skeleton& skeleton, const BodyChoice& choice, double metres_per_unit);

}  // namespace marey
