#pragma once

#include "wasm/app/file_loading.h"
#include "wasm/app/view_context.h"

namespace marey::app {

/// How far the reading of a file has come, over the full width below the title bar: megabytes, seconds left, and a button
/// that stops it. Not shown for files that are there at once.
class LoadingStrip {
 public:
  /// Height that draw() needs; 0 when there is nothing to show. `loading` may be null.
  [[nodiscard]] float height(const ViewContext& context, const FileLoading* loading) const;
  void draw(ViewContext& context, const FileLoading& loading);
};

/// "123 of 500 MB, 3 s left", "12 MB" where the size is not known.
[[nodiscard]] std::string progress_text(std::int64_t fed_bytes, std::int64_t size, double elapsed_s);

}  // namespace marey::app
