#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/diagnostic.h"
#include "core/base/result.h"
#include "core/base/text_cursor.h"

namespace marey {

/// What one reading has to say about its text. In strict mode the first finding that the format does not allow becomes
/// the error. Once failed(), the reading stops; later findings are ignored.
class Report {
 public:
  Report(std::string_view text, bool strict) : places_(text), strict_(strict) {}

  /// A finding at a byte of the text, merged with earlier ones of its code.
  void add(DiagnosticCode code, std::size_t offset, std::string message, std::string expected = {},
           std::string found = {});
  /// A finding that has an entry of its own; beyond kMostEntries of one code they are merged.
  void add_each(DiagnosticCode code, std::size_t offset, std::string message, std::string expected = {},
                std::string found = {});
  /// Counts one more of a merged finding; false if there is none yet. For findings that may come by the million.
  bool count_repeat(DiagnosticCode code) { return diagnostics_.count_repeat(code); }

  /// The text cannot be read.
  void fail(DiagnosticCode code, std::size_t offset, std::string message, std::string expected = {},
            std::string found = {});
  /// As above, without a place.
  void fail_without_place(DiagnosticCode code, std::string message);

  /// Adds findings that were made before, with their places as they are.
  void take_over(const Diagnostics& findings);

  /// Goes on with places in the next part of the text: as in PlaceFinder.
  void move_on(std::string_view text, std::size_t begin) { places_.move_on(text, begin); }

  [[nodiscard]] TextPlace place_of(std::size_t offset) { return places_.place_of(offset); }

  /// What was noticed until now, in the order of finding.
  [[nodiscard]] const Diagnostics& found() const { return diagnostics_; }
  [[nodiscard]] bool strict() const { return strict_; }
  [[nodiscard]] bool failed() const { return error_.has_value(); }
  /// Precondition: failed().
  [[nodiscard]] const Error& error() const { return *error_; }
  /// The findings in order of their places; the report is empty afterwards.
  [[nodiscard]] Diagnostics take_diagnostics();

 private:
  static constexpr int kMostEntries = 64;

  void record(Diagnostic diagnostic, std::size_t offset, std::string_view merge_key);

  PlaceFinder places_;
  bool strict_;
  Diagnostics diagnostics_;
  std::array<int, kDiagnosticCodeCount> entries_{};
  std::optional<Error> error_;
};

}  // namespace marey
