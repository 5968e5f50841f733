#pragma once

#include <cstdint>

#include "wasm/app/view_context.h"
#include "wasm/views/problems/lint_section.h"
#include "wasm/views/problems/reading_choices.h"

namespace marey::app {

/// The report of how the open file was read: one entry per finding with its severity, sentence, place and count; a click
/// shows the place in the text. Where the file could be read in another way, the ways stand below as cards. Then what the
/// linter finds, and what was assumed.
class ProblemsView {
 public:
  void draw(ViewContext& context);

 private:
  void draw_entry(ViewContext& context, const Diagnostic& diagnostic, int index);
  void draw_excerpt(ViewContext& context, int index) const;

  ReadingChoices choices_;
  LintSection lint_;
  int unfolded_ = -1;
  std::uint64_t clip_serial_ = 0;  ///< of the clip that `unfolded_` belongs to
};

}  // namespace marey::app
