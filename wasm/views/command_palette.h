#pragma once

#include <string>
#include <vector>

#include "wasm/app/view_context.h"

namespace marey::app {

/// Finds a command by typing a part of its name. Up and down choose, Enter runs, Escape closes; a command that cannot
/// run says why.
class CommandPalette {
 public:
  /// `open` becomes false when the palette is to be closed.
  void draw(ViewContext& context, bool& open);

 private:
  struct Entry {
    const Command* command = nullptr;
    int score = 0;
    std::vector<int> positions;  ///< matched bytes of the label
  };

  void collect(const CommandRegistry& registry);
  void draw_query(ViewContext& context);
  void draw_entries(ViewContext& context, bool& open);
  bool draw_entry(ViewContext& context, const Entry& entry, bool chosen);
  void follow_keys();

  std::string query_;
  std::vector<Entry> entries_;
  int chosen_ = 0;
  bool scroll_to_chosen_ = false;
  bool entered_ = false;
};

}  // namespace marey::app
