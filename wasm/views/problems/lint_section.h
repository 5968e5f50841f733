#pragma once

#include <cstdint>

#include "core/lint/lint.h"
#include "wasm/app/view_context.h"
#include "wasm/views/problems/reading_choices.h"

namespace marey::app {

/// What the linter finds in the figure and its motion, each with a suggestion and the programs that stumble over it; a click
/// goes to the place. Looks again after every edit, in long clips when asked to.
class LintSection {
 public:
  /// Looks through the clip where that is due.
  void update(const ViewContext& context);
  void draw(ViewContext& context, ReadingChoices& choices);
  [[nodiscard]] bool empty() const { return report_.findings.empty(); }

 private:
  void look(const ViewContext& context);
  void draw_finding(ViewContext& context, const Finding& finding, int index) const;
  void draw_left_out(ViewContext& context) const;

  LintReport report_;
  std::uint64_t clip_serial_ = 0;
  std::uint64_t revision_ = 0;
  bool is_stale_ = false;  ///< the clip has changed since
};

}  // namespace marey::app
