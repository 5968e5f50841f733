#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "wasm/app/workspace.h"

namespace marey::app {

/// Begins to read a file; one that is still being read is given up. `size`: its bytes, 0 if nobody knows. Without memory for
/// it, or without an open clip where the file goes with one, the message is shown in the page.
Status begin_loading(Workspace& workspace, std::string file_name, std::int64_t size, FileUse use);

/// Reads the next bytes. False if no more are wanted: the file cannot be read, or reading
/// was stopped.
bool feed_loading(Workspace& workspace, std::string_view bytes);

/// Shows frames that have come; in every frame.
void follow_loading(Workspace& workspace);

/// All bytes are fed: opens the clip, puts it beside the open one, or gives this one the masses of a model, and says what was
/// read. On an error the document that was open before is back and the message is shown in the page; `Cancelled` if reading was
/// stopped.
Status finish_loading(Workspace& workspace);

}  // namespace marey::app
