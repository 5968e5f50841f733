#pragma once

#include <string>
#include <vector>

#include "core/base/diagnostic_code.h"
#include "wasm/app/view_context.h"

namespace marey::app {

/// One entry of the Problems panel: a sign, a sentence, and dim lines below it.
struct ProblemEntry {
  std::string id;
  Severity severity = Severity::Note;
  std::string message;
  std::vector<std::string> details;
  std::string click_help;  ///< what a click does; empty when it does nothing
};

/// Draws the entry over the width of the panel. True when it was clicked or activated by key.
bool draw_problem_entry(ViewContext& context, const ProblemEntry& entry);

/// The line that ends an entry and whatever stands below it.
void end_problem_entry(const ViewContext& context);

}  // namespace marey::app
