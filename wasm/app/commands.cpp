#include "wasm/app/commands.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <cassert>
#include <utility>

#include "wasm/app/shortcut.h"

namespace marey::app {
namespace {

// With the focus ring on a control, the plain keys belong to it: Space presses it, arrows move on.
bool belongs_to_focused_control(ImGuiKeyChord chord) {
  if ((chord & ImGuiMod_Mask_) != 0) return false;
  switch (static_cast<ImGuiKey>(chord)) {
    case ImGuiKey_Space:
    case ImGuiKey_Enter:
    case ImGuiKey_LeftArrow:
    case ImGuiKey_RightArrow:
    case ImGuiKey_UpArrow:
    case ImGuiKey_DownArrow:
    case ImGuiKey_Home:
    case ImGuiKey_End:
    case ImGuiKey_PageUp:
    case ImGuiKey_PageDown:
      return true;
    default:
      return false;
  }
}

bool is_any_pressed(const std::vector<ImGuiKeyChord>& chords, bool control_focused) {
  for (const ImGuiKeyChord chord : chords) {
    if (control_focused && belongs_to_focused_control(chord)) continue;
    if (is_chord_pressed(chord)) return true;
  }
  return false;
}

}  // namespace

void CommandRegistry::add(Command command) {
  assert(find(command.id) == nullptr);
  chords_.push_back(parse_shortcuts(command.shortcut));
  commands_.push_back(std::move(command));
}

const Command* CommandRegistry::find(std::string_view id) const {
  for (const Command& command : commands_) {
    if (command.id == id) return &command;
  }
  return nullptr;
}

nlohmann::json CommandRegistry::run(std::string_view id, const nlohmann::json& args) {
  const Command* command = find(id);
  if (command == nullptr) return {{"error", "There is no command \"" + std::string(id) + "\"."}};
  if (const std::string_view reason = blocked_reason(*command); !reason.empty()) return {{"error", reason}};
  return run_guarded(*command, args);
}

nlohmann::json CommandRegistry::run_guarded(const Command& command, const nlohmann::json& args) {
  nlohmann::json answer;
  const std::optional<Fault> fault = catch_fault([&] { answer = command.run(args); });
  if (!fault) {
    const auto error = answer.is_object() ? answer.find("error") : answer.end();
    if (answer.is_object() && error != answer.end() && refused_) refused_(error->get<std::string>());
    return answer;
  }
  if (failed_) failed_(command, *fault);
  return {{"error", fault->out_of_memory ? out_of_memory("this command").message : fault->details}};
}

SmallText CommandRegistry::label_of(const Command& command) {
  return command.live_label ? command.live_label() : SmallText("{}", command.label);
}

const char* CommandRegistry::icon_of(const Command& command) {
  return command.live_icon ? command.live_icon() : command.icon;
}

std::string_view CommandRegistry::blocked_reason(const Command& command) {
  return command.blocked ? command.blocked() : std::string_view();
}

std::string CommandRegistry::run_pressed_shortcut() {
  const ImGuiIO& io = ImGui::GetIO();
  const bool menu_open = ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  if (io.WantTextInput || menu_open) return {};
  for (std::size_t i = 0; i < commands_.size(); ++i) {
    const Command& command = commands_[i];
    if (!is_any_pressed(chords_[i], io.NavVisible) || !is_enabled(command)) continue;
    const std::string id = command.id;
    run_guarded(command, nullptr);
    return id;
  }
  return {};
}

}  // namespace marey::app
