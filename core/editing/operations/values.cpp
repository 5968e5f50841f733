#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "core/editing/curve_operations.h"
#include "core/editing/operations/families.h"
#include "core/editing/operations/new_samples.h"
#include "core/math/angle.h"
#include "core/motion/sampling.h"

namespace marey {
namespace {

using Outcome = Result<OperationOutcome>;

double mean_of(std::span<const double> values) {
  double sum = 0.0;
  int count = 0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    sum += value;
    ++count;
  }
  return count > 0 ? sum / count : 0.0;
}

// The sample that a choice of "mean", "first" or "last" stands for; the ends skip what is not finite.
double sample_named(std::string_view choice, std::span<const double> values) {
  if (choice == "mean") return mean_of(values);
  const auto is_finite = [](double v) { return std::isfinite(v); };
  if (choice == "first") {
    const auto found = std::find_if(values.begin(), values.end(), is_finite);
    return found == values.end() ? 0.0 : *found;
  }
  const auto found = std::find_if(values.rbegin(), values.rend(), is_finite);
  return found == values.rend() ? 0.0 : *found;
}

Outcome make_scale(const OperationCall& call) {
  const double factor = call.number("factor");
  const std::string_view pivot = call.choice("pivot");
  return make_curves_edit(call, [&](const Curve&, std::span<double> values) {
    const double about = pivot == "value" ? call.number("value") : sample_named(pivot, values);
    for (double& value : values) value = scaled_about(about, factor, value);
  });
}

Outcome make_offset(const OperationCall& call) {
  const double by = call.number("by");
  return make_mapped_edit(call, [by](double value) { return by == 0.0 ? value : value + by; });
}

// Where a shifted curve is read, in frames from the start of the range.
double read_place(double place, int count, std::string_view ends) {
  if (ends != "loop" || count == 0) return std::clamp(place, 0.0, count - 1.0);
  const double turn = std::fmod(place, count);
  return turn < 0.0 ? turn + count : turn;
}

Outcome make_time_offset(const OperationCall& call) {
  const double by = call.number("by");
  const std::string_view ends = call.choice("ends");
  return make_curves_edit(call, [&](const Curve& curve, std::span<double> values) {
    const std::span<const double> before = curve.samples.subspan(idx(curve.frames.first), idx(curve.frames.count));
    for (int i = 0; i < size_of(values); ++i) {
      const double place = read_place(i - by, size_of(values), ends);
      const auto frame = static_cast<std::size_t>(place);
      const double weight = place - std::floor(place);
      const double from = before[frame];
      const double to = before[(frame + 1) % before.size()];
      const double value = weight > 0.0 ? from + weight * (to - from) : from;
      if (std::isfinite(value)) values[idx(i)] = value;
    }
  });
}

// A number in [-1, 1) that depends on its three places alone (SplitMix64).
double noise_at(std::uint64_t seed, std::uint64_t channel, std::uint64_t place) {
  std::uint64_t z = seed * 0x9E3779B97F4A7C15u + channel * 0xD1B54A32D192ED03u + place * 0x8CB92BA72F3D8DD7u;
  for (int round = 0; round < 2; ++round) {
    z += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    z ^= z >> 31;
  }
  return static_cast<double>(z >> 11) * 0x1p-52 - 1.0;
}

Outcome make_noise(const OperationCall& call) {
  const double amplitude = call.number("amplitude");
  const double period = call.number("period");
  const auto seed = static_cast<std::uint64_t>(call.number("seed"));
  return make_curves_edit(call, [&](const Curve& curve, std::span<double> values) {
    const auto channel = static_cast<std::uint64_t>(curve.channel);
    for (int i = 0; i < size_of(values); ++i) {
      const double place = (curve.frames.first + i) / period;
      const auto whole = static_cast<std::uint64_t>(place);
      const double share = place - std::floor(place);
      const double eased = share * share * (3.0 - 2.0 * share);
      const double from = noise_at(seed, channel, whole);
      const double noise = from + eased * (noise_at(seed, channel, whole + 1) - from);
      if (amplitude != 0.0) values[idx(i)] += amplitude * noise;
    }
  });
}

Outcome make_reverse(const OperationCall& call) {
  return make_curves_edit(call, [](const Curve&, std::span<double> values) {
    // What is not finite stays in its place, so it takes no part.
    std::size_t low = 0;
    std::size_t high = values.size();
    while (low + 1 < high) {
      if (std::isfinite(values[low]) && std::isfinite(values[high - 1])) std::swap(values[low], values[high - 1]);
      ++low;
      --high;
    }
  });
}

Outcome make_hold(const OperationCall& call) {
  const std::string_view which = call.choice("at");
  return make_curves_edit(call, [&](const Curve&, std::span<double> values) {
    const double value = sample_named(which, values);
    std::fill(values.begin(), values.end(), value);
  });
}

constexpr std::string_view kPivots[] = {"value", "mean", "first", "last"};
constexpr OperationParameter kScale[] = {
    {.name = "factor", .label = "Factor", .help = "How much larger the distance from the pivot becomes.", .initial = 1.0,
     .least = -100.0, .most = 100.0},
    {.name = "pivot", .label = "Pivot", .help = "What stays: a given value, or the mean, first or last sample of each curve's range.",
     .kind = ParameterKind::Choice, .initial = 1.0, .most = 3.0, .choices = kPivots},
    {.name = "value", .label = "Value", .unit = "degrees or file units", .help = "The pivot where it is a given value.",
     .initial = 0.0, .least = -1e6, .most = 1e6}};
constexpr OperationParameter kOffset[] = {{.name = "by", .label = "By", .unit = "degrees or file units",
                                           .help = "What is added to each sample.", .initial = 0.0, .least = -1e6, .most = 1e6}};
constexpr std::string_view kEnds[] = {"hold", "loop"};
constexpr OperationParameter kTimeOffset[] = {
    {.name = "by", .label = "By", .unit = "frames", .help = "Later by so many frames; earlier below 0.", .initial = 0.0,
     .least = -1e6, .most = 1e6},
    {.name = "ends", .label = "Ends", .help = "What comes in at the end: the last sample held, or the range from its other end.",
     .kind = ParameterKind::Choice, .most = 1.0, .choices = kEnds}};
constexpr OperationParameter kNoise[] = {
    {.name = "amplitude", .label = "Amplitude", .unit = "degrees or file units", .help = "The farthest from the curve.",
     .initial = 1.0, .least = 0.0, .most = 1e6},
    {.name = "period", .label = "Period", .unit = "frames", .help = "Frames from one random number to the next; between them it flows.",
     .initial = 1.0, .least = 1.0, .most = 1e5},
    {.name = "seed", .label = "Seed", .help = "Another one gives other noise; the same one the same.",
     .kind = ParameterKind::Whole, .initial = 1.0, .least = 0.0, .most = 1e9}};
constexpr std::string_view kHeld[] = {"first", "last", "mean"};
constexpr OperationParameter kHold[] = {{.name = "at", .label = "Value of", .help = "Which sample of the range is held.",
                                         .kind = ParameterKind::Choice, .most = 2.0, .choices = kHeld}};

constexpr Operation kValues[] = {
    {.id = "scale", .label = "Scale", .group = "Values", .help = "Makes the distance from a pivot larger or smaller.",
     .parameters = kScale, .make = make_scale},
    {.id = "offset", .label = "Offset", .group = "Values", .help = "Adds a number to each sample.", .parameters = kOffset,
     .make = make_offset},
    {.id = "time-offset", .label = "Shift in time", .group = "Values",
     .help = "Moves curves to later or earlier frames within the range.", .parameters = kTimeOffset, .make = make_time_offset},
    {.id = "noise", .label = "Noise", .group = "Values", .help = "Adds random movement, the same for the same seed.",
     .parameters = kNoise, .make = make_noise},
    {.id = "reverse", .label = "Reverse", .group = "Values", .help = "Plays the range backwards.", .make = make_reverse},
    {.id = "hold", .label = "Hold", .group = "Values", .help = "Gives the whole range one value of each curve.",
     .parameters = kHold, .make = make_hold}};

}  // namespace

std::span<const Operation> value_operations() { return kValues; }

}  // namespace marey
