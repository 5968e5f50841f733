#pragma once

#include <imgui.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "wasm/app/faults.h"
#include "wasm/app/small_text.h"

namespace marey::app {

/// Why something cannot be done now: a short sentence that lives as long as who tells it, "" for no reason. No std::string,
/// which would be gone: reasons are asked for in each frame.
using Reason = const char*;

/// One thing the user can do. Menus, shortcuts, the palette, buttons, the page's JavaScript API and the tests all run
/// it from here.
struct Command {
  std::string id;        ///< "edit.undo": stable, part of the page's API
  std::string label;     ///< "Undo": sentence case, no full stop; "…" at the end when it opens a dialog
  std::string help;      ///< one sentence for the tool tip
  std::string shortcut{};  ///< "Ctrl+Z", "Space", "Shift+F"; "" for none. Several: "Ctrl+Y, Ctrl+Shift+Z"
  const char* icon = nullptr;  ///< a glyph of the icon font (wasm/app/icons.h); nullptr for none

  /// Runs it. `args` is null when it comes from a menu, button or shortcut. Returns what the JavaScript caller gets;
  /// an object {"error": sentence} when the arguments are wrong.
  std::function<nlohmann::json(const nlohmann::json& args)> run{};

  /// Why it cannot run now. Not set: always possible.
  std::function<Reason()> blocked{};
  /// For toggles: whether it is on, shown as a check mark. Not set: no toggle.
  std::function<bool()> checked{};
  /// A label that depends on the state ("Undo move 12 samples"); not set: `label`.
  std::function<SmallText()> live_label{};
  /// An icon that depends on the state; not set: `icon`.
  std::function<const char*()> live_icon = {};
  bool in_palette = true;
};

class CommandRegistry {
 public:
  /// Precondition: the id is new.
  void add(Command command);

  [[nodiscard]] const Command* find(std::string_view id) const;
  [[nodiscard]] const std::vector<Command>& all() const { return commands_; }

  /// Hears of commands that threw, as of one that has no memory; what was thrown goes no further.
  using Failed = std::function<void(const Command& command, const Fault& fault)>;
  void set_failed(Failed failed) { failed_ = std::move(failed); }
  /// Called with the sentence of each command that could not do what it was asked for.
  void set_refused(std::function<void(const std::string& sentence)> refused) { refused_ = std::move(refused); }

  /// Runs a command by id. {"error": ...} for an unknown id, a blocked command or one that threw; else what the command
  /// returns.
  nlohmann::json run(std::string_view id, const nlohmann::json& args = nullptr);

  [[nodiscard]] static SmallText label_of(const Command& command);
  [[nodiscard]] static const char* icon_of(const Command& command);
  [[nodiscard]] static std::string_view blocked_reason(const Command& command);
  [[nodiscard]] static bool is_enabled(const Command& command) { return blocked_reason(command).empty(); }

  /// Runs the enabled command whose shortcut is the chord pressed this frame, unless a text field has the keyboard.
  /// Call once per frame inside of an ImGui frame. Returns the id that ran, "" if none.
  std::string run_pressed_shortcut();

 private:
  nlohmann::json run_guarded(const Command& command, const nlohmann::json& args);

  std::vector<Command> commands_;
  std::vector<std::vector<ImGuiKeyChord>> chords_;  ///< of the commands' shortcuts
  Failed failed_;
  std::function<void(const std::string&)> refused_;
};

}  // namespace marey::app
