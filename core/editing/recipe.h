#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/editing/operation.h"

namespace marey {

/// NAME=VALUE of a step, as it was written.
struct RecipeWord {
  std::string name;
  std::string value;
  int column = 0;  ///< where it stands in the step, from 1; 0 if nobody knows
};

/// One operation as people write it: "smooth sigma=2 joints=Left* frames=10:60".
struct RecipeStep {
  std::string operation;
  std::vector<RecipeWord> words;
};

/// Takes a step apart at its blanks; a value with blanks stands in single or double quotes. Error InvalidArgument with
/// the place: a word without '=', a quote that is not closed, no word at all.
[[nodiscard]] Result<RecipeStep> parse_recipe_step(std::string_view text);

/// A step that is ready to be made.
struct BoundStep {
  const Operation* operation = nullptr;
  OperationTarget target;
  OperationValues values;  ///< values.other is still to be set where `other_file` names a file
  std::string other_file;  ///< of the parameter of kind File; "" where there is none
};

/// Finds the operation and its parameters, and in a clip the target. Beside the parameters a step may say
///   joints=Left*,Hips     names or patterns ('*', '?'), apart by commas; all by default
///   channels=Zrotation    names or patterns of channels, alone or with their joint ("LeftArm Zrotation"); all by default
///   frames=10:60          from 1, both included; a side may be left out: 10: is all from 10 on
///   blend-in=5 blend-out=5  frames
///   weight=0.5            0 to 1
/// Error InvalidArgument: a word that nobody knows, stands twice or has a value that does not fit. `place` is its column,
/// `expected` what could stand there, `found` the word; the message says all that, and the nearest known name.
[[nodiscard]] Result<BoundStep> bind_step(const RecipeStep& step, const Clip& clip);

/// The words that every step may have beside its parameters.
[[nodiscard]] std::span<const std::string_view> target_words();

}  // namespace marey
