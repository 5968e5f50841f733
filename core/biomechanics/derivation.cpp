#include "core/biomechanics/derivation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/base/number_text.h"

namespace marey {
namespace {

/// The numbers of "7,3"; nothing if one is not.
std::optional<std::vector<double>> read_numbers(std::string_view text) {
  std::vector<double> numbers;
  while (true) {
    const std::string_view word = text.substr(0, text.find(','));
    const NumberRead read = read_number(word);
    if (read.length == 0 || read.length != word.size()) return std::nullopt;
    numbers.push_back(read.value);
    if (word.size() == text.size()) return numbers;
    text.remove_prefix(word.size() + 1);
  }
}

bool is_whole(double value, double least, double most) { return value == std::floor(value) && value >= least && value <= most; }

bool is_positive(double value) { return value > 0.0 && std::isfinite(value); }

}  // namespace

Result<Derivation> parse_derivation(std::string_view text) {
  constexpr double kMostWindow = 1001;
  const std::size_t colon = text.find(':');
  const std::string_view name = text.substr(0, colon);
  const auto numbers = colon == std::string_view::npos ? std::optional(std::vector<double>()) : read_numbers(text.substr(colon + 1));
  const std::size_t count = numbers ? numbers->size() : 0;
  Derivation result;
  if (name == "central" && numbers && count == 0) return result;
  result.kind = DerivationKind::Gcv;
  if (name == "gcv" && numbers && count == 0) return result;
  result.kind = DerivationKind::Butterworth;
  if (name == "butterworth" && count == 1 && is_positive((*numbers)[0])) {
    result.cutoff_hz = (*numbers)[0];
    return result;
  }
  result.kind = DerivationKind::Spline;
  if (name == "spline" && count == 2 && is_positive((*numbers)[0]) && is_positive((*numbers)[1])) {
    result.noise_deg = (*numbers)[0];
    result.noise_mm = (*numbers)[1];
    return result;
  }
  result.kind = DerivationKind::SavitzkyGolay;
  if (name == "savgol" && count == 2 && is_whole((*numbers)[0], 3, kMostWindow) && std::fmod((*numbers)[0], 2.0) == 1.0 &&
      is_whole((*numbers)[1], 2, (*numbers)[0] - 1)) {
    result.window = static_cast<int>((*numbers)[0]);
    result.degree = static_cast<int>((*numbers)[1]);
    return result;
  }
  return Error{DiagnosticCode::InvalidArgument,
               {},
               fmt::format("'{}' is not a way to differentiate: central, butterworth:HZ, savgol:WINDOW,DEGREE (an odd window of 3 or "
                           "more frames, a degree from 2 on below it), gcv or spline:DEG,MM (the noise in angles and places).",
                           text),
               "central, butterworth:HZ, savgol:N,P, gcv, spline:DEG,MM", std::string(text)};
}

int uncertain_end_frames(const Derivation& derivation, double rate_hz) {
  constexpr int kQuinticCoefficients = 6;
  switch (derivation.kind) {
    case DerivationKind::Central: return 1;
    case DerivationKind::Butterworth: return std::max(1, static_cast<int>(std::min(std::ceil(rate_hz / derivation.cutoff_hz), 1e6)));
    case DerivationKind::SavitzkyGolay: return std::max(1, derivation.window / 2);
    case DerivationKind::Gcv:
    case DerivationKind::Spline: return kQuinticCoefficients;
  }
  return 1;
}

std::string describe(const Derivation& derivation) {
  switch (derivation.kind) {
    case DerivationKind::Central: return "central";
    case DerivationKind::Butterworth: return fmt::format("butterworth:{}", derivation.cutoff_hz);
    case DerivationKind::SavitzkyGolay: return fmt::format("savgol:{},{}", derivation.window, derivation.degree);
    case DerivationKind::Gcv: return "gcv";
    case DerivationKind::Spline: return fmt::format("spline:{},{}", derivation.noise_deg, derivation.noise_mm);
  }
  return {};
}

}  // namespace marey
