#include <imgui.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "core/base/diagnostic_code.h"
#include "core/editing/layer_edits.h"
#include "wasm/app/app_parts.h"
#include "wasm/app/widgets.h"

namespace marey::app {
namespace {

using nlohmann::json;

json optional_text(std::string_view text) { return text.empty() ? json(nullptr) : json(text); }

json joint_list(const Skeleton& skeleton) {
  json joints = json::array();
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    json channels = json::array();
    for (const Channel& channel : skeleton.channels(joint)) {
      channels.push_back(channel.kind == ChannelKind::Other ? ui::displayable(channel.other_name)
                                                            : std::string(channel_keyword(channel.kind)));
    }
    const glm::dvec3& offset = skeleton.offset(joint);
    joints.push_back({{"name", skeleton.name(joint)},
                      {"parent", skeleton.parent(joint)},
                      {"offset", {offset.x, offset.y, offset.z}},
                      {"channels", std::move(channels)}});
  }
  return joints;
}

json sample_runs(const SampleSelection& samples) {
  json runs = json::array();
  for (const SampleRun& run : samples.runs()) {
    runs.push_back({{"channel", run.channel}, {"first", run.frames.first}, {"count", run.frames.count}});
  }
  return runs;
}

json selection_state(const Session& session) {
  const Selection& selection = session.selection;
  const JointIndex active = selection.active_joint();
  return {{"joints", selection.joints()},
          {"activeJoint", active == kNoParent ? json(nullptr) : json(active)},
          {"channels", selection.shown_channels(session.document.skeleton())},
          {"samples", sample_runs(selection.samples())}};
}

json diagnostic_list(const Diagnostics& diagnostics) {
  json list = json::array();
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    list.push_back({{"severity", severity_name(diagnostic.severity)},
                    {"code", diagnostic_id(diagnostic.code)},
                    {"line", diagnostic.place.line},
                    {"column", diagnostic.place.column},
                    {"message", diagnostic.message},
                    {"count", diagnostic.count}});
  }
  return list;
}

json message_list(const Messages& messages) {
  json list = json::array();
  for (const Message& message : messages.list()) list.push_back({{"title", message.title}, {"detail", message.detail}});
  return list;
}

const char* axis_name(Axis axis) { return axis == Axis::X ? "X" : axis == Axis::Y ? "Y" : "Z"; }

void add_document(json& state, const Document& document) {
  const History& history = document.history();
  const ClipSettings& settings = document.settings();
  state["file"] = optional_text(ui::displayable(document.file_name()));
  state["joints"] = joint_list(document.skeleton());
  state["channels"] = document.motion().channel_count();
  state["frames"] = document.motion().frame_count();
  state["frameTime"] = document.motion().frame_time_s();
  state["dirty"] = document.is_dirty();
  state["undoDepth"] = history.undo_depth();
  state["redoDepth"] = history.redo_depth();
  state["undoName"] = optional_text(history.undo_name());
  state["redoName"] = optional_text(history.redo_name());
  state["diagnostics"] = diagnostic_list(document.diagnostics());
  state["positionRule"] = position_rule_id(settings.position_rule);
  state["upAxis"] = axis_name(settings.up_axis);
  state["metresPerUnit"] = settings.metres_per_unit;
  state["namesIn"] = traits_of(settings.names_in).id;
}

void add_layers(json& state, const Session& session) {
  const LayerStack& stack = session.document.clip().stack;
  json layers = json::array();
  for (const Layer& layer : stack.layers) {
    layers.push_back({{"name", ui::displayable(layer.name)},
                      {"mode", layer.mode == LayerMode::Override ? "override" : "additive"},
                      {"muted", layer.muted},
                      {"solo", layer.solo},
                      {"locked", layer.locked},
                      {"channels", layer.curves.size()},
                      {"keys", count_keys(layer.curves)}});
  }
  state["layers"] = std::move(layers);
  state["otherFile"] = session.others.empty() ? json() : json(ui::displayable(session.others.back()->file_name));
  state["otherFiles"] = json::array();
  for (const auto& other : session.others) state["otherFiles"].push_back(ui::displayable(other->file_name));
  state["activeLayer"] = session.active_layer + 1;
  state["keyedChannels"] = stack.keyed.size();
  state["ownKeys"] = count_keys(stack.keyed);
}

json line_values(const std::vector<PlotLine>& lines, FrameIndex frame) {
  json values = json::object();
  for (const PlotLine& line : lines) {
    const bool known = frame < size_of(line.values) && std::isfinite(line.values[idx(frame)]);
    values[line.component == 0 ? "value" : std::string(1, line.component)] = known ? json(line.values[idx(frame)]) : json(nullptr);
  }
  return values;
}

json band_values(const std::vector<PlotBand>& bands, FrameIndex frame) {
  json values = json::object();
  for (const PlotBand& band : bands) {
    if (frame >= size_of(band.low) || !std::isfinite(band.low[idx(frame)])) continue;
    values[band.component == 0 ? "value" : std::string(1, band.component)] = {band.low[idx(frame)], band.high[idx(frame)]};
  }
  return values;
}

json other_values(const AnalysisPlot& plot, FrameIndex frame) {
  json values = json::array();
  for (const OtherLines& other : plot.others) values.push_back(line_values(other.lines, frame));
  return values;
}

json analysis_state(const Workspace& workspace) {
  const Analysis& analysis = workspace.analysis;
  json plots = json::array();
  for (const AnalysisPlot& plot : analysis.plots()) {
    plots.push_back({{"quantity", plot.choice.quantity->name},
                     {"owner", plot.owner},
                     {"frame", plot.choice.frame},
                     {"unit", plot.unit},
                     {"values", line_values(plot.lines, workspace.session.playback.frame())},
                     {"others", other_values(plot, workspace.session.playback.frame())},
                     {"bands", band_values(plot.bands, workspace.session.playback.frame())}});
  }
  json contacts = json::array();
  for (const ContactRow& row : analysis.contacts()) {
    json frames = json::array();
    for (const ContactBar& bar : row.bars) {
      frames.push_back({{"first", bar.first}, {"count", bar.last - bar.first + 1}, {"touches", bar.touches}, {"own", bar.is_own}});
    }
    contacts.push_back({{"point", row.name}, {"frames", std::move(frames)}});
  }
  return {{"plots", std::move(plots)},
          {"contacts", std::move(contacts)},
          {"derivative", describe(analysis.derivation)},
          {"support", support_name(analysis.support)},
          {"problem", optional_text(analysis.problem())},
          {"notes", analysis.notes()}};
}

void add_playback(json& state, const Playback& playback) {
  state["frame"] = playback.frame();
  state["position"] = playback.position();
  state["playing"] = playback.is_playing();
  state["loop"] = playback.loops();
  state["speed"] = playback.speed();
  state["range"] = {{"first", playback.range().first}, {"count", playback.range().count}};
}

constexpr const char* kOverlayNames[] = {"none", "palette", "shortcuts", "about", "welcome", "save_as"};
constexpr const char* kSheetNames[] = {"none", "curves", "joints", "inspector"};

json performance_state(const Workspace& workspace) {
  const Performance& performance = workspace.performance;
  if (!workspace.preferences.options.show_performance) return nullptr;
  return {{"frameMs", performance.median_ms()},
          {"worstMs", performance.worst_ms()},
          {"drawCalls", performance.last().draw_calls},
          {"vertices", performance.last().vertices},
          {"framesPerSecond", performance.frames_per_second()},
          {"memoryUsed", performance.memory.used},
          {"memoryTotal", performance.memory.total},
          {"sampleBytes", workspace.session.document.motion().samples().size() * sizeof(double)}};
}

void add_interface(json& state, const AppParts& parts) {
  const Workspace& workspace = parts.workspace;
  state["theme"] = parts.theme.kind == ThemeKind::Dark ? "dark" : "light";
  state["themeChoice"] = theme_choice_name(workspace.preferences.theme);
  state["interfaceScale"] = workspace.preferences.options.interface_scale;
  state["compact"] = workspace.preferences.options.compact;
  state["overlay"] = kOverlayNames[static_cast<int>(workspace.overlay)];
  state["sheet"] = kSheetNames[static_cast<int>(workspace.preferences.sheet)];
  state["messages"] = message_list(workspace.messages);
  state["status"] = parts.status;
  const FileLoading* loading = workspace.loading.get();
  if (loading == nullptr) {
    state["loading"] = nullptr;
  } else {
    state["loading"] = {{"file", ui::displayable(loading->file_name())}, {"bytes", loading->fed_bytes()}, {"size", loading->size()}};
  }
  state["performance"] = performance_state(workspace);
}

}  // namespace

nlohmann::json App::state() const {
  json state = json::object();
  add_document(state, parts_->workspace.session.document);
  add_layers(state, parts_->workspace.session);
  add_playback(state, parts_->workspace.session.playback);
  state["analysis"] = analysis_state(parts_->workspace);
  state["selection"] = selection_state(parts_->workspace.session);
  add_interface(state, *parts_);
  return state;
}

nlohmann::json App::commands() const {
  json list = json::array();
  for (const Command& command : parts_->commands.all()) {
    const std::string_view reason = CommandRegistry::blocked_reason(command);
    json entry = {{"id", command.id},
                  {"label", CommandRegistry::label_of(command).view()},
                  {"help", command.help},
                  {"shortcut", optional_text(command.shortcut)},
                  {"enabled", reason.empty()},
                  {"reason", optional_text(reason)}};
    if (command.checked) entry["checked"] = command.checked();
    list.push_back(std::move(entry));
  }
  return list;
}

}  // namespace marey::app
