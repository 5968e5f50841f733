#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "wasm/app/builtin_commands.h"
#include "wasm/app/command_args.h"
#include "wasm/app/icons.h"

namespace marey::app {
namespace {

using nlohmann::json;

constexpr std::array kSpeeds = {0.1, 0.25, 0.5, 1.0, 1.5, 2.0, 4.0};

constexpr double kSlowest = 0.01;
constexpr double kFastest = 16.0;

using Action = std::function<void(Playback&)>;

// Adds a command that acts on the playback of a clip with frames.
class PlayCommands {
 public:
  PlayCommands(CommandRegistry& registry, Workspace& workspace) : registry_(registry), workspace_(workspace) {}

  void add(Command command, Action action) {
    Workspace& workspace = workspace_;
    command.run = [&workspace, action = std::move(action)](const json&) -> json {
      action(workspace.session.playback);
      return workspace.session.playback.frame();
    };
    add_with_arguments(std::move(command));
  }

  void add_with_arguments(Command command) {
    Workspace& workspace = workspace_;
    command.blocked = [&workspace] { return needs_frames(workspace); };
    registry_.add(std::move(command));
  }

  Workspace& workspace() { return workspace_; }

 private:
  CommandRegistry& registry_;
  Workspace& workspace_;
};

void change_speed(Playback& playback, int steps) {
  const auto nearest = std::min_element(kSpeeds.begin(), kSpeeds.end(), [&](double a, double b) {
    return std::abs(std::log(a / playback.speed())) < std::abs(std::log(b / playback.speed()));
  });
  const auto index = static_cast<int>(nearest - kSpeeds.begin()) + steps;
  playback.set_speed(kSpeeds[idx(std::clamp(index, 0, size_of(kSpeeds) - 1))]);
}

void add_stepping(PlayCommands& commands) {
  commands.add({.id = "play.first", .label = "First frame", .help = "Goes to the first frame of the range.",
                .shortcut = "Home", .icon = icons::kSkipBack},
               [](Playback& playback) { playback.set_position(playback.range().first); });
  commands.add({.id = "play.last", .label = "Last frame", .help = "Goes to the last frame of the range.",
                .shortcut = "End", .icon = icons::kSkipForward},
               [](Playback& playback) { playback.set_position(playback.range().end() - 1); });
  commands.add({.id = "play.previous", .label = "Previous frame", .help = "Goes one frame back and pauses.",
                .shortcut = "Left", .icon = icons::kStepBack},
               [](Playback& playback) { playback.step(-1); });
  commands.add({.id = "play.next", .label = "Next frame", .help = "Goes one frame on and pauses.",
                .shortcut = "Right", .icon = icons::kStepForward},
               [](Playback& playback) { playback.step(1); });
  commands.add({.id = "play.back_ten", .label = "Ten frames back", .help = "Goes ten frames back and pauses.",
                .shortcut = "Shift+Left", .icon = icons::kRewind},
               [](Playback& playback) { playback.step(-10); });
  commands.add({.id = "play.on_ten", .label = "Ten frames on", .help = "Goes ten frames on and pauses.",
                .shortcut = "Shift+Right", .icon = icons::kFastForward},
               [](Playback& playback) { playback.step(10); });
}

void add_playing(CommandRegistry& registry, PlayCommands& commands) {
  Workspace& workspace = commands.workspace();
  registry.add({.id = "play.toggle",
                .label = "Play or pause",
                .help = "Plays the clip at its own rate, or pauses it.",
                .shortcut = "Space",
                .icon = icons::kPlay,
                .run = [&workspace](const json&) -> json {
                  Playback& playback = workspace.session.playback;
                  playback.set_playing(!playback.is_playing());
                  return playback.is_playing();
                },
                .blocked = [&workspace] { return needs_frames(workspace); },
                .live_label = [&workspace] { return SmallText("{}", workspace.session.playback.is_playing() ? "Pause" : "Play"); },
                .live_icon = [&workspace] {
                  return workspace.session.playback.is_playing() ? icons::kPause : icons::kPlay;
                }});
  registry.add({.id = "play.loop",
                .label = "Loop",
                .help = "Starts over at the end of the range instead of stopping.",
                .shortcut = "L",
                .icon = icons::kRepeat,
                .run = [&workspace](const json&) -> json {
                  Playback& playback = workspace.session.playback;
                  playback.set_loops(!playback.loops());
                  return playback.loops();
                },
                .checked = [&workspace] { return workspace.session.playback.loops(); }});
  commands.add({.id = "play.faster", .label = "Play faster", .help = "Takes the next higher speed.",
                .shortcut = "Period", .icon = icons::kGauge},
               [](Playback& playback) { change_speed(playback, 1); });
  commands.add({.id = "play.slower", .label = "Play slower", .help = "Takes the next lower speed.",
                .shortcut = "Comma", .icon = icons::kGauge},
               [](Playback& playback) { change_speed(playback, -1); });
  commands.add({.id = "play.normal_speed", .label = "Play at the clip's own rate", .help = "Sets the speed to 1×.",
                .icon = icons::kGauge},
               [](Playback& playback) { playback.set_speed(1.0); });
}

void add_range(PlayCommands& commands) {
  commands.add({.id = "play.range_in", .label = "Start the range here",
                .help = "The range that playing stays within begins at this frame.", .shortcut = "I",
                .icon = icons::kArrowLeftToLine},
               [](Playback& playback) {
                 const FrameIndex first = playback.frame();
                 playback.set_range({first, std::max(1, playback.range().end() - first)});
               });
  commands.add({.id = "play.range_out", .label = "End the range here",
                .help = "The range that playing stays within ends with this frame.", .shortcut = "O",
                .icon = icons::kArrowRightToLine},
               [](Playback& playback) {
                 const FrameIndex first = std::min(playback.range().first, playback.frame());
                 playback.set_range({first, playback.frame() - first + 1});
               });
  Workspace& workspace = commands.workspace();
  commands.add({.id = "play.range_clear", .label = "Play the whole clip", .help = "Removes the range.",
                .shortcut = "Alt+I", .icon = icons::kBrackets},
               [&workspace](Playback& playback) {
                 playback.set_range({0, workspace.session.document.motion().frame_count()});
               });
}

json go_to_frame(Workspace& workspace, const json& args) {
  CommandArgs read(args);
  if (!read.has("frame")) return command_error("Give the frame as {\"frame\": number}, counted from 0.");
  const double frame = read.number("frame", 0.0, 0.0, workspace.session.document.motion().frame_count() - 1);
  if (read.failed()) return read.error();
  workspace.session.playback.set_position(frame);
  return workspace.session.playback.frame();
}

json set_speed(Workspace& workspace, const json& args) {
  CommandArgs read(args);
  if (!read.has("speed")) return command_error("Give the speed as {\"speed\": number}; 1 is the clip's own rate.");
  const double speed = read.number("speed", 1.0, kSlowest, kFastest);
  if (read.failed()) return read.error();
  workspace.session.playback.set_speed(speed);
  return workspace.session.playback.speed();
}

}  // namespace

void add_play_commands(CommandRegistry& registry, Workspace& workspace) {
  PlayCommands commands(registry, workspace);
  add_playing(registry, commands);
  add_stepping(commands);
  add_range(commands);
  commands.add_with_arguments({.id = "play.go_to_frame",
                               .label = "Go to frame",
                               .help = "Shows a frame by its number, counted from 0.",
                               .run = [&workspace](const json& args) { return go_to_frame(workspace, args); },
                               .in_palette = false});
  commands.add_with_arguments({.id = "play.speed",
                               .label = "Set speed",
                               .help = "Sets the speed; 1 is the clip's own rate.",
                               .run = [&workspace](const json& args) { return set_speed(workspace, args); },
                               .in_palette = false});
}

}  // namespace marey::app
