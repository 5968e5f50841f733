#pragma once

#include "core/document/document.h"
#include "tests/fuzz/input_bytes.h"

namespace marey::test {

/// Any edit there is, as the next bytes say: some are empty, change nothing or are to be refused.
[[nodiscard]] Edit take_edit(InputBytes& script, const Clip& clip);

}  // namespace marey::test
