#include "wasm/app/opening.h"

#include <fmt/format.h>

#include <utility>

#include "core/base/counted.h"
#include "core/editing/clip_operations.h"
#include "wasm/app/faults.h"
#include "wasm/app/file_reading.h"
#include "wasm/app/samples.h"
#include "wasm/app/widgets.h"

namespace marey::app {
namespace {

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

std::string described(const std::string& file_name, const Skeleton& skeleton, const Motion& motion) {
  return fmt::format("{}: {}, {}", ui::displayable(file_name), counted(skeleton.joint_count(), "joint"),
                     counted(motion.frame_count(), "frame"));
}

std::string opened_text(const Session& session) {
  const Document& document = session.document;
  const Diagnostics& found = document.diagnostics();
  const int problems = found.count(Severity::Warning) + found.count(Severity::Error);
  std::string text = "Opened " + described(document.file_name(), document.skeleton(), document.motion());
  if (problems > 0) text += ", " + counted(problems, "problem");
  return text + ".";
}

bool is_sample_file(std::string_view file_name) {
  for (const Sample& sample : kSamples) {
    if (file_name == std::string(sample.id) + ".bvh") return true;
  }
  return false;
}

void leave_welcome(Workspace& workspace, std::string_view file_name) {
  if (is_sample_file(file_name)) return;
  workspace.overlay = Overlay::None;
  workspace.preferences.welcome_seen = true;
}

void refuse(Workspace& workspace, const std::string& file_name, const Error& error) {
  workspace.cancel_loading();
  workspace.messages.add(refusal_message(file_name, error, workspace.has_clip()));
  const Message& message = workspace.messages.list().front();
  workspace.backend.announce(message.title + ". " + message.detail);
}

void open_clip(Workspace& workspace, BvhClip clip) {
  const std::unique_ptr<FileLoading> loading = std::move(workspace.loading);
  Session opened = Session::open(std::move(clip), loading->file_name());
  opened.excerpts = loading->take_excerpts();
  // The root is selected, so that the first thing the curve editor shows is curves.
  opened.selection.select_only(0);
  Messages messages;
  if (const Document& kept = workspace.whole_document(); kept.is_dirty()) messages.add(kept_message(kept));
  std::string notice = opened_text(opened);
  workspace.open(std::move(opened));
  // From here on it is open: nothing takes memory to speak of.
  workspace.messages = std::move(messages);
  leave_welcome(workspace, loading->file_name());
  if (!workspace.keeps_view) {
    workspace.session.playback.set_playing(workspace.overlay == Overlay::Welcome && workspace.has_frames());
  }
  workspace.notify(std::move(notice));
}

void put_beside(Workspace& workspace, BvhClip clip) {
  const std::unique_ptr<FileLoading> loading = std::move(workspace.loading);
  auto other = std::make_shared<const OtherClip>(OtherClip{loading->file_name(), make_clip(std::move(clip))});
  std::string notice = "Read " + described(other->file_name, other->clip.skeleton, other->clip.motion) + ".";
  workspace.session.put_beside(std::move(other));
  workspace.notify(std::move(notice));
}

Status open_model(Workspace& workspace) {
  const std::unique_ptr<FileLoading> loading = std::move(workspace.loading);
  const Result<std::string> text = loading->finish_text();
  if (!text) return text.error();
  Session& session = workspace.session;
  const Result<BodyModel> model = read_opened_model(*text, session.document.skeleton());
  if (!model) return model.error();
  if (Status status = session.apply(make_model_edit(session.document.clip(), *model)); !status) return status;
  workspace.notify(fmt::format("Read {}: {}, {:.4g} kg.", ui::displayable(loading->file_name()), counted(size_of(model->segments), "segment"),
                               total_mass_kg(*model)));
  return {};
}

Status finish_and_open(Workspace& workspace) {
  if (workspace.loading->use() == FileUse::BodyModel) return open_model(workspace);
  const Document& whole = workspace.whole_document();
  Result<BvhClip> clip = workspace.loading->finish(whole.skeleton().joint_count() > 0 ? &whole : nullptr);
  if (!clip) return clip.error();
  if (workspace.loading->use() == FileUse::OtherClip) {
    put_beside(workspace, std::move(*clip));
  } else {
    open_clip(workspace, std::move(*clip));
  }
  return {};
}

std::string reading(const std::string& file_name) { return "reading " + ui::displayable(file_name); }

// A part for which there is no room is not shown: the whole is what counts.
void show_news(Workspace& workspace) {
  FileLoading& loading = *workspace.loading;
  (void)catch_fault([&] {
    std::optional<BvhClip> clip = loading.take_news();
    if (!clip) return;
    leave_welcome(workspace, loading.file_name());
    workspace.show_loaded_part(Session::open(std::move(*clip), loading.file_name()));
  });
}

}  // namespace

Status begin_loading(Workspace& workspace, std::string file_name, std::int64_t size, FileUse use) {
  workspace.cancel_loading();
  Status begun = with_memory_for(reading(file_name), [&]() -> Status {
    if (use == FileUse::OtherClip && !workspace.has_clip()) {
      return Error{DiagnosticCode::InvalidArgument, {}, "Open a file first; this one would stand beside it.", "", ""};
    }
    if (use == FileUse::BodyModel && !workspace.has_clip()) {
      return Error{DiagnosticCode::InvalidArgument, {}, "Open a clip first; a model gives its joints masses.", "", ""};
    }
    workspace.loading = std::make_unique<FileLoading>(file_name, size, use);
    return {};
  });
  if (!begun) refuse(workspace, file_name, begun.error());
  return begun;
}

bool feed_loading(Workspace& workspace, std::string_view bytes) {
  if (!workspace.loading) return false;
  FileLoading& loading = *workspace.loading;
  bool wants_more = false;
  const Status fed = with_memory_for(reading(loading.file_name()), [&]() -> Status {
    wants_more = loading.feed(bytes);
    return {};
  });
  if (!fed) loading.give_up(fed.error());
  return fed && wants_more;
}

void follow_loading(Workspace& workspace) {
  if (!workspace.loading) return;
  FileLoading& loading = *workspace.loading;
  if (!loading.begun_s) {
    loading.begun_s = workspace.now_s;
    workspace.backend.draw_after(FileLoading::kPatience_s + 0.02);
  }
  const bool is_late = workspace.now_s - *loading.begun_s >= FileLoading::kPatience_s;
  if (is_late && loading.use() == FileUse::Document) show_news(workspace);
}

Status finish_loading(Workspace& workspace) {
  if (!workspace.loading) return Error{DiagnosticCode::Cancelled, {}, "Reading the file was stopped.", "", ""};
  const std::string file_name = workspace.loading->file_name();
  Status opened = with_memory_for(reading(file_name), [&] { return finish_and_open(workspace); });
  if (!opened) refuse(workspace, file_name, opened.error());
  return opened;
}

}  // namespace marey::app
