#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/biomechanics/body_model.h"
#include "core/biomechanics/body_names.h"
#include "core/biomechanics/body_tables.h"

namespace marey {

/// What a joint of a guessed body carries.
struct GuessedPart {
  JointIndex joint = 0;
  std::string name;  ///< "left upper arm", "trunk", "bone"
  double mass_kg = 0.0;
};

/// Masses for a figure, with what they rest on.
struct GuessedBody {
  BodyModel model;
  std::vector<GuessedPart> parts;
  std::vector<std::string> notes;  ///< parts that no joint was found for, masses that were spread
};

/// Kilograms of the average subject of a table; 70 for rods.
[[nodiscard]] double usual_mass_kg(BodyTable table);

/// Masses by the names of joints and the lengths of the bones in the rest pose. A trunk of three joints and more bends in three
/// pieces, one of two in two, else it is one. A part that no joint carries hangs on the one before it (a head without a neck on
/// the trunk); what cannot be placed is spread over the others, and told. Rods go with any figure.
/// `own` is what people say of joints in place of their names. Errors: InvalidArgument where names and people do not tell a human
/// body, or no bone has a length.
[[nodiscard]] Result<GuessedBody> guess_body(const Skeleton& skeleton, BodyTable table, double mass_kg, double metres_per_unit,
                                             std::span<const OwnPart> own = {});

}  // namespace marey
