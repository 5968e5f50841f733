#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostic_code.h"

namespace marey {

/// Place in a text: 1-based line and column (in bytes). 0 means that the finding has no place.
struct TextPlace {
  int line = 0;
  int column = 0;
  friend bool operator==(const TextPlace&, const TextPlace&) = default;
};

/// One finding about a file. `message` is a whole sentence for people; `expected` and `found` are set where they apply.
/// Repeated findings of one code are merged: `place` is that of the first, `count` says how many.
struct Diagnostic {
  DiagnosticCode code{};
  Severity severity = Severity::Warning;
  TextPlace place;
  std::string message;
  std::string expected;
  std::string found;
  int count = 1;
};

/// Ordered list of findings. Repeats of a code with the same merge key are counted, so a broken file with a million bad
/// rows yields a handful of entries.
class Diagnostics {
 public:
  /// Adds a finding, or counts it if one with the same code and the same `merge_key` exists. An empty key merges by code.
  void add(Diagnostic diagnostic, std::string_view merge_key = {});
  /// Counts one more of a finding that is in the list already; false if there is none. Cheap: nothing is formatted.
  bool count_repeat(DiagnosticCode code, std::string_view merge_key = {});
  /// Orders the list by place; findings without a place come last.
  void sort_by_place();
  /// Exchanges message, expected and found of every finding for what `rewrite` makes of them.
  template <class Rewrite>
  void rewrite_texts(Rewrite rewrite) {
    for (Diagnostic& diagnostic : list_) {
      diagnostic.message = rewrite(diagnostic.message);
      diagnostic.expected = rewrite(diagnostic.expected);
      diagnostic.found = rewrite(diagnostic.found);
    }
  }

  [[nodiscard]] const std::vector<Diagnostic>& list() const { return list_; }
  /// In the order of the list.
  [[nodiscard]] std::vector<TextPlace> places() const;
  [[nodiscard]] bool empty() const { return list_.empty(); }
  [[nodiscard]] bool contains(DiagnosticCode code) const { return find(code) != nullptr; }
  /// The first finding with this code, or null.
  [[nodiscard]] const Diagnostic* find(DiagnosticCode code) const;
  [[nodiscard]] int count(Severity severity) const;

 private:
  std::vector<Diagnostic> list_;
  std::vector<std::string> merge_keys_;
};

}  // namespace marey
