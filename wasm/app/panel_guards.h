#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "wasm/app/faults.h"
#include "wasm/app/view_context.h"

namespace marey::app {

/// Calls `draw`, which uses ImGui. When it throws, the windows, groups and styles that it has begun are ended, and what
/// it threw comes back.
[[nodiscard]] std::optional<Fault> draw_guarded(const std::function<void()>& draw);

/// Keeps what one panel throws from the others: a sentence stands in its place until the person has it tried again.
class PanelGuards {
 public:
  /// Draws a panel into the current window. `id` is the same in each frame, `name` is for people: "curve editor".
  void draw(ViewContext& context, std::string_view id, std::string_view name, const std::function<void()>& draw_panel);

  /// Sentences and details of the faults that have not been told yet; each is given once.
  struct Report {
    std::string sentence;
    std::string details;
  };
  [[nodiscard]] std::vector<Report> take_reports();

 private:
  void draw_fault(ViewContext& context, std::string_view id);

  std::map<std::string, Report, std::less<>> faults_;
  std::vector<Report> reports_;
};

}  // namespace marey::app
