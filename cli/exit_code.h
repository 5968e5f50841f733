#pragma once

namespace marey::cli {

/// What the program ends with.
enum class ExitCode {
  Done = 0,
  CheckFailed = 1,
  BadInput = 2,  ///< the input or the usage is wrong; one line on standard error says why
};

}  // namespace marey::cli
