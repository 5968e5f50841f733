#include "cli/lint_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "cli/report.h"
#include "core/base/counted.h"

namespace marey::cli {
namespace {

/// What the reader calls the same thing.
std::optional<DiagnosticCode> find_code(FindingKind kind) {
  switch (kind) {
    case FindingKind::DuplicateName: return DiagnosticCode::DuplicateName;
    case FindingKind::SeveralRoots: return DiagnosticCode::SeveralRoots;
    case FindingKind::ZeroLengthBone: return DiagnosticCode::ZeroLengthBone;
    case FindingKind::LeafWithoutEndSite: return DiagnosticCode::LeafWithoutEndSite;
    default: return std::nullopt;
  }
}

bool says_the_same(const Diagnostic& diagnostic, const LintReport& lint) {
  return std::any_of(lint.findings.begin(), lint.findings.end(),
                     [&](const Finding& finding) { return find_code(finding.kind) == diagnostic.code; });
}

TextPlace place_of(const Finding& finding, const Diagnostics& diagnostics) {
  const auto code = find_code(finding.kind);
  const Diagnostic* same = code ? diagnostics.find(*code) : nullptr;
  return same != nullptr ? same->place : TextPlace{};
}

std::string sentences_of(const Finding& finding) {
  const FindingTraits& traits = traits_of(finding.kind);
  const std::string text = fmt::format("{} {}", finding.message, traits.suggestion);
  return traits.tools.empty() ? text : fmt::format("{} Known to stumble over it: {}.", text, fmt::join(traits.tools, ", "));
}

}  // namespace

void report_check(const std::string& file, const Diagnostics& diagnostics, const LintReport& lint) {
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    const bool is_told_below = diagnostic.severity == Severity::Note && says_the_same(diagnostic, lint);
    if (!is_told_below) report_diagnostic(file, diagnostic);
  }
  for (const Finding& finding : lint.findings) report_note(file, place_of(finding, diagnostics), sentences_of(finding));
  for (int kind = 0; kind < kFindingKindCount; ++kind) {
    const int count = lint.left_out[idx(kind)];
    if (count == 0) continue;
    report_note(file, {}, fmt::format("{} of the kind {} {} left out; the worst are above.", counted(count, "more finding"),
                                      traits_of(static_cast<FindingKind>(kind)).id, count == 1 ? "is" : "are"));
  }
}

}  // namespace marey::cli
