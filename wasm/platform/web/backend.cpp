#include "wasm/platform/backend.h"

#include <emscripten/emscripten.h>
#include <emscripten/heap.h>
#include <malloc.h>

#include "wasm/platform/web/host.h"

namespace marey::app {

void Backend::ask_for_file(FileUse use) { marey_host_ask_for_file(static_cast<int>(use)); }

void Backend::download(std::string_view file_name, std::string_view bytes) {
  marey_host_download(file_name.data(), file_name.size(), bytes.data(), bytes.size());
}

void Backend::download_picture(std::string_view file_name, std::string_view svg, int pixel_width) {
  marey_host_download_picture(file_name.data(), file_name.size(), svg.data(), svg.size(), pixel_width);
}

void Backend::load_sample(std::string_view sample_id) { marey_host_load_sample(sample_id.data(), sample_id.size()); }

void Backend::stop_loading() { marey_host_stop_loading(); }

void Backend::set_clipboard_text(std::string_view text) { marey_host_set_clipboard_text(text.data(), text.size()); }

void Backend::set_document_state(std::string_view file_name, bool dirty) {
  marey_host_set_document_state(file_name.data(), file_name.size(), dirty ? 1 : 0);
}

void Backend::announce(std::string_view text) { marey_host_announce(text.data(), text.size()); }

void Backend::report_fault(std::string_view text) { marey_host_report_fault(text.data(), text.size()); }

void Backend::draw_after(double seconds) { marey_host_draw_after(1000.0 * seconds); }

void Backend::store_preferences(std::string_view json) { marey_host_store_preferences(json.data(), json.size()); }

std::string Backend::load_preferences() {
  std::string json(marey_host_load_preferences(nullptr, 0), '\0');
  marey_host_load_preferences(json.data(), json.size());
  return json;
}

SystemPreferences Backend::system_preferences() {
  const int bits = marey_host_system_preferences();
  return {.dark = (bits & 1) != 0,
          .reduced_motion = (bits & 2) != 0,
          .apple_keys = (bits & 4) != 0,
          .coarse_pointer = (bits & 8) != 0};
}

double Backend::now_ms() { return emscripten_get_now(); }

Backend::Memory Backend::memory() {
  return {.used = static_cast<std::size_t>(mallinfo().uordblks), .total = emscripten_get_heap_size()};
}

void Backend::set_mouse_cursor(std::string_view css_cursor) {
  marey_host_set_mouse_cursor(css_cursor.data(), css_cursor.size());
}

void Backend::open_link(std::string_view url) { marey_host_open_link(url.data(), url.size()); }

}  // namespace marey::app
