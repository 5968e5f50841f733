#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/editing/recipe.h"

namespace marey::cli {

/// Reads a recipe: [{"do": "smooth", "sigma": 2, "joints": ["Left*"], "frames": [10, 60]}, ...]. Values are texts, numbers,
/// true and false, or lists of them; a list of two numbers is a range or a pair of frames. A refusal names the step, or the
/// place where the text is no JSON.
[[nodiscard]] Result<std::vector<RecipeStep>> read_recipe(std::string_view json_text);

/// {"operations": [...]}: the table of operations, as `marey edit --list --json` prints it.
[[nodiscard]] std::string operations_json();

/// What was done to a clip by one step.
struct StepReport {
  std::string operation;
  bool changed = false;
  std::string name;  ///< as the Edit menu would call it
  std::vector<std::string> notes;
};

/// {"steps": [...]}: what `marey edit --json` prints.
[[nodiscard]] std::string steps_json(const std::vector<StepReport>& steps);

}  // namespace marey::cli
