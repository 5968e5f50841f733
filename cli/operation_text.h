#pragma once

#include <string>

#include "core/editing/operation.h"

namespace marey::cli {

/// One line for each operation: what `marey edit --list` prints.
[[nodiscard]] std::string operations_text();

/// An operation with its parameters: what `marey edit --help-operation` prints.
[[nodiscard]] std::string operation_text(const Operation& operation);

}  // namespace marey::cli
