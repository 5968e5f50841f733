#include "wasm/app/app.h"

#include <imgui.h>

#include <utility>

#include "wasm/app/app_parts.h"
#include "wasm/app/builtin_commands.h"
#include "wasm/app/faults.h"
#include "wasm/app/opening.h"

namespace marey::app {
namespace {

constexpr int kFramesToSettle = 2;

void configure_imgui() {
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  io.ConfigInputTextCursorBlink = false;  // a blinking cursor would redraw an idle page
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  io.ConfigNavCaptureKeyboard = true;
  ImGui::GetStyle().HoverFlagsForTooltipMouse =
      ImGuiHoveredFlags_Stationary | ImGuiHoveredFlags_DelayNormal | ImGuiHoveredFlags_AllowWhenDisabled;
}

void add_all_commands(AppParts& parts) {
  add_file_commands(parts.commands, parts.workspace);
  add_edit_commands(parts.commands, parts.workspace);
  add_operation_commands(parts.commands, parts.workspace);
  add_play_commands(parts.commands, parts.workspace);
  add_view_commands(parts.commands, parts.workspace);
  add_clip_commands(parts.commands, parts.workspace);
  add_frame_commands(parts.commands, parts.workspace);
  add_help_commands(parts.commands, parts.workspace);
  parts.shell.add_commands(parts.commands, parts.workspace, parts.time_window);
}

Message failure_message(const Command& command, const Fault& fault) {
  std::string title = std::string(CommandRegistry::label_of(command)) + " could not be done";
  std::string detail = fault.out_of_memory ? out_of_memory("it").message : fault.details + ".";
  return {MessageKind::Error, std::move(title), detail + " The clip is as it was.", ""};
}

}  // namespace

App::App(Backend& backend, const FontFiles& fonts) {
  configure_imgui();
  parts_ = std::make_unique<AppParts>(backend, fonts);
  Workspace& workspace = parts_->workspace;
  parts_->stored_preferences = backend.load_preferences();
  workspace.preferences = parts_->known_preferences = read_preferences(parts_->stored_preferences);
  workspace.overlay = workspace.preferences.welcome_seen ? Overlay::None : Overlay::Welcome;
  add_all_commands(*parts_);
  parts_->commands.set_refused([this](const std::string& sentence) { parts_->refusal = sentence; });
  parts_->commands.set_failed([&workspace](const Command& command, const Fault& fault) {
    const Message message = failure_message(command, fault);
    workspace.messages.add(message);
    workspace.backend.announce(message.title + ". " + message.detail);
  });
}

App::~App() = default;

Status App::open_file(std::string file_name, std::string_view bytes) {
  if (Status begun = begin_loading(std::move(file_name), static_cast<std::int64_t>(bytes.size())); !begun) return begun;
  feed_loading(bytes);
  return finish_loading();
}

Status App::begin_loading(std::string file_name, std::int64_t size, FileUse use) {
  parts_->settling_frames = kFramesToSettle;
  return app::begin_loading(parts_->workspace, std::move(file_name), size, use);
}

bool App::feed_loading(std::string_view bytes) { return app::feed_loading(parts_->workspace, bytes); }

Status App::finish_loading() {
  parts_->settling_frames = kFramesToSettle;
  return app::finish_loading(parts_->workspace);
}

void App::cancel_loading() {
  parts_->settling_frames = kFramesToSettle;
  parts_->workspace.cancel_loading();
}

const Scene& App::scene() const { return parts_->scene; }
const UiItems& App::items() const { return parts_->items; }
float App::css_per_unit() const { return parts_->workspace.preferences.options.interface_scale; }
Session& App::session() { return parts_->workspace.session; }
std::string App::save_text() const { return parts_->workspace.whole_document().save_text(); }

nlohmann::json App::run_command(std::string_view id, const nlohmann::json& args) {
  parts_->settling_frames = 2;
  return parts_->commands.run(id, args);
}

}  // namespace marey::app
