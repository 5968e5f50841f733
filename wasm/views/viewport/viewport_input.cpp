#include "wasm/views/viewport/viewport_input.h"

#include <cmath>

#include "wasm/app/widgets.h"
#include "wasm/views/viewport/figure_drawing.h"

namespace marey::app {
namespace {

constexpr double kPickTolerance = 5.0;       // ImGui units
constexpr double kTouchTolerance = 16.0;
constexpr float kClickSlack = 4.0f;          // a press that moves less is a click
constexpr double kZoomPerLine = 0.88;

glm::dvec2 pointer_in_view(const ViewportState& state) {
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  return {static_cast<double>(pointer.x - state.corner.x), static_cast<double>(pointer.y - state.corner.y)};
}

JointIndex joint_under_pointer(const ViewContext& context, ViewportState& state) {
  collect_solids(state.figure.shape(), state.figure.pose(), state.solids);
  const double tolerance = context.options.touch ? kTouchTolerance : kPickTolerance;
  return pick_joint(state.solids, state.view, pointer_in_view(state), tolerance);
}

ViewDrag drag_of(ImGuiMouseButton button) {
  const ImGuiIO& io = ImGui::GetIO();
  if (button == ImGuiMouseButton_Right) return ViewDrag::Pan;
  if (button == ImGuiMouseButton_Left) return ViewDrag::Orbit;
  // The page sends two fingers as the middle button.
  const bool pans = io.KeyShift || io.MouseSource == ImGuiMouseSource_TouchScreen;
  return pans ? ViewDrag::Pan : ViewDrag::Orbit;
}

void select_clicked(ViewContext& context, ViewportState& state) {
  const ImGuiIO& io = ImGui::GetIO();
  const JointIndex joint = joint_under_pointer(context, state);
  Selection& selection = context.session.selection;
  if (io.KeyShift || io.KeyCtrl) {
    if (joint != kNoParent) selection.toggle(joint);
  } else if (joint != kNoParent) {
    selection.select_only(joint);
  } else {
    selection.clear_joints();
  }
}

void begin_drag(ViewportState& state) {
  for (const ImGuiMouseButton button : {ImGuiMouseButton_Left, ImGuiMouseButton_Right, ImGuiMouseButton_Middle}) {
    if (!ImGui::IsMouseClicked(button)) continue;
    state.drag = ViewDrag::Waiting;
    state.drag_button = button;
    return;
  }
}

void continue_drag(ViewContext& context, ViewportState& state) {
  const ImGuiIO& io = ImGui::GetIO();
  if (!ImGui::IsMouseDown(state.drag_button)) {
    const bool clicked = state.drag == ViewDrag::Waiting && state.drag_button == ImGuiMouseButton_Left;
    state.drag = ViewDrag::None;
    if (clicked) select_clicked(context, state);
    return;
  }
  if (state.drag == ViewDrag::Waiting) {
    if (!ImGui::IsMouseDragging(state.drag_button, kClickSlack)) return;
    state.drag = drag_of(state.drag_button);
  }
  const glm::dvec2 moved(static_cast<double>(io.MouseDelta.x), static_cast<double>(io.MouseDelta.y));
  if (state.drag == ViewDrag::Orbit) {
    state.camera.orbit(moved);
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
    context.status = "Orbiting. Release to stop.";
  } else {
    state.camera.pan(moved, state.view.size());
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
    context.status = "Moving the view. Release to stop.";
  }
}

void hover(ViewContext& context, ViewportState& state) {
  const JointIndex joint = joint_under_pointer(context, state);
  context.next_hover.joint = joint;
  if (joint != kNoParent) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    context.status = "Click to select. Shift adds or removes.";
  } else {
    context.status = context.options.touch ? "Drag to orbit. Two fingers move and zoom."
                                           : "Drag to orbit, right drag to move, wheel to zoom.";
  }
}

}  // namespace

void handle_viewport_input(ViewContext& context, ViewportState& state) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool hovered = ImGui::IsItemHovered();
  if (hovered && io.MouseWheel != 0.0f) {
    state.camera.zoom(std::pow(kZoomPerLine, static_cast<double>(io.MouseWheel)), pointer_in_view(state),
                      state.view.size());
    context.redraw = true;
  }
  if (ImGui::IsItemActivated()) begin_drag(state);
  if (state.drag != ViewDrag::None) {
    continue_drag(context, state);
  } else if (hovered) {
    hover(context, state);
  }
}

}  // namespace marey::app
