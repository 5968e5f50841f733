#include "cli/report.h"

#include <fmt/format.h>

#include <cstdio>

namespace marey::cli {
namespace {

/// A message stays one line whatever names it quotes.
std::string on_one_line(std::string_view text) {
  std::string line(text);
  for (char& c : line) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) c = ' ';
  }
  return line;
}

void report_line(const std::string& subject, TextPlace place, std::string_view severity, std::string_view sentence) {
  const std::string where = place.line > 0 ? fmt::format("{}:{}", place.line, place.column) + ":" : std::string();
  const std::string line = on_one_line(fmt::format("{}:{} {}: {}", subject, where, severity, sentence)) + '\n';
  std::fwrite(line.data(), 1, line.size(), stderr);
}

}  // namespace

std::string display_name(const std::string& file) { return file == "-" ? "<stdin>" : file; }

void report_error(const std::string& file, TextPlace place, std::string_view sentence) {
  report_line(display_name(file), place, severity_name(Severity::Error), sentence);
}

void report_error(const std::string& file, const Error& error) { report_error(file, error.place, error.message); }

void report_usage_error(std::string_view sentence) {
  report_line("marey", {}, severity_name(Severity::Error), sentence);
}

void report_diagnostic(const std::string& file, const Diagnostic& diagnostic) {
  const std::string repeats = diagnostic.count > 1 ? fmt::format(" ({} times)", diagnostic.count) : std::string();
  report_line(display_name(file), diagnostic.place, severity_name(diagnostic.severity), diagnostic.message + repeats);
}

void report_note(const std::string& file, TextPlace place, std::string_view sentences) {
  report_line(display_name(file), place, severity_name(Severity::Note), sentences);
}

void report_diagnostics(const std::string& file, const Diagnostics& diagnostics, Severity least) {
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    if (diagnostic.severity >= least) report_diagnostic(file, diagnostic);
  }
}

}  // namespace marey::cli
