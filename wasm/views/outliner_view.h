#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "wasm/app/view_context.h"

namespace marey::app {

/// The tree of joints with search, folding, selection in both directions and the visibility of each joint's curves.
/// Click selects, Ctrl toggles, Shift selects a run; arrow keys walk and fold.
class OutlinerView {
 public:
  void draw(ViewContext& context);

  /// Call when another document has been opened: everything unfolds.
  void document_opened();

 private:
  struct Row {
    JointIndex joint = 0;
    bool has_children = false;
    bool matches = true;  ///< of the search; parents of matches are shown dimmed
  };

  void follow_clip(const ViewContext& context);
  void collect_rows(const Skeleton& skeleton);
  void collect_matches(const Skeleton& skeleton);
  void draw_rows(ViewContext& context);
  void draw_row(ViewContext& context, const Row& row);
  void draw_row_content(ViewContext& context, const Row& row, ImVec2 min, ImVec2 max, bool hovered);
  void draw_fold_button(ViewContext& context, const Row& row, ImVec2 min, float height);
  void draw_eye_button(ViewContext& context, JointIndex joint, ImVec2 max, float height);
  void fold(JointIndex joint, bool folded);
  void click(ViewContext& context, JointIndex joint);
  void handle_keys(ViewContext& context);
  void scroll_to_active(ViewContext& context, float row_height);

  std::string search_;
  std::vector<bool> folded_;
  std::vector<bool> kept_;  ///< by the search: matches and their ancestors
  std::vector<Row> rows_;   ///< what is unfolded and found, in file order
  JointIndex shown_active_ = kNoParent;

  // What rows_ was collected from.
  bool rows_stale_ = true;
  std::uint64_t rows_of_clip_ = 0;
  int rows_of_joints_ = 0;
  CharacterSet rows_names_in_ = CharacterSet::Utf8;
  std::string rows_search_;
};

}  // namespace marey::app
