#include "wasm/views/outliner_view.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/text/utf8.h"
#include "wasm/app/icons.h"
#include "wasm/app/widgets.h"

namespace marey::app {
namespace {

constexpr float kRowHeight = 24.0f;
constexpr float kTouchRowHeight = 40.0f;
constexpr float kIndent = 14.0f;
constexpr float kFoldWidth = 18.0f;
constexpr float kEyeWidth = 24.0f;
// Deep chains stop moving right, so that their names stay on screen.
constexpr int kMostIndents = 12;

bool contains_ignoring_case(const std::string& text, const std::string& part) {
  return in_small_letters(text).find(in_small_letters(part)) != std::string::npos;
}

float row_height(const ViewContext& context) { return context.options.touch ? kTouchRowHeight : kRowHeight; }

bool shows_curves(const Selection& selection, const Skeleton& skeleton, JointIndex joint) {
  const ChannelIndex first = skeleton.first_channel(joint);
  for (int i = 0; i < skeleton.channel_count(joint); ++i) {
    if (selection.is_channel_visible(first + i)) return true;
  }
  return false;
}

void set_curves_shown(Selection& selection, const Skeleton& skeleton, JointIndex joint, bool shown) {
  const ChannelIndex first = skeleton.first_channel(joint);
  for (int i = 0; i < skeleton.channel_count(joint); ++i) selection.set_channel_visible(first + i, shown);
}

}  // namespace

void OutlinerView::document_opened() {
  search_.clear();
  folded_.clear();
  rows_stale_ = true;
  shown_active_ = kNoParent;
}

void OutlinerView::collect_matches(const Skeleton& skeleton) {
  kept_.assign(idx(skeleton.joint_count()), search_.empty());
  if (search_.empty()) return;
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    if (!contains_ignoring_case(skeleton.name(joint), search_)) continue;
    for (JointIndex up = joint; up != kNoParent && !kept_[idx(up)]; up = skeleton.parent(up)) kept_[idx(up)] = true;
  }
}

void OutlinerView::collect_rows(const Skeleton& skeleton) {
  folded_.resize(idx(skeleton.joint_count()), false);
  collect_matches(skeleton);
  rows_.clear();
  for (JointIndex joint = 0; joint < skeleton.joint_count();) {
    const bool has_children = skeleton.subtree_end(joint) > joint + 1;
    if (kept_[idx(joint)]) {
      rows_.push_back({joint, has_children, search_.empty() || contains_ignoring_case(skeleton.name(joint), search_)});
    }
    // A search looks into folded branches.
    const bool skip = search_.empty() && folded_[idx(joint)];
    joint = skip ? skeleton.subtree_end(joint) : joint + 1;
  }
}

// Rows are collected anew when what they depend on has changed, not in each frame.
void OutlinerView::follow_clip(const ViewContext& context) {
  const Document& document = context.session.document;
  const CharacterSet names_in = document.settings().names_in;
  const int joints = document.skeleton().joint_count();
  const bool same_clip = rows_of_clip_ == context.clip_serial && rows_of_joints_ == joints && rows_names_in_ == names_in;
  if (!rows_stale_ && same_clip && rows_search_ == search_) return;
  rows_stale_ = false;
  rows_of_joints_ = joints;
  rows_of_clip_ = context.clip_serial;
  rows_names_in_ = names_in;
  rows_search_ = search_;
  collect_rows(document.skeleton());
}

void OutlinerView::click(ViewContext& context, JointIndex joint) {
  Selection& selection = context.session.selection;
  if (ImGui::GetIO().KeyShift) {
    selection.select_through(joint);
  } else if (ImGui::GetIO().KeyCtrl) {
    selection.toggle(joint);
  } else {
    selection.select_only(joint);
  }
  shown_active_ = selection.active_joint();
}

void OutlinerView::fold(JointIndex joint, bool folded) {
  folded_[idx(joint)] = folded;
  rows_stale_ = true;
}

void OutlinerView::draw_fold_button(ViewContext& context, const Row& row, ImVec2 min, float height) {
  if (!row.has_children || !search_.empty()) return;
  ImGui::SetCursorScreenPos(min);
  const SmallText id("outliner.fold.{}", row.joint);
  const bool pressed = ImGui::InvisibleButton(id.c_str(), {kFoldWidth, height});
  context.items.add_last(id, "Fold");
  if (pressed) fold(row.joint, !folded_[idx(row.joint)]);
  const char* icon = folded_[idx(row.joint)] ? icons::kChevronRight : icons::kChevronDown;
  const ImU32 color = ImGui::IsItemHovered() ? context.theme.text : context.theme.dim_text;
  ImGui::GetWindowDrawList()->AddText({min.x + 2.0f, min.y + 0.5f * (height - ImGui::GetFontSize())}, color, icon);
}

void OutlinerView::draw_eye_button(ViewContext& context, JointIndex joint, ImVec2 max, float height) {
  const Skeleton& skeleton = context.session.document.skeleton();
  Selection& selection = context.session.selection;
  if (skeleton.channel_count(joint) == 0) return;
  const bool shown = shows_curves(selection, skeleton, joint);
  ImGui::SetCursorScreenPos({max.x - kEyeWidth, max.y - height});
  const SmallText id("outliner.curves.{}", joint);
  if (ImGui::InvisibleButton(id.c_str(), {kEyeWidth, height})) set_curves_shown(selection, skeleton, joint, !shown);
  context.items.add_last(id, "Show curves");
  ui::tool_tip(context, "Curves of this joint", shown ? "Click to hide them." : "Click to show them.");
  ImGui::GetWindowDrawList()->AddText({max.x - kEyeWidth + 4.0f, max.y - 0.5f * (height + ImGui::GetFontSize())},
                                      ImGui::IsItemHovered() ? context.theme.text : context.theme.dim_text,
                                      shown ? icons::kEye : icons::kEyeOff);
}

void OutlinerView::draw_row_content(ViewContext& context, const Row& row, ImVec2 min, ImVec2 max, bool hovered) {
  const Skeleton& skeleton = context.session.document.skeleton();
  const Selection& selection = context.session.selection;
  const bool selected = selection.contains(row.joint);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (selected) list.AddRectFilled(min, max, with_alpha(context.theme.selection, 0.18f));
  if (hovered || context.hover.joint == row.joint) list.AddRectFilled(min, max, with_alpha(context.theme.hovered, 0.7f));
  if (row.joint == selection.active_joint()) {
    list.AddRectFilled(min, {min.x + 2.0f, max.y}, context.theme.selection);
  }
  const float indent = kIndent * static_cast<float>(std::min(skeleton.depth(row.joint), kMostIndents));
  const float text_x = min.x + 6.0f + indent + kFoldWidth;
  const bool tail = hovered || !shows_curves(selection, skeleton, row.joint);
  ImGui::SetCursorScreenPos({text_x, min.y + 0.5f * (max.y - min.y - ImGui::GetFontSize())});
  const ImU32 color = selected ? context.theme.text : with_alpha(context.theme.text, row.matches ? 0.92f : 0.5f);
  ui::elided_text(context, skeleton.name(row.joint), max.x - text_x - (tail ? kEyeWidth : 6.0f), color);
}

void OutlinerView::draw_row(ViewContext& context, const Row& row) {
  const float height = row_height(context);
  const Skeleton& skeleton = context.session.document.skeleton();
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 max{min.x + ImGui::GetContentRegionAvail().x, min.y + height};
  const bool hovered = ImGui::IsMouseHoveringRect(min, max) && ImGui::IsWindowHovered();
  if (hovered) context.next_hover.joint = row.joint;
  draw_row_content(context, row, min, max, hovered);
  // The small buttons come first: of items over one another the first takes the click, also of a tap without a hover.
  const float indent = kIndent * static_cast<float>(std::min(skeleton.depth(row.joint), kMostIndents));
  draw_fold_button(context, row, {min.x + 6.0f + indent, min.y}, height);
  if (hovered || !shows_curves(context.session.selection, skeleton, row.joint)) {
    draw_eye_button(context, row.joint, max, height);
  }
  ImGui::SetCursorScreenPos(min);
  const SmallText id("outliner.joint.{}", row.joint);
  if (ImGui::InvisibleButton(id.c_str(), {max.x - min.x, height})) click(context, row.joint);
  context.items.add_last(id, skeleton.name(row.joint));
}

void OutlinerView::handle_keys(ViewContext& context) {
  Selection& selection = context.session.selection;
  if (!ImGui::IsWindowFocused() || ImGui::GetIO().WantTextInput || rows_.empty()) return;
  const auto active = std::find_if(rows_.begin(), rows_.end(),
                                   [&](const Row& row) { return row.joint == selection.active_joint(); });
  const auto last = std::prev(rows_.end());
  if (ImGui::IsKeyPressed(ImGuiKey_DownArrow)) {
    selection.select_only(active == rows_.end() || active == last ? last->joint : std::next(active)->joint);
  }
  if (ImGui::IsKeyPressed(ImGuiKey_UpArrow)) {
    const bool first = active == rows_.end() || active == rows_.begin();
    selection.select_only(first ? rows_.front().joint : std::prev(active)->joint);
  }
  if (active == rows_.end()) return;
  if (ImGui::IsKeyPressed(ImGuiKey_LeftArrow) && active->has_children) fold(active->joint, true);
  if (ImGui::IsKeyPressed(ImGuiKey_RightArrow) && active->has_children) fold(active->joint, false);
}

void OutlinerView::scroll_to_active(ViewContext& context, float height) {
  const JointIndex active = context.session.selection.active_joint();
  if (active == shown_active_) return;
  shown_active_ = active;
  const auto row = std::find_if(rows_.begin(), rows_.end(), [&](const Row& r) { return r.joint == active; });
  if (row == rows_.end()) return;
  const float top = height * static_cast<float>(row - rows_.begin());
  const float seen = ImGui::GetWindowHeight();
  if (top < ImGui::GetScrollY() || top + height > ImGui::GetScrollY() + seen) ImGui::SetScrollY(top - 0.4f * seen);
}

void OutlinerView::draw_rows(ViewContext& context) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0f, 0.0f});
  const float height = row_height(context);
  scroll_to_active(context, height);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(rows_.size()), height);
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) draw_row(context, rows_[idx(i)]);
  }
  const ImVec2 left = ImGui::GetContentRegionAvail();
  if (left.x > 0.0f && left.y > 0.0f && ImGui::InvisibleButton("outliner.empty", left)) {
    context.session.selection.clear_joints();
  }
  handle_keys(context);
  ImGui::PopStyleVar();
}

void OutlinerView::draw(ViewContext& context) {
  ui::panel_title(context, "Joints");
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 8.0f);
  ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x - 8.0f);
  ui::search_field(context, "outliner.search", "Find a joint", search_);
  ImGui::PopItemWidth();
  const Skeleton& skeleton = context.session.document.skeleton();
  follow_clip(context);
  ImGui::Dummy({0.0f, 2.0f});
  ImGui::BeginChild("outliner.rows");
  if (rows_.empty() && skeleton.joint_count() > 0) {
    ImGui::SetCursorPos({12.0f, 12.0f});
    ui::dim_text(context, "No joint has this in its name.");
  } else {
    draw_rows(context);
  }
  ImGui::EndChild();
}

}  // namespace marey::app
