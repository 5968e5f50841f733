#include "wasm/views/viewport/viewport_commands.h"

#include <algorithm>
#include <numbers>
#include <string>

#include "wasm/app/command_args.h"
#include "wasm/app/icons.h"
#include "wasm/views/viewport/gizmo.h"

namespace marey::app {
namespace {

using nlohmann::json;

constexpr double kStep_deg = 15.0;
constexpr double kZoomStep = 0.8;

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

Reason without_figure(const Session& session) {
  return session.document.skeleton().joint_count() == 0 ? "Open a file first." : "";
}

void add_framing(CommandRegistry& registry, const Session& session, ViewportState& state, Command command,
                 CameraRequest::Framing framing) {
  command.run = [&state, framing](const json&) -> json {
    state.request.framing = framing;
    return nullptr;
  };
  command.blocked = [&session] { return without_figure(session); };
  registry.add(std::move(command));
}

void add_axis_view(CommandRegistry& registry, ViewportState& state, const AxisView& view, const char* help,
                   const char* shortcut) {
  registry.add({.id = view.command,
                .label = std::string(view.name) + " view",
                .help = help,
                .shortcut = shortcut,
                .run = [&state, &view](const json&) -> json {
                  state.request.yaw_rad = view.yaw_rad;
                  state.request.pitch_rad = view.pitch_rad;
                  return nullptr;
                },
                .checked = [&state, &view] { return find_axis_view(state.camera.goal()) == &view; }});
}

json orbit(ViewportState& state, const json& args) {
  CommandArgs read(args);
  const double yaw = radians(read.number("yaw", 0.0, -360.0, 360.0));
  const double pitch = radians(read.number("pitch", 0.0, -180.0, 180.0));
  if (read.failed()) return read.error();
  const CameraPose& goal = state.camera.goal();
  const double limit = 0.5 * std::numbers::pi;
  state.request.yaw_rad = state.request.yaw_rad.value_or(goal.yaw_rad) + yaw;
  state.request.pitch_rad = std::clamp(state.request.pitch_rad.value_or(goal.pitch_rad) + pitch, -limit, limit);
  return nullptr;
}

void add_step(CommandRegistry& registry, ViewportState& state, Command command, double yaw_deg, double pitch_deg) {
  command.run = [&state, yaw_deg, pitch_deg](const json&) {
    return orbit(state, json{{"yaw", yaw_deg}, {"pitch", pitch_deg}});
  };
  registry.add(std::move(command));
}

void add_orbits(CommandRegistry& registry, ViewportState& state) {
  add_step(registry, state, {.id = "view.orbit_left", .label = "Orbit left", .help = "Turns the view by 15°.",
                             .shortcut = "4"}, -kStep_deg, 0.0);
  add_step(registry, state, {.id = "view.orbit_right", .label = "Orbit right", .help = "Turns the view by 15°.",
                             .shortcut = "6"}, kStep_deg, 0.0);
  add_step(registry, state, {.id = "view.orbit_up", .label = "Orbit up", .help = "Tilts the view by 15°.",
                             .shortcut = "8"}, 0.0, kStep_deg);
  add_step(registry, state, {.id = "view.orbit_down", .label = "Orbit down", .help = "Tilts the view by 15°.",
                             .shortcut = "2"}, 0.0, -kStep_deg);
  registry.add({.id = "view.orbit",
                .label = "Orbit",
                .help = "Turns the view by yaw and pitch in degrees.",
                .run = [&state](const json& args) { return orbit(state, args); },
                .in_palette = false});
}

void add_zoom(CommandRegistry& registry, ViewportState& state, Command command, double factor) {
  command.run = [&state, factor](const json&) -> json {
    state.request.zoom *= factor;
    return nullptr;
  };
  registry.add(std::move(command));
}

}  // namespace

void add_viewport_commands(CommandRegistry& registry, const Session& session, ViewportState& state) {
  add_framing(registry, session, state,
              {.id = "view.frame_all",
               .label = "Frame all",
               .help = "Shows the whole motion, or the whole figure while the view follows it.",
               .shortcut = "0",
               .icon = icons::kMaximize},
              CameraRequest::Framing::All);
  add_framing(registry, session, state,
              {.id = "view.frame_selection",
               .label = "Frame the selection",
               .help = "Shows the selected joints, or the figure when none is selected.",
               .shortcut = "F",
               .icon = icons::kScan},
              CameraRequest::Framing::Selection);
  const char* helps[] = {"Looks at the front.",     "Looks at the back.",  "Looks along the X axis.",
                         "Looks along the X axis from the other side.", "Looks down.", "Looks up."};
  const char* shortcuts[] = {"1", "Shift+1", "3", "Shift+3", "7", "Shift+7"};
  for (std::size_t i = 0; i < kAxisViews.size(); ++i) {
    add_axis_view(registry, state, kAxisViews[i], helps[i], shortcuts[i]);
  }
  add_orbits(registry, state);
  add_zoom(registry, state, {.id = "view.zoom_in", .label = "Come closer", .help = "Shows the figure larger.",
                             .shortcut = "Plus, KeypadPlus", .icon = icons::kZoomIn}, kZoomStep);
  add_zoom(registry, state, {.id = "view.zoom_out", .label = "Step back", .help = "Shows more around the figure.",
                             .shortcut = "Minus, KeypadMinus", .icon = icons::kZoomOut}, 1.0 / kZoomStep);
}

}  // namespace marey::app
