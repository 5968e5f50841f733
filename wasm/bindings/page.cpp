#include <emscripten/emscripten.h>

#include <cstddef>
#include <nlohmann/json.hpp>

#include "wasm/bindings/page_binding.h"

namespace {

using marey::Status;
using nlohmann::json;

/// Compact JSON; bytes of a file that are not UTF-8 come out as U+FFFD.
void set_result(PageBinding& binding, const json& value) {
  binding.result = value.dump(-1, ' ', false, json::error_handler_t::replace);
}

/// 1 for success; for an error 0, and the error as JSON in the result.
int report(PageBinding& binding, const Status& status) {
  binding.result.clear();
  if (status) return 1;
  const marey::Error& error = status.error();
  set_result(binding, {{"code", marey::diagnostic_id(error.code)},
                       {"message", error.message},
                       {"line", error.place.line},
                       {"column", error.place.column}});
  return 0;
}

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE PageBinding* marey_create() { return new PageBinding; }

EMSCRIPTEN_KEEPALIVE const char* marey_result_data(const PageBinding* binding) { return binding->result.data(); }
EMSCRIPTEN_KEEPALIVE size_t marey_result_size(const PageBinding* binding) { return binding->result.size(); }

/// `role`: 0 text, 1 semibold, 2 mono, 3 icons. Call before marey_start.
EMSCRIPTEN_KEEPALIVE void marey_add_font(PageBinding* binding, int role, const std::byte* bytes, size_t size) {
  marey::app::FontFiles& fonts = binding->fonts;
  std::vector<std::byte>* const files[] = {&fonts.text, &fonts.semibold, &fonts.mono, &fonts.icons};
  if (role >= 0 && role < 4) files[role]->assign(bytes, bytes + size);
}

EMSCRIPTEN_KEEPALIVE int marey_start(PageBinding* binding) {
  const int started = report(*binding, binding->page.start(binding->fonts));
  binding->fonts = {};
  return started;
}

EMSCRIPTEN_KEEPALIVE void marey_resize(PageBinding* binding, float css_width, float css_height, float device_pixel_ratio) {
  binding->page.resize({css_width, css_height, device_pixel_ratio});
}

/// 1 when a further frame is wanted without new input.
EMSCRIPTEN_KEEPALIVE int marey_frame(PageBinding* binding, double now_ms) { return binding->page.frame(now_ms) ? 1 : 0; }

EMSCRIPTEN_KEEPALIVE void marey_forget_letters(PageBinding* binding) { binding->page.forget_letters(); }

EMSCRIPTEN_KEEPALIVE void marey_lose_context(PageBinding* binding) { binding->page.lose_context(); }

EMSCRIPTEN_KEEPALIVE int marey_restore_context(PageBinding* binding) {
  return report(*binding, binding->page.restore_context());
}

/// A file by pieces. `size`: its bytes, 0 if nobody knows.
EMSCRIPTEN_KEEPALIVE void marey_begin_loading(PageBinding* binding, const char* name, size_t name_size, double size) {
  binding->page.app().begin_loading(std::string(view_of(name, name_size)), static_cast<std::int64_t>(size));
}

/// Where the next piece, of `size` bytes, is to be put; null if there is no memory for it.
EMSCRIPTEN_KEEPALIVE char* marey_piece(PageBinding* binding, size_t size) {
  if (binding->piece.size() < size) binding->piece.resize(size);
  return binding->piece.data();
}

/// Reads `size` bytes of the piece; 0 when no more are wanted.
EMSCRIPTEN_KEEPALIVE int marey_feed(PageBinding* binding, size_t size) {
  return binding->page.app().feed_loading(view_of(binding->piece.data(), size)) ? 1 : 0;
}

EMSCRIPTEN_KEEPALIVE int marey_finish_loading(PageBinding* binding) {
  binding->piece = {};
  return report(*binding, binding->page.app().finish_loading());
}

EMSCRIPTEN_KEEPALIVE void marey_cancel_loading(PageBinding* binding) {
  binding->piece = {};
  binding->page.app().cancel_loading();
}

EMSCRIPTEN_KEEPALIVE void marey_save(PageBinding* binding) { binding->result = binding->page.app().save_text(); }

EMSCRIPTEN_KEEPALIVE void marey_state(PageBinding* binding) { set_result(*binding, binding->page.app().state()); }

EMSCRIPTEN_KEEPALIVE void marey_commands(PageBinding* binding) { set_result(*binding, binding->page.app().commands()); }

/// `args`: JSON text; empty for none. The result is JSON, {"error": ...} when the command is unknown or refused.
EMSCRIPTEN_KEEPALIVE void marey_run_command(PageBinding* binding, const char* id, size_t id_size, const char* args,
                                            size_t args_size) {
  const json parsed = args_size == 0 ? json() : json::parse(view_of(args, args_size), nullptr, false);
  if (parsed.is_discarded()) {
    set_result(*binding, {{"error", "The arguments are not JSON."}});
    return;
  }
  set_result(*binding, binding->page.app().run_command(view_of(id, id_size), parsed));
}

/// The visible widgets in CSS pixels.
EMSCRIPTEN_KEEPALIVE void marey_items(PageBinding* binding) {
  const float scale = binding->page.app().css_per_unit();
  json items = json::array();
  for (const marey::app::UiItem& item : binding->page.app().items().list()) {
    items.push_back({{"id", item.id},
                     {"label", item.label},
                     {"x", item.min.x * scale},
                     {"y", item.min.y * scale},
                     {"w", (item.max.x - item.min.x) * scale},
                     {"h", (item.max.y - item.min.y) * scale}});
  }
  set_result(*binding, items);
}

}  // extern "C"
