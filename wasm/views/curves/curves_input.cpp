#include "wasm/views/curves/curves_input.h"

#include <algorithm>
#include <cmath>

#include "core/editing/curve_operations.h"
#include "wasm/app/faults.h"
#include "wasm/views/curves/key_marks.h"

namespace marey::app {
namespace {

constexpr float kCursorReach = 4.0f;
constexpr float kClickSlop = 3.0f;
constexpr double kWheelZoom = 1.15;
constexpr double kDragZoomPerUnit = 0.006;

const ImGuiIO& io() { return ImGui::GetIO(); }

int frame_count(const ViewContext& context) { return context.session.document.motion().frame_count(); }

bool is_selected(const Session& session, const CurveHit& hit) {
  return session.selection.samples().contains(hit.channel, hit.frame);
}

void click_select(Session& session, const CurveHit& hit) {
  SampleSelection& samples = session.selection.change_samples();
  if (io().KeyCtrl && is_selected(session, hit)) {
    samples.remove(hit.channel, {hit.frame, 1});
    return;
  }
  if (!io().KeyShift && !io().KeyCtrl) samples.clear();
  samples.add(hit.channel, {hit.frame, 1});
}

bool near_cursor(const ViewContext& context) {
  const float x = context.time_window.x_of(context.session.playback.position());
  return std::abs(io().MousePos.x - x) <= kCursorReach;
}

void begin_left_drag(ViewContext& context, CurvesState& state) {
  state.drag.grabbed = state.hit;
  state.drag.grabbed_key = state.key_hit;
  if (state.key_hit) {
    state.drag.kind = CurveDragKind::Key;
  } else if (io().KeyAlt) {
    state.drag.kind = CurveDragKind::Pan;
  } else if (state.hit) {
    state.drag.kind = CurveDragKind::Move;
    if (!is_selected(context.session, state.hit) || io().KeyCtrl) click_select(context.session, state.hit);
  } else {
    state.drag.kind = near_cursor(context) ? CurveDragKind::Cursor : CurveDragKind::Box;
  }
}

void begin_drag(ViewContext& context, CurvesState& state) {
  state.drag = {};
  state.drag.start = io().MousePos;
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) begin_left_drag(context, state);
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Middle)) state.drag.kind = CurveDragKind::Pan;
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Right)) state.drag.kind = CurveDragKind::Zoom;
}

void pan(ViewContext& context, CurvesState& state) {
  context.time_window.pan(-static_cast<double>(io().MouseDelta.x) * context.time_window.frames_per_unit(),
                          frame_count(context));
  for (ValueAxis* axis : {&state.angles, &state.lengths}) {
    axis->pan(static_cast<double>(io().MouseDelta.y) * axis->values_per_unit());
  }
}

void zoom(ViewContext& context, CurvesState& state) {
  const double wider = std::exp(-static_cast<double>(io().MouseDelta.x) * kDragZoomPerUnit);
  const double higher = std::exp(static_cast<double>(io().MouseDelta.y) * kDragZoomPerUnit);
  context.time_window.zoom(state.drag.start.x, wider, frame_count(context));
  for (ValueAxis* axis : {&state.angles, &state.lengths}) axis->zoom(state.drag.start.y, higher);
}

void move_samples(ViewContext& context, CurvesState& state) {
  CurveDrag& drag = state.drag;
  Session& session = context.session;
  if (drag.gesture == 0) drag.gesture = context.widgets.new_gesture();
  const ValueAxis& axis = state.axis_of(session.document.skeleton(), drag.grabbed.channel);
  const double delta = axis.value_at(io().MousePos.y) - axis.value_at(drag.start.y);
  const SampleSelection moved = selected_samples_like(session, drag.grabbed.channel);
  const Falloff falloff{static_cast<double>(context.options.falloff_radius_frames)};
  const auto make_edit = [&](const Clip& clip) { return make_move_edit(clip, moved, delta, falloff); };
  const Status status = with_memory_for("this change", [&] { return session.apply_gesture(drag.gesture, make_edit); });
  if (!status) context.refusal = status.error().message;
}

void continue_drag(ViewContext& context, CurvesState& state) {
  CurveDrag& drag = state.drag;
  const ImVec2 mouse = io().MousePos;
  drag.moved = drag.moved || std::hypot(mouse.x - drag.start.x, mouse.y - drag.start.y) > kClickSlop;
  if (!drag.moved) return;
  switch (drag.kind) {
    case CurveDragKind::Pan: pan(context, state); break;
    case CurveDragKind::Zoom: zoom(context, state); break;
    case CurveDragKind::Move: move_samples(context, state); break;
    case CurveDragKind::Key: drag_key(context, state); break;
    case CurveDragKind::Cursor:
      context.session.playback.set_position(std::round(context.time_window.frame_at(mouse.x)));
      break;
    case CurveDragKind::Box:
    case CurveDragKind::None: break;
  }
}

void finish_box(ViewContext& context, CurvesState& state) {
  SampleSelection& samples = context.session.selection.change_samples();
  if (!io().KeyShift && !io().KeyCtrl) samples.clear();
  if (!state.drag.moved) return;
  const SampleSelection boxed =
      find_samples_in_box(state, context.session, context.time_window, state.drag.start, io().MousePos);
  for (const SampleRun& run : boxed.runs()) {
    if (io().KeyCtrl) {
      samples.remove(run.channel, run.frames);
    } else {
      samples.add(run.channel, run.frames);
    }
  }
}

void finish_drag(ViewContext& context, CurvesState& state) {
  const CurveDrag drag = state.drag;
  if (drag.kind == CurveDragKind::Box) finish_box(context, state);
  const bool plain_click = drag.kind == CurveDragKind::Move && !drag.moved && !io().KeyShift && !io().KeyCtrl;
  if (plain_click) click_select(context.session, drag.grabbed);
  state.drag = {};
}

void cancel_drag(ViewContext& context, CurvesState& state) {
  if (state.drag.gesture != 0) context.session.cancel_gesture(state.drag.gesture);
  state.drag = {};
}

void handle_wheel(ViewContext& context, CurvesState& state) {
  const double turns = static_cast<double>(io().MouseWheel);
  const double sideways = static_cast<double>(io().MouseWheelH) + (io().KeyShift ? turns : 0.0);
  if (state.drag.kind == CurveDragKind::Move) {
    const double radius = static_cast<double>(context.options.falloff_radius_frames);
    const double next = turns > 0.0 ? std::max(radius + 1.0, radius * kWheelZoom) : std::min(radius - 1.0, radius / kWheelZoom);
    if (turns != 0.0) context.options.falloff_radius_frames = static_cast<float>(std::clamp(std::round(next), 0.0, 1000.0));
    return;
  }
  if (sideways != 0.0) {
    const double shown = context.time_window.last - context.time_window.first;
    context.time_window.pan(-0.1 * sideways * shown, frame_count(context));
  } else if (turns != 0.0 && io().KeyCtrl) {
    for (ValueAxis* axis : {&state.angles, &state.lengths}) axis->zoom(io().MousePos.y, std::pow(kWheelZoom, -turns));
  } else if (turns != 0.0) {
    context.time_window.zoom(io().MousePos.x, std::pow(kWheelZoom, -turns), frame_count(context));
  }
}

void show_pointer(ViewContext& context, const CurvesState& state) {
  const CurveDragKind kind = state.drag.kind;
  if (kind == CurveDragKind::Key || (kind == CurveDragKind::None && state.key_hit)) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
    context.status = state.key_hit.part == KeyPart::Key ? "Drag to move the key, by whole frames unless Alt is held."
                                                        : "Drag to pull the handle.";
  } else if (kind == CurveDragKind::Move || (kind == CurveDragKind::None && state.hit)) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
    context.status = "Drag to move in value. Wheel changes the falloff. Shift adds, Ctrl toggles.";
  } else if (kind == CurveDragKind::Pan) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
  } else if (kind == CurveDragKind::Cursor || near_cursor(context)) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    context.status = "Drag to scrub.";
  } else {
    context.status = "Drag to select with a box. Wheel zooms time, Ctrl+wheel values. Middle drag pans.";
  }
}

}  // namespace

void handle_curves_input(ViewContext& context, CurvesState& state) {
  const bool hovered = ImGui::IsItemHovered();
  const bool dragging = state.drag.kind != CurveDragKind::None;
  if (!dragging) {
    state.key_hit = hovered ? find_key_hit(state, context.session, context.time_window, io().MousePos) : KeyHit{};
    state.hit = hovered && !state.key_hit ? find_curve_hit(state, context.session, context.time_window, io().MousePos) : CurveHit{};
  }
  if (ImGui::IsItemActivated()) begin_drag(context, state);
  // The last move may come in the frame of the release.
  const bool follows = ImGui::IsItemActive() || ImGui::IsItemDeactivated();
  if (follows && state.drag.kind != CurveDragKind::None) continue_drag(context, state);
  // Escape also takes the item's activity away, so it must be asked for first.
  if (dragging && ImGui::IsKeyPressed(ImGuiKey_Escape)) cancel_drag(context, state);
  if (ImGui::IsItemDeactivated()) finish_drag(context, state);
  if (hovered) {
    handle_wheel(context, state);
    show_pointer(context, state);
    if (!state.hit && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
      fit_selection(state, context.session, context.time_window);
    }
  }
  if (state.hit) {
    context.next_hover.channel = state.hit.channel;
    context.next_hover.joint = context.session.document.skeleton().channel(state.hit.channel).joint;
  }
}

void handle_axis_input(ViewContext& context, ValueAxis& axis) {
  if (!ImGui::IsItemHovered() && !ImGui::IsItemActive()) return;
  ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
  context.status = "Drag or turn the wheel to zoom this axis.";
  const double turns = static_cast<double>(io().MouseWheel);
  if (ImGui::IsItemHovered() && turns != 0.0) axis.zoom(io().MousePos.y, std::pow(kWheelZoom, -turns));
  if (ImGui::IsItemActive()) {
    const float middle = 0.5f * (axis.top + axis.bottom);
    axis.zoom(middle, std::exp(static_cast<double>(io().MouseDelta.y) * kDragZoomPerUnit));
  }
}

}  // namespace marey::app
