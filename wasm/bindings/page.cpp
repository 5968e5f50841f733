#include <emscripten/emscripten.h>
#include <malloc.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "wasm/app/faults.h"
#include "wasm/app/json_reading.h"
#include "wasm/bindings/page_binding.h"

namespace {

using marey::Result;
using marey::Status;
using nlohmann::json;

/// Compact JSON; bytes of a file that are not UTF-8 come out as U+FFFD.
void set_result(PageBinding& binding, const json& value) {
  binding.result = value.dump(-1, ' ', false, json::error_handler_t::replace);
}

json described(const marey::Error& error) {
  return {{"code", marey::diagnostic_id(error.code)},
          {"message", error.message},
          {"line", error.place.line},
          {"column", error.place.column}};
}

Result<json> described(const Status& status) {
  if (!status) return status.error();
  return json();
}

json described(const marey::app::Fault& fault) {
  if (fault.out_of_memory) return described(marey::app::out_of_memory("it"));
  return {{"code", "internal_error"}, {"message", fault.details}, {"line", 0}, {"column", 0}};
}

}  // namespace

int answer(PageBinding& binding, const std::function<Result<json>()>& call) {
  bool succeeded = false;
  const std::optional<marey::app::Fault> fault = marey::app::catch_fault([&] {
    const Result<json> result = call();
    succeeded = result.has_value();
    set_result(binding, succeeded ? *result : described(result.error()));
  });
  if (!fault) return succeeded ? 1 : 0;
  set_result(binding, described(*fault));
  return 0;
}

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
  const int started = answer(*binding, [&] { return described(binding->page.start(binding->fonts)); });
  binding->fonts = {};
  return started;
}

EMSCRIPTEN_KEEPALIVE void marey_resize(PageBinding* binding, float css_width, float css_height, float device_pixel_ratio) {
  binding->page.resize({css_width, css_height, device_pixel_ratio});
}

/// 1 when a further frame is wanted without new input, else 0; -1 with the error as the result when the program cannot go
/// on.
EMSCRIPTEN_KEEPALIVE int marey_frame(PageBinding* binding, double now_ms) {
  binding->reserve.refill();
  bool wants_more = false;
  const int drawn = answer(*binding, [&]() -> Result<json> {
    wants_more = binding->page.frame(now_ms);
    return json();
  });
  return drawn == 0 ? -1 : static_cast<int>(wants_more);
}

EMSCRIPTEN_KEEPALIVE void marey_forget_letters(PageBinding* binding) { binding->page.forget_letters(); }

EMSCRIPTEN_KEEPALIVE void marey_lose_context(PageBinding* binding) { binding->page.lose_context(); }

EMSCRIPTEN_KEEPALIVE int marey_restore_context(PageBinding* binding) {
  return answer(*binding, [&] { return described(binding->page.restore_context()); });
}

/// A file by pieces. `size`: its bytes, 0 if nobody knows. `use`: a FileUse.
EMSCRIPTEN_KEEPALIVE int marey_begin_loading(PageBinding* binding, const char* name, size_t name_size, double size, int use) {
  return answer(*binding, [&] {
    marey::app::App& app = binding->page.app();
    return described(app.begin_loading(std::string(view_of(name, name_size)), static_cast<std::int64_t>(size),
                                       static_cast<marey::app::FileUse>(use)));
  });
}

/// Where the next piece, of `size` bytes, is to be put; null if there is no memory for it.
EMSCRIPTEN_KEEPALIVE char* marey_piece(PageBinding* binding, size_t size) {
  const auto make_room = [&] { binding->piece.resize(std::max(size, binding->piece.size())); };
  return marey::app::catch_fault(make_room) ? nullptr : binding->piece.data();
}

/// Reads `size` bytes of the piece; 0 when no more are wanted.
EMSCRIPTEN_KEEPALIVE int marey_feed(PageBinding* binding, size_t size) {
  return binding->page.app().feed_loading(view_of(binding->piece.data(), size)) ? 1 : 0;
}

EMSCRIPTEN_KEEPALIVE int marey_finish_loading(PageBinding* binding) {
  binding->piece = {};
  return answer(*binding, [&] { return described(binding->page.app().finish_loading()); });
}

EMSCRIPTEN_KEEPALIVE void marey_cancel_loading(PageBinding* binding) {
  binding->piece = {};
  binding->page.app().cancel_loading();
}

/// The result is the file's bytes.
EMSCRIPTEN_KEEPALIVE int marey_save(PageBinding* binding) {
  std::string text;
  const int saved = answer(*binding, [&]() -> Result<json> {
    text = binding->page.app().save_text();
    return json();
  });
  if (saved != 0) binding->result = std::move(text);
  return saved;
}

EMSCRIPTEN_KEEPALIVE int marey_state(PageBinding* binding) {
  return answer(*binding, [&]() -> Result<json> { return binding->page.app().state(); });
}

EMSCRIPTEN_KEEPALIVE int marey_commands(PageBinding* binding) {
  return answer(*binding, [&]() -> Result<json> { return binding->page.app().commands(); });
}

/// `args`: JSON text; empty for none. The answer is {"error": ...} when the command is unknown or refused.
EMSCRIPTEN_KEEPALIVE int marey_run_command(PageBinding* binding, const char* id, size_t id_size, const char* args,
                                           size_t args_size) {
  return answer(*binding, [&]() -> Result<json> {
    const Result<json> parsed = args_size == 0 ? Result<json>(json()) : marey::app::read_json(view_of(args, args_size));
    if (!parsed) return json{{"error", "The arguments are not JSON."}};
    return binding->page.app().run_command(view_of(id, id_size), *parsed);
  });
}

/// Bytes of the program's memory that are taken.
EMSCRIPTEN_KEEPALIVE size_t marey_used_memory() { return static_cast<size_t>(mallinfo().uordblks); }

/// For web/host_library.js: carries an error of the page's JavaScript through the program. Takes `words` over; null
/// where there was no memory for them.
EMSCRIPTEN_KEEPALIVE void marey_throw(char* words, size_t size) {
  const std::string text(words == nullptr ? std::string_view("an error of the page") : view_of(words, size));
  std::free(words);
  throw std::runtime_error(text);
}

/// The visible widgets in CSS pixels.
EMSCRIPTEN_KEEPALIVE int marey_items(PageBinding* binding) {
  return answer(*binding, [&]() -> Result<json> {
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
    return items;
  });
}

}  // extern "C"
