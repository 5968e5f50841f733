#include "core/biomechanics/analysis_update.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

namespace marey {
namespace {

/// How many frames away a sample still tells.
int reach_of(const Derivation& derivation, double rate_hz) {
  constexpr int kOfDifferences = 2;
  constexpr double kPeriodsOfMemory = 5.2;  // after so many periods of the cut-off the filter has forgotten all but a millionth
  switch (derivation.kind) {
    case DerivationKind::Butterworth:
      return kOfDifferences + static_cast<int>(std::min(kPeriodsOfMemory * rate_hz / derivation.cutoff_hz, 1e8));
    case DerivationKind::SavitzkyGolay: return kOfDifferences + derivation.window;
    default: return kOfDifferences;
  }
}

FrameRange widened(FrameRange range, int by, int frame_count) {
  const FrameIndex first = static_cast<FrameIndex>(std::max<std::int64_t>(std::int64_t{range.first} - by, 0));
  const auto end = static_cast<FrameIndex>(std::min<std::int64_t>(std::int64_t{range.end()} + by, frame_count));
  return {first, end - first};
}

/// What a new piece of a column needs added to go on from the frame before it.
double step_to(const AnalysisColumn& column, double before, double now) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  switch (column.asked.quantity->kind) {
    case QuantityKind::PathLength:
    case QuantityKind::Work: return before - now;
    case QuantityKind::Angle:
    case QuantityKind::PlaneAngle: return kTurn * std::round((before - now) / kTurn);
    default: return 0.0;
  }
}

double finite(double value) { return std::isfinite(value) ? value : 0.0; }

/// Puts the frames [first, first + count) of `part`, whose own first frame is `part_first`, into a column.
void put_in(AnalysisColumn& column, std::span<const double> part, FrameIndex part_first, FrameRange frames) {
  const FrameIndex anchor = std::max(frames.first - 1, part_first);
  const double lift = finite(step_to(column, column.values[idx(anchor)], part[idx(anchor - part_first)]));
  const double last_before = column.values[idx(frames.end() - 1)];
  for (FrameIndex frame = frames.first; frame < frames.end(); ++frame) column.values[idx(frame)] = part[idx(frame - part_first)] + lift;
  // What follows keeps its own changes.
  const double shift = finite(step_to(column, column.values[idx(frames.end() - 1)], last_before));
  if (shift == 0.0) return;
  for (FrameIndex frame = frames.end(); frame < size_of(column.values); ++frame) column.values[idx(frame)] += shift;
}

}  // namespace

bool can_update_analysis(const Derivation& derivation) {
  return derivation.kind != DerivationKind::Gcv && derivation.kind != DerivationKind::Spline;
}

Status update_analysis(const Clip& clip, const AnalysisRequest& request, FrameRange changed, AnalysisTable& table) {
  const int frames = clip.motion.frame_count();
  const double frame_time_s = request.frame_time_s.value_or(clip.motion.frame_time_s());
  const int reach = reach_of(request.derivation, 1.0 / frame_time_s);
  const FrameRange wanted = widened(changed, reach, frames);
  // Twice as far, as the ends of what is computed are worth less.
  const FrameRange window = widened(wanted, reach, frames);
  if (changed.count <= 0 || wanted.count <= 0) return {};
  Clip part;
  part.skeleton = clip.skeleton;
  part.settings = clip.settings;
  part.motion = clip.motion.frames_of(window);
  AnalysisRequest of_part = request;
  if (table.support) of_part.settled = table.support->of_frames(window);
  const Result<AnalysisTable> fresh = analyse(part, of_part);
  if (!fresh) return fresh.error();
  for (std::size_t c = 0; c < std::min(table.columns.size(), fresh->columns.size()); ++c) {
    put_in(table.columns[c], fresh->columns[c].values, window.first, wanted);
  }
  return {};
}

}  // namespace marey
