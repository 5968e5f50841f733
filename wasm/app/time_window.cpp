#include "wasm/app/time_window.h"

#include <algorithm>

namespace marey::app {
namespace {

constexpr double kMarginShare = 0.02;
constexpr double kShortestFrames = 2.0;

// Half a screen of empty time on either side is as far as a clip may be pushed.
void keep_clip_in_sight(TimeWindow& window, int frame_count) {
  const double length = window.last - window.first;
  const double lowest = -0.5 * length;
  const double highest = std::max(lowest, frame_count - 1 - 0.5 * length);
  window.first = std::clamp(window.first, lowest, highest);
  window.last = window.first + length;
}

}  // namespace

float TimeWindow::x_of(double frame) const {
  return left + static_cast<float>((frame - first) / (last - first)) * (right - left);
}

double TimeWindow::frame_at(float x) const {
  return first + static_cast<double>((x - left) / (right - left)) * (last - first);
}

void TimeWindow::fit(int frame_count) { fit_range(0.0, std::max(1, frame_count - 1)); }

void TimeWindow::fit_range(double first_frame, double last_frame) {
  const double margin = std::max(0.5, (last_frame - first_frame) * kMarginShare);
  first = first_frame - margin;
  last = last_frame + margin;
}

void TimeWindow::zoom(float x, double factor, int frame_count) {
  const double about = frame_at(x);
  const double longest = std::max(kShortestFrames, 2.0 * frame_count);
  const double length = std::clamp((last - first) * factor, kShortestFrames, longest);
  const double share = (about - first) / (last - first);
  first = about - share * length;
  last = first + length;
  keep_clip_in_sight(*this, frame_count);
}

void TimeWindow::pan(double frames, int frame_count) {
  first += frames;
  last += frames;
  keep_clip_in_sight(*this, frame_count);
}

}  // namespace marey::app
