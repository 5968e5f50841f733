#include "core/base/diagnostic.h"

#include <algorithm>

namespace marey {

std::string_view severity_name(Severity severity) {
  switch (severity) {
    case Severity::Note: return "note";
    case Severity::Warning: return "warning";
    case Severity::Error: return "error";
  }
  return "error";
}

void Diagnostics::add(Diagnostic diagnostic, std::string_view merge_key) {
  for (std::size_t i = 0; i < list_.size(); ++i) {
    if (list_[i].code == diagnostic.code && merge_keys_[i] == merge_key) {
      list_[i].count += diagnostic.count;
      return;
    }
  }
  list_.push_back(std::move(diagnostic));
  merge_keys_.emplace_back(merge_key);
}

bool Diagnostics::contains(DiagnosticCode code) const {
  return std::any_of(list_.begin(), list_.end(), [code](const Diagnostic& d) { return d.code == code; });
}

int Diagnostics::count(Severity severity) const {
  return static_cast<int>(
      std::count_if(list_.begin(), list_.end(), [severity](const Diagnostic& d) { return d.severity == severity; }));
}

}  // namespace marey
