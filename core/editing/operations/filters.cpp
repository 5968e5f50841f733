#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/editing/operations/families.h"
#include "core/editing/operations/new_samples.h"
#include "core/signal/butterworth.h"
#include "core/signal/continued_curve.h"
#include "core/signal/gaps.h"
#include "core/signal/gaussian_smoothing.h"
#include "core/signal/median.h"
#include "core/signal/residual_analysis.h"
#include "core/signal/savitzky_golay.h"

namespace marey {
namespace {

using Outcome = Result<OperationOutcome>;

// What a filter makes of the whole curve, cut to the frames of the target.
template <class Filter>
OperationOutcome make_filtered_edit(const OperationCall& call, Filter filter) {
  std::vector<double> whole(idx(call.clip.motion.frame_count()));
  return make_curves_edit(call, [&](const Curve& curve, std::span<double> values) {
    filter(curve.samples, std::span<double>(whole));
    std::copy_n(whole.begin() + curve.frames.first, curve.frames.count, values.begin());
  });
}

Outcome make_smooth(const OperationCall& call) {
  const double sigma = call.number("sigma");
  return make_curves_edit(call, [sigma](const Curve& curve, std::span<double> values) {
    compute_gaussian_smoothed(curve.samples, curve.frames, sigma, values);
  });
}

// "0.5 to 12.3 Hz" of the cut-offs that were found.
std::string describe_cutoffs(std::span<const double> cutoffs) {
  const auto [least, most] = std::minmax_element(cutoffs.begin(), cutoffs.end());
  if (cutoffs.size() == 1) return fmt::format("The residuals suggest a cut-off of {:.2f} Hz.", *least);
  return fmt::format("The residuals suggest cut-offs of {:.2f} to {:.2f} Hz.", *least, *most);
}

Outcome make_butterworth_edit(const OperationCall& call) {
  const double rate_hz = 1.0 / call.clip.motion.frame_time_s();
  const double asked_hz = call.number("cutoff");
  if (asked_hz >= 0.5 * rate_hz) {
    return Error{DiagnosticCode::InvalidArgument, {},
                 fmt::format("'cutoff' is below half the frame rate, {:.6g} Hz, not {}.", 0.5 * rate_hz, asked_hz), {}, {}};
  }
  std::vector<double> found;
  OperationOutcome outcome = make_filtered_edit(call, [&](std::span<const double> curve, std::span<double> whole) {
    const double cutoff_hz = asked_hz > 0.0 ? asked_hz : analyse_residuals(curve, rate_hz).cutoff_hz;
    if (asked_hz == 0.0 && cutoff_hz > 0.0) found.push_back(cutoff_hz);
    if (cutoff_hz > 0.0) {
      compute_butterworth(curve, cutoff_hz, rate_hz, whole);
    } else {
      std::copy(curve.begin(), curve.end(), whole.begin());
    }
  });
  if (!found.empty()) outcome.notes.push_back(describe_cutoffs(found));
  const bool is_slow = asked_hz == 0.0 && rate_hz < 50.0;
  if (is_slow) outcome.notes.emplace_back("Below 50 frames a second the residuals hold little noise to measure.");
  return outcome;
}

Outcome make_savitzky_golay_edit(const OperationCall& call) {
  const SavitzkyGolay filter{.window = call.whole("window"), .degree = call.whole("degree")};
  return make_filtered_edit(call, [filter](std::span<const double> curve, std::span<double> whole) {
    compute_savitzky_golay(curve, filter, whole);
  });
}

Outcome make_median_edit(const OperationCall& call) {
  const int window = call.whole("window");
  return make_filtered_edit(
      call, [window](std::span<const double> curve, std::span<double> whole) { compute_median(curve, window, whole); });
}

Outcome make_despike_edit(const OperationCall& call) {
  const SpikeRule rule{call.whole("width"), call.number("times"), call.number("height")};
  int spikes = 0;
  OperationOutcome outcome = make_filtered_edit(call, [&](std::span<const double> curve, std::span<double> whole) {
    std::copy(curve.begin(), curve.end(), whole.begin());
    std::vector<FrameRange> found = find_spikes(curve, rule);
    const FrameRange range = call.target.frames;
    std::erase_if(found, [&](const FrameRange& run) { return run.end() <= range.first || run.first >= range.end(); });
    fill_gaps(whole, found, GapFill::Cubic);
    keep_missing(curve, whole);
    spikes += size_of(found);
  });
  outcome.notes.push_back(spikes == 1 ? "1 spike was taken out." : fmt::format("{} spikes were taken out.", spikes));
  return outcome;
}

Outcome make_fill_gaps_edit(const OperationCall& call) {
  const GapFill fill = call.choice("method") == "linear" ? GapFill::Linear : GapFill::Cubic;
  const int longest = call.whole("longest");
  const int still = call.whole("still");
  std::vector<double> whole(idx(call.clip.motion.frame_count()));
  const auto work = [&](const Curve& curve, std::span<double> values) {
    std::copy(curve.samples.begin(), curve.samples.end(), whole.begin());
    std::vector<FrameRange> gaps = find_gaps(curve.samples, still);
    if (longest > 0) std::erase_if(gaps, [longest](const FrameRange& gap) { return gap.count > longest; });
    fill_gaps(whole, gaps, fill);
    std::copy_n(whole.begin() + curve.frames.first, curve.frames.count, values.begin());
  };
  return make_curves_edit(call, work, Missing::AreFilled);
}

constexpr OperationParameter kSmooth[] = {
    {.name = "sigma", .label = "Width", .unit = "frames",
     .help = "Width of the bell that weighs the neighbours of a sample.", .initial = 2.0, .least = 0.1, .most = 1000.0}};
constexpr OperationParameter kButterworth[] = {
    {.name = "cutoff", .label = "Cut-off", .unit = "Hz",
     .help = "Faster movement is damped; 0 takes what the residuals of each curve suggest.", .initial = 6.0, .least = 0.0,
     .most = 1000.0}};
constexpr OperationParameter kSavitzkyGolay[] = {
    {.name = "window", .label = "Window", .unit = "frames", .help = "Samples that each polynomial is fitted to.",
     .kind = ParameterKind::Whole, .initial = 7.0, .least = 1.0, .most = 301.0, .odd = true},
    {.name = "degree", .label = "Degree", .help = "Degree of the polynomials; a higher one keeps higher peaks.",
     .kind = ParameterKind::Whole, .initial = 3.0, .least = 0.0, .most = 8.0}};
constexpr OperationParameter kMedian[] = {
    {.name = "window", .label = "Window", .unit = "frames", .help = "Samples of which the middle one is taken.",
     .kind = ParameterKind::Whole, .initial = 5.0, .least = 1.0, .most = 301.0, .odd = true}};
constexpr OperationParameter kDespike[] = {
    {.name = "width", .label = "Longest spike", .unit = "frames", .help = "Longer runs are movement.",
     .kind = ParameterKind::Whole, .initial = 3.0, .least = 1.0, .most = 30.0},
    {.name = "times", .label = "Times the usual step", .help = "How far a spike stands out, in usual steps from frame to frame.",
     .initial = 8.0, .least = 1.0, .most = 1000.0},
    {.name = "height", .label = "Least height", .unit = "degrees or file units", .help = "Lower spikes are left.",
     .initial = 1.0, .least = 0.0, .most = 1e6}};
constexpr std::string_view kGapMethods[] = {"cubic", "linear"};
constexpr OperationParameter kFillGaps[] = {
    {.name = "method", .label = "Method", .help = "A smooth curve or a straight line between the neighbours.",
     .kind = ParameterKind::Choice, .most = 1.0, .choices = kGapMethods},
    {.name = "longest", .label = "Longest gap", .unit = "frames", .help = "Longer gaps are left; 0 fills all.",
     .kind = ParameterKind::Whole, .initial = 0.0, .least = 0.0, .most = 1e6},
    {.name = "still", .label = "Still from", .unit = "frames",
     .help = "Values that repeat the one before so often are gaps too; 0 keeps them.", .kind = ParameterKind::Whole,
     .initial = 0.0, .least = 0.0, .most = 1e6}};

constexpr Operation kFilters[] = {
    {.id = "smooth", .label = "Smooth", .group = "Filter",
     .help = "Weighs each sample with its neighbours by a Gaussian bell.", .parameters = kSmooth, .make = make_smooth},
    {.id = "butterworth", .label = "Butterworth", .group = "Filter",
     .help = "Takes out what is faster than a cut-off, without lag, as biomechanics does.", .parameters = kButterworth,
     .make = make_butterworth_edit},
    {.id = "savitzky-golay", .label = "Savitzky-Golay", .group = "Filter",
     .help = "Fits a polynomial around each sample, which keeps peaks better than averaging.",
     .parameters = kSavitzkyGolay, .make = make_savitzky_golay_edit},
    {.id = "median", .label = "Median", .group = "Filter", .help = "Takes the middle of each sample's neighbourhood.",
     .parameters = kMedian, .make = make_median_edit},
    {.id = "despike", .label = "Remove spikes", .group = "Filter",
     .help = "Finds single frames that stand out from both sides, and puts a smooth curve in their place.",
     .parameters = kDespike, .make = make_despike_edit},
    {.id = "fill-gaps", .label = "Fill gaps", .group = "Filter",
     .help = "Gives samples that are missing, or stand still, a value from their neighbours.", .parameters = kFillGaps,
     .make = make_fill_gaps_edit}};

}  // namespace

std::span<const Operation> filter_operations() { return kFilters; }

}  // namespace marey
