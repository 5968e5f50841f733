#include "wasm/app/app.h"

#include <fmt/format.h>
#include <imgui.h>

#include <utility>

#include "core/base/counted.h"
#include "core/bvh/text_encoding.h"
#include "wasm/app/app_parts.h"
#include "wasm/app/builtin_commands.h"
#include "wasm/app/file_reading.h"
#include "wasm/app/samples.h"
#include "wasm/app/widgets.h"

namespace marey::app {
namespace {

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
  add_play_commands(parts.commands, parts.workspace);
  add_view_commands(parts.commands, parts.workspace);
  add_clip_commands(parts.commands, parts.workspace);
  add_frame_commands(parts.commands, parts.workspace);
  add_help_commands(parts.commands, parts.workspace);
  parts.shell.add_commands(parts.commands, parts.workspace, parts.time_window);
}

Message refusal_message(const std::string& file_name, const Error& error, bool keeps_document) {
  std::string detail;
  if (error.place.line > 0) detail = fmt::format("Line {}, column {}: ", error.place.line, error.place.column);
  detail += error.message;
  detail += keeps_document ? " The clip that was open stays as it was." : "";
  return {MessageKind::Error, ui::displayable(file_name) + " could not be opened", std::move(detail), ""};
}

Message kept_message(const Document& kept) {
  return {MessageKind::Warning, ui::displayable(kept.file_name()) + " has changes that were not downloaded",
          "They are kept until the next file is opened.", "file.previous"};
}

std::string opened_text(const Session& session) {
  const Document& document = session.document;
  const Diagnostics& found = document.diagnostics();
  const int problems = found.count(Severity::Warning) + found.count(Severity::Error);
  std::string text = fmt::format("Opened {}: {}, {}", ui::displayable(document.file_name()),
                                 counted(document.skeleton().joint_count(), "joint"),
                                 counted(document.motion().frame_count(), "frame"));
  if (problems > 0) text += ", " + counted(problems, "problem");
  return text + ".";
}

// The bytes are not kept: what the report shows of them is taken now.
std::vector<TextExcerpt> find_excerpts(const Document& document, std::string_view bytes) {
  std::string converted;
  std::vector<TextPlace> places;
  for (const Diagnostic& diagnostic : document.diagnostics().list()) places.push_back(diagnostic.place);
  return make_excerpts(text_in_utf8(bytes, converted), places);
}

bool is_sample_file(std::string_view file_name) {
  for (const Sample& sample : kSamples) {
    if (file_name == std::string(sample.id) + ".bvh") return true;
  }
  return false;
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
}

App::~App() = default;

Status App::open_file(std::string file_name, std::string_view bytes) {
  Workspace& workspace = parts_->workspace;
  Result<BvhClip> clip =
      read_opened_file(file_name, bytes, workspace.has_clip() ? &workspace.session.document : nullptr);
  parts_->settling_frames = 2;
  if (!clip) {
    workspace.messages.add(refusal_message(file_name, clip.error(), workspace.has_clip()));
    const Message& message = workspace.messages.list().front();
    workspace.backend.announce(message.title + ". " + message.detail);
    return clip.error();
  }
  Session opened = Session::open(std::move(clip.value()), std::move(file_name));
  opened.excerpts = find_excerpts(opened.document, bytes);
  workspace.open(std::move(opened));
  // The root is selected, so that the first thing the curve editor shows is curves.
  workspace.session.selection.select_only(0);
  workspace.messages.clear();
  if (workspace.previous) workspace.messages.add(kept_message(workspace.previous->document));
  if (!is_sample_file(workspace.session.document.file_name())) {
    workspace.overlay = Overlay::None;
    workspace.preferences.welcome_seen = true;
  }
  workspace.session.playback.set_playing(workspace.overlay == Overlay::Welcome && workspace.has_frames());
  workspace.notify(opened_text(workspace.session));
  return {};
}

const Scene& App::scene() const { return parts_->scene; }
const UiItems& App::items() const { return parts_->items; }
float App::css_per_unit() const { return parts_->workspace.preferences.options.interface_scale; }
Session& App::session() { return parts_->workspace.session; }
std::string App::save_text() const { return parts_->workspace.session.document.save_text(); }

nlohmann::json App::run_command(std::string_view id, const nlohmann::json& args) {
  parts_->settling_frames = 2;
  return parts_->commands.run(id, args);
}

}  // namespace marey::app
