#pragma once

#include <string>
#include <string_view>

#include "wasm/platform/web/page.h"

/// What web/src/program.ts holds by its address: made by marey_create, it lives as long as the tab. A text comes in as its
/// address and its size in bytes, in memory from malloc that the caller releases. One that goes out stays in `result` until the next call.
struct PageBinding {
  marey::app::Page page;
  marey::app::FontFiles fonts;
  std::string result;
  std::string piece;  ///< of the file that is being read
};

inline std::string_view view_of(const char* data, size_t size) { return {data, size}; }
