#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "wasm/platform/web/memory_reserve.h"
#include "wasm/platform/web/page.h"

/// What web/src/program.ts holds by its address: made by marey_create, it lives as long as the tab. A text comes in as its
/// address and its size in bytes, in memory from malloc that the caller releases. One that goes out stays in `result` until the next call.
struct PageBinding {
  marey::app::MemoryReserve reserve;
  marey::app::Page page;
  marey::app::FontFiles fonts;
  std::string result;
  std::string piece;  ///< of the file that is being read
};

inline std::string_view view_of(const char* data, size_t size) { return {data, size}; }

/// Runs a call of the page. 1, and its value as JSON in the result, when it succeeds; 0, and {code, message, line,
/// column}, when it gives an error or throws.
int answer(PageBinding& binding, const std::function<marey::Result<nlohmann::json>()>& call);
