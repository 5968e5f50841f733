#pragma once

#include "wasm/app/view_context.h"
#include "wasm/app/workspace.h"

namespace marey::app {

/// What touches the floor, a row for each point on the frames of the plots below. A click on a bar, or a drag over frames, asks
/// what is to hold there: contact, none, or what the motion tells.
class ContactStrip {
 public:
  /// Draws as many rows as there is room for; returns the height taken, 0 without contacts.
  float draw(ViewContext& context, ImVec2 min, ImVec2 max);

 private:
  void draw_row(ViewContext& context, const ContactRow& row, int index, ImVec2 min, ImVec2 max);
  void handle_row(ViewContext& context, const ContactRow& row, int index, ImVec2 min, ImVec2 max);
  void draw_menu(ViewContext& context) const;

  bool asks_ = false;  // the menu is to be opened
  FrameIndex dragged_from_ = 0;
  NodeIndex asked_node_ = kNoParent;
  FrameRange asked_frames_;
};

/// The frames that commands on contacts are about: those of the selected samples, else the range of playback where it is not the
/// whole clip, else the shown frame.
[[nodiscard]] FrameRange contact_frames(const Session& session);

/// Commands that correct the contacts of the selected joints. The workspace outlives the registry.
void add_contact_commands(CommandRegistry& registry, Workspace& workspace);

}  // namespace marey::app
