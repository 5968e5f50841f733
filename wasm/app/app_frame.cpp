#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "wasm/app/app_parts.h"
#include "wasm/app/opening.h"
#include "wasm/app/shortcut.h"
#include "wasm/app/widgets.h"
#include "wasm/views/viewport/strobe.h"

namespace marey::app {
namespace {

constexpr int kFramesToSettle = 2;
constexpr double kLongestStep_s = 1.0;

const char* css_cursor_of(ImGuiMouseCursor cursor) {
  switch (cursor) {
    case ImGuiMouseCursor_None: return "none";
    case ImGuiMouseCursor_TextInput: return "text";
    case ImGuiMouseCursor_ResizeAll: return "move";
    case ImGuiMouseCursor_ResizeNS: return "ns-resize";
    case ImGuiMouseCursor_ResizeEW: return "ew-resize";
    case ImGuiMouseCursor_ResizeNESW: return "nesw-resize";
    case ImGuiMouseCursor_ResizeNWSE: return "nwse-resize";
    case ImGuiMouseCursor_Hand: return "pointer";
    case ImGuiMouseCursor_Wait: return "wait";
    case ImGuiMouseCursor_Progress: return "progress";
    case ImGuiMouseCursor_NotAllowed: return "not-allowed";
    default: return "default";
  }
}

bool is_menu_open() { return ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel); }

void update_window(AppParts& parts, const WindowSize& window, double elapsed_s) {
  ViewOptions& options = parts.workspace.preferences.options;
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = ImVec2(window.css_width / options.interface_scale, window.css_height / options.interface_scale);
  const float pixels_per_unit = window.device_pixel_ratio * options.interface_scale;
  io.DisplayFramebufferScale = ImVec2(pixels_per_unit, pixels_per_unit);
  io.DeltaTime = static_cast<float>(std::clamp(elapsed_s, 1e-4, kLongestStep_s));
  options.compact = io.DisplaySize.x < kCompactWidth;
  options.touch = parts.touched.value_or(parts.workspace.system.coarse_pointer) || options.compact;
}

ThemeKind wanted_theme(const Workspace& workspace) {
  switch (workspace.preferences.theme) {
    case ThemeChoice::Dark: return ThemeKind::Dark;
    case ThemeChoice::Light: return ThemeKind::Light;
    case ThemeChoice::System: break;
  }
  return workspace.system.dark ? ThemeKind::Dark : ThemeKind::Light;
}

void update_theme(AppParts& parts) {
  Workspace& workspace = parts.workspace;
  workspace.system = workspace.backend.system_preferences();
  parts.theme = make_theme(wanted_theme(workspace));
  if (workspace.preferences.options.projector) parts.theme = with_more_contrast(parts.theme);
  apply_theme(parts.theme, workspace.preferences.options.touch);
}

// The innermost thing that is open, chosen or said goes first.
void follow_escape(AppParts& parts) {
  if (!ImGui::IsKeyPressed(ImGuiKey_Escape, false) || is_menu_open()) return;
  Workspace& workspace = parts.workspace;
  Selection& selection = workspace.session.selection;
  if (workspace.overlay != Overlay::None) {
    workspace.overlay = Overlay::None;
    workspace.preferences.welcome_seen = true;
  } else if (ImGui::GetCurrentContext()->ActiveId != 0) {
    return;
  } else if (workspace.loading) {
    parts.commands.run("file.cancel_loading", nullptr);
  } else if (!workspace.messages.list().empty()) {
    workspace.messages.close(0);
  } else if (!selection.samples().empty()) {
    selection.change_samples().clear();
  } else {
    selection.clear_joints();
  }
}

// What is pressed must not move away: controls change their size when the finger is lifted.
void follow_pointer_kind(AppParts& parts) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.MouseReleased[0]) parts.touched = io.MouseSource == ImGuiMouseSource_TouchScreen;
}

void begin_views(AppParts& parts) {
  Workspace& workspace = parts.workspace;
  parts.items.begin_frame();
  parts.hover = parts.next_hover;
  parts.next_hover = {};
  workspace.follow_notice();
  follow_loading(workspace);
  parts.status = workspace.notice;
}

// Views keep what belongs to the open clip (camera, axes, folds): they hear when it is another one.
void follow_clip(AppParts& parts) {
  if (parts.shown_clip_serial == parts.workspace.clip_serial) return;
  parts.shown_clip_serial = parts.workspace.clip_serial;
  const Motion& motion = parts.workspace.session.document.motion();
  parts.time_window.fit(motion.frame_count());
  if (parts.workspace.keeps_view) return;
  parts.workspace.preferences.options.strobe_every_frames =
      usual_strobe_distance(motion.frame_count(), motion.frame_time_s());
  parts.shell.document_opened();
}

void draw_window(AppParts& parts) {
  follow_clip(parts);
  ImGui::SetNextWindowPos(ImVec2(0.0f, 0.0f));
  ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
  ImGui::Begin("##marey", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoBackground |
                   ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar(3);
  ImGui::PushFont(parts.fonts.text, Fonts::kTextSize);
  ViewContext context = parts.make_context();
  parts.shell.draw(context, parts.workspace, parts.scene);
  ImGui::PopFont();
  ImGui::End();
  ImGui::PushFont(parts.fonts.text, Fonts::kTextSize);
  parts.shell.draw_overlays(context, parts.workspace);
  ImGui::PopFont();
}

void say_refusal(AppParts& parts) {
  if (!parts.refusal.empty() && parts.refusal != parts.workspace.notice) parts.workspace.notify(parts.refusal);
  parts.refusal.clear();
}

// Tells the page what it shows outside of the canvas, when it has changed.
void report_to_page(AppParts& parts) {
  Workspace& workspace = parts.workspace;
  const Document& document = workspace.session.document;
  const std::string name = ui::displayable(document.file_name());
  if (name != parts.announced_name || document.is_dirty() != parts.announced_dirty) {
    parts.announced_name = name;
    parts.announced_dirty = document.is_dirty();
    workspace.backend.set_document_state(name, parts.announced_dirty);
  }
  const char* cursor = css_cursor_of(ImGui::GetMouseCursor());
  if (parts.mouse_cursor != cursor) {
    parts.mouse_cursor = cursor;
    workspace.backend.set_mouse_cursor(cursor);
  }
}

// Not while something is dragged: a panel's size changes with every frame.
void store_preferences(AppParts& parts) {
  if (parts.known_preferences == parts.workspace.preferences || ImGui::IsAnyMouseDown()) return;
  parts.known_preferences = parts.workspace.preferences;
  std::string written = write_preferences(parts.workspace.preferences);
  if (written == parts.stored_preferences) return;
  parts.workspace.backend.store_preferences(written);
  parts.stored_preferences = std::move(written);
}

// A frame that fails between the panels is told and drawn again; what fails for good is for the page to say.
void follow_fault(AppParts& parts, const std::optional<Fault>& fault) {
  const bool failed_before = std::exchange(parts.last_frame_failed, fault.has_value());
  if (!fault) return;
  if (failed_before) throw std::runtime_error(fault->details);
  parts.workspace.backend.report_fault("A frame could not be drawn: " + fault->details);
  parts.redraw = true;
}

bool same_hover(const Hover& a, const Hover& b) { return a.joint == b.joint && a.channel == b.channel; }

bool is_input_waiting() { return ImGui::GetCurrentContext()->InputEventsQueue.Size > 0; }

bool wants_more_frames(AppParts& parts, bool playing) {
  if (is_input_waiting() || !same_hover(parts.hover, parts.next_hover)) parts.settling_frames = kFramesToSettle;
  const bool settling = parts.settling_frames > 0;
  if (settling) --parts.settling_frames;
  return playing || parts.redraw || settling;
}

}  // namespace

ViewContext AppParts::make_context() {
  return {.session = workspace.session,
          .clip_serial = workspace.clip_serial,
          .commands = commands,
          .analysis = workspace.analysis,
          .options = workspace.preferences.options,
          .time_window = time_window,
          .theme = theme,
          .fonts = fonts,
          .items = items,
          .hover = hover,
          .next_hover = next_hover,
          .status = status,
          .refusal = refusal,
          .now_s = workspace.now_s,
          .redraw = redraw,
          .widgets = widgets,
          .system = workspace.system};
}

void App::note_cost(const FrameCost& cost) {
  constexpr double kMemoryMeasuredEvery_s = 0.5;
  Workspace& workspace = parts_->workspace;
  Performance& performance = workspace.performance;
  performance.add_frame(cost, workspace.now_s, workspace.session.playback.is_playing());
  if (!workspace.preferences.options.show_performance) return;
  if (workspace.now_s - performance.memory_measured_s < kMemoryMeasuredEvery_s) return;
  performance.memory_measured_s = workspace.now_s;
  performance.memory = workspace.backend.memory();
}

void App::draw_frame() {
  AppParts& parts = *parts_;
  follow_pointer_kind(parts);
  begin_views(parts);
  if (!parts.commands.run_pressed_shortcut().empty()) parts.settling_frames = kFramesToSettle;
  follow_escape(parts);
  draw_window(parts);
  say_refusal(parts);
  if (!ImGui::GetIO().NavVisible && !is_menu_open()) keep_navigation_keys_for_shortcuts();
  report_to_page(parts);
}

bool App::frame(const WindowSize& window, double now_s) {
  AppParts& parts = *parts_;
  Workspace& workspace = parts.workspace;
  const double elapsed_s = parts.last_frame_s < 0.0 ? 0.0 : std::clamp(now_s - parts.last_frame_s, 0.0, kLongestStep_s);
  parts.last_frame_s = workspace.now_s = now_s;
  parts.redraw = false;
  if (is_input_waiting()) parts.settling_frames = kFramesToSettle;

  const bool playing = workspace.session.playback.advance(elapsed_s);
  update_window(parts, window, elapsed_s);
  update_theme(parts);
  ImGui::NewFrame();
  const std::optional<Fault> fault = draw_guarded([this] { draw_frame(); });
  ImGui::Render();
  follow_fault(parts, fault);

  store_preferences(parts);
  return wants_more_frames(parts, playing);
}

}  // namespace marey::app
