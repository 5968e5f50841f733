#pragma once

#include <string>
#include <string_view>

#include "core/base/diagnostic.h"
#include "core/base/result.h"

namespace marey::cli {

/// "<stdin>" for "-", else the name itself: what messages call a file.
[[nodiscard]] std::string display_name(const std::string& file);

/// One line on standard error: "walk.bvh:12:3: error: The sentence." Without a place: "walk.bvh: error: ...".
void report_error(const std::string& file, TextPlace place, std::string_view sentence);
/// The same for a refusal of core.
void report_error(const std::string& file, const Error& error);
/// "marey: error: ..."
void report_usage_error(std::string_view sentence);

/// A finding as one line on standard error, with how often it occurs.
void report_diagnostic(const std::string& file, const Diagnostic& diagnostic);
/// One line on standard error: "walk.bvh:12:3: note: Sentences."
void report_note(const std::string& file, TextPlace place, std::string_view sentences);

/// Each finding of at least this severity as report_diagnostic() has it.
void report_diagnostics(const std::string& file, const Diagnostics& diagnostics, Severity least = Severity::Note);

}  // namespace marey::cli
