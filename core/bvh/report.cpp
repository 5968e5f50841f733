#include "core/bvh/report.h"

#include <utility>

namespace marey {

void Report::record(Diagnostic diagnostic, std::size_t offset, std::string_view merge_key) {
  if (failed()) return;
  diagnostic.place = places_.place_of(offset);
  const DiagnosticTraits& traits = traits_of(diagnostic.code);
  diagnostic.severity = traits.severity;
  if (strict_ && traits.refused_when_strict) {
    error_ = Error{diagnostic.code, diagnostic.place, std::move(diagnostic.message), std::move(diagnostic.expected),
                   std::move(diagnostic.found)};
    return;
  }
  diagnostics_.add(std::move(diagnostic), merge_key);
}

void Report::add(DiagnosticCode code, std::size_t offset, std::string message, std::string expected, std::string found) {
  if (failed() || diagnostics_.count_repeat(code)) return;
  record({code, {}, {}, std::move(message), std::move(expected), std::move(found)}, offset, {});
}

void Report::add_each(DiagnosticCode code, std::size_t offset, std::string message, std::string expected,
                      std::string found) {
  int& entries = entries_[static_cast<std::size_t>(code)];
  if (entries >= kMostEntries && diagnostics_.count_repeat(code, "further")) return;
  const std::string key = entries >= kMostEntries ? "further" : std::to_string(offset);
  ++entries;
  record({code, {}, {}, std::move(message), std::move(expected), std::move(found)}, offset, key);
}

void Report::fail(DiagnosticCode code, std::size_t offset, std::string message, std::string expected,
                  std::string found) {
  if (failed()) return;
  error_ = Error{code, places_.place_of(offset), std::move(message), std::move(expected), std::move(found)};
}

void Report::fail_without_place(DiagnosticCode code, std::string message) {
  if (!failed()) error_ = Error{code, {}, std::move(message), {}, {}};
}

void Report::take_over(const Diagnostics& findings) {
  for (const Diagnostic& diagnostic : findings.list()) diagnostics_.add(diagnostic);
}

Diagnostics Report::take_diagnostics() {
  diagnostics_.sort_by_place();
  return std::exchange(diagnostics_, {});
}

}  // namespace marey
