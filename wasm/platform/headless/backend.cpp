#include "wasm/platform/backend.h"

#include "wasm/platform/headless/headless_log.h"

namespace marey::app {

HeadlessLog& headless_log() {
  static HeadlessLog log;
  return log;
}

void Backend::ask_for_file(FileUse use) {
  HeadlessLog& log = headless_log();
  ++(use == FileUse::OtherClip ? log.other_requests : use == FileUse::BodyModel ? log.model_requests : log.file_requests);
}

void Backend::download(std::string_view file_name, std::string_view bytes) {
  headless_log().downloads.emplace_back(file_name, bytes);
}

void Backend::download_picture(std::string_view file_name, std::string_view svg, int) {
  headless_log().downloads.emplace_back(file_name, svg);
}

void Backend::load_sample(std::string_view sample_id) { headless_log().samples.emplace_back(sample_id); }

void Backend::stop_loading() { ++headless_log().stopped_loadings; }

void Backend::set_clipboard_text(std::string_view text) { headless_log().clipboard = text; }

void Backend::set_document_state(std::string_view file_name, bool dirty) {
  headless_log().file_name = file_name;
  headless_log().dirty = dirty;
}

void Backend::draw_after(double seconds) { headless_log().draw_after_s = seconds; }

void Backend::announce(std::string_view text) { headless_log().announcements.emplace_back(text); }

void Backend::report_fault(std::string_view text) { headless_log().faults.emplace_back(text); }

void Backend::store_preferences(std::string_view json) {
  headless_log().preferences = json;
  ++headless_log().preference_writes;
}

std::string Backend::load_preferences() { return headless_log().preferences; }

SystemPreferences Backend::system_preferences() { return headless_log().system; }

double Backend::now_ms() { return headless_log().now_ms; }

Backend::Memory Backend::memory() { return headless_log().memory; }

void Backend::set_mouse_cursor(std::string_view css_cursor) { headless_log().mouse_cursor = css_cursor; }

void Backend::open_link(std::string_view url) { headless_log().links.emplace_back(url); }

}  // namespace marey::app
