#include "wasm/views/curves/curves_state.h"

#include <algorithm>
#include <cmath>

namespace marey::app {
namespace {

constexpr float kSampleReach = 8.0f;
constexpr float kLineReach = 6.0f;
constexpr double kLeastAngleHeight = 1.0;
constexpr double kLeastLengthHeight = 0.02;  // statures

float square_distance(ImVec2 a, ImVec2 b) { return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y); }

ValueRange visible_values(std::span<const double> samples, double first, double last) {
  ValueRange range;
  const double end = static_cast<double>(samples.size()) - 1.0;
  const int from = static_cast<int>(std::clamp(std::floor(first), 0.0, std::max(end, 0.0)));
  const int to = static_cast<int>(std::clamp(std::ceil(last), -1.0, end));
  if (to >= from) range.add(samples.subspan(idx(from), idx(to - from + 1)));
  return range;
}

void merge(ValueRange& into, const ValueRange& range) {
  if (range.empty) return;
  into.add(range.low);
  into.add(range.high);
}

// Height of the curve under x, by the same straight line between samples that is drawn.
float line_y_at(std::span<const double> samples, const ValueAxis& axis, double frame) {
  const auto before = static_cast<std::size_t>(std::floor(frame));
  const std::size_t after = std::min(before + 1, samples.size() - 1);
  const double share = frame - static_cast<double>(before);
  return axis.y_of(samples[before] + share * (samples[after] - samples[before]));
}

struct Candidate {
  CurveHit hit;
  float reach = 1e9f;
};

void consider_samples(Candidate& best, std::span<const double> samples, ChannelIndex channel, const ValueAxis& axis,
                      const TimeWindow& time, ImVec2 point) {
  const int near = static_cast<int>(std::lround(time.frame_at(point.x)));
  const int spread = static_cast<int>(std::min(256.0, static_cast<double>(kSampleReach) * time.frames_per_unit())) + 1;
  const int first = std::max(0, near - spread);
  const int last = std::min(static_cast<int>(samples.size()) - 1, near + spread);
  float nearest = std::min(kSampleReach, best.reach) * std::min(kSampleReach, best.reach);
  for (int frame = first; frame <= last; ++frame) {
    const float gap = square_distance(point, {time.x_of(frame), axis.y_of(samples[idx(frame)])});
    if (!(gap < nearest)) continue;
    nearest = gap;
    best = {{channel, frame, true}, std::sqrt(gap)};
  }
}

void consider_line(Candidate& best, std::span<const double> samples, ChannelIndex channel, const ValueAxis& axis,
                   const TimeWindow& time, ImVec2 point) {
  const double frame = time.frame_at(point.x);
  if (frame < 0.0 || frame > static_cast<double>(samples.size() - 1)) return;
  const float gap = std::abs(line_y_at(samples, axis, frame) - point.y);
  // A sample within reach always wins over a line.
  if (gap <= kLineReach && gap + kSampleReach < best.reach) {
    best = {{channel, static_cast<int>(std::lround(frame)), false}, gap + kSampleReach};
  }
}

}  // namespace

bool update_shown_channels(CurvesState& state, const Session& session) {
  const Skeleton& skeleton = session.document.skeleton();
  session.selection.find_shown_channels(skeleton, state.shown_next);
  state.shows_angles = false;
  state.shows_lengths = false;
  for (const ChannelIndex channel : state.shown_next) {
    (is_rotation(skeleton.channel(channel).kind) ? state.shows_angles : state.shows_lengths) = true;
  }
  if (state.shown_next == state.shown) return false;
  std::swap(state.shown, state.shown_next);
  return true;
}

void fit_values(CurvesState& state, const Session& session, const TimeWindow& time) {
  ValueRange angles;
  ValueRange lengths;
  for (const ChannelIndex channel : state.shown) {
    const bool angle = is_rotation(session.document.skeleton().channel(channel).kind);
    merge(angle ? angles : lengths,
          visible_values(session.document.motion().channel_samples(channel), time.first, time.last));
  }
  if (!angles.empty) state.angles.fit(angles.low, angles.high, kLeastAngleHeight);
  const double stature = compute_stature(session.document.skeleton());
  const double least = kLeastLengthHeight * (stature > 0.0 ? stature : 1.0);
  if (!lengths.empty) state.lengths.fit(lengths.low, lengths.high, least);
}

void fit_selection(CurvesState& state, const Session& session, TimeWindow& time) {
  ValueRange frames;
  for (const SampleRun& run : session.selection.samples().runs()) {
    frames.add(run.frames.first);
    frames.add(run.frames.end() - 1);
  }
  if (frames.empty) {
    time.fit(session.document.motion().frame_count());
  } else {
    time.fit_range(frames.low, std::max(frames.high, frames.low + 1.0));
  }
  fit_values(state, session, time);
}

CurveHit find_curve_hit(const CurvesState& state, const Session& session, const TimeWindow& time, ImVec2 point) {
  Candidate best;
  for (const ChannelIndex channel : state.shown) {
    const auto samples = session.document.motion().channel_samples(channel);
    if (samples.empty()) continue;
    const ValueAxis& axis = state.axis_of(session.document.skeleton(), channel);
    consider_samples(best, samples, channel, axis, time, point);
    consider_line(best, samples, channel, axis, time, point);
  }
  return best.hit;
}

SampleSelection find_samples_in_box(const CurvesState& state, const Session& session, const TimeWindow& time,
                                    ImVec2 corner, ImVec2 opposite) {
  SampleSelection found;
  const int count = session.document.motion().frame_count();
  const int first = std::max(0, static_cast<int>(std::ceil(time.frame_at(std::min(corner.x, opposite.x)))));
  const int last = std::min(count - 1, static_cast<int>(std::floor(time.frame_at(std::max(corner.x, opposite.x)))));
  for (const ChannelIndex channel : state.shown) {
    const ValueAxis& axis = state.axis_of(session.document.skeleton(), channel);
    const double high = axis.value_at(std::min(corner.y, opposite.y));
    const double low = axis.value_at(std::max(corner.y, opposite.y));
    const auto samples = session.document.motion().channel_samples(channel);
    for (int frame = first; frame <= last; ++frame) {
      const int begin = frame;
      while (frame <= last && samples[idx(frame)] >= low && samples[idx(frame)] <= high) ++frame;
      if (frame > begin) found.add(channel, {begin, frame - begin});
    }
  }
  return found;
}

SampleSelection selected_samples_like(const Session& session, ChannelIndex channel) {
  const Skeleton& skeleton = session.document.skeleton();
  const bool angle = is_rotation(skeleton.channel(channel).kind);
  SampleSelection like;
  for (const SampleRun& run : session.selection.samples().runs()) {
    if (is_rotation(skeleton.channel(run.channel).kind) == angle) like.add(run.channel, run.frames);
  }
  return like;
}

const char* unit_of(ChannelKind kind) {
  if (is_rotation(kind)) return "°";
  return is_position(kind) ? "units" : "";
}

const char* short_name_of(const Channel& channel) {
  static constexpr const char* kNames[] = {"X pos", "Y pos", "Z pos",   "X",       "Y",
                                           "Z",     "X scale", "Y scale", "Z scale", "other"};
  return kNames[static_cast<int>(channel.kind)];
}

}  // namespace marey::app
