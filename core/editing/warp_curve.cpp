#include "core/editing/warp_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/index.h"
#include "core/base/number_text.h"
#include "core/motion/resampling.h"

namespace marey {
namespace {

Error refusal(std::string message) { return {DiagnosticCode::InvalidArgument, {}, std::move(message), {}, {}}; }

std::optional<double> parse_frame(std::string_view text) {
  const NumberRead read = read_number(text);
  const bool is_frame = !text.empty() && read.length == text.size() && std::isfinite(read.value) && read.value >= 1.0;
  return is_frame ? std::optional(read.value - 1.0) : std::nullopt;
}

// Slopes of the monotone cubic at the points: the harmonic mean of the secants, weighted by their lengths.
std::vector<double> make_slopes(const std::vector<WarpPoint>& p) {
  std::vector<double> secants;
  for (std::size_t i = 1; i < p.size(); ++i) secants.push_back((p[i].from - p[i - 1].from) / (p[i].to - p[i - 1].to));
  std::vector<double> slopes = {secants.front()};
  for (std::size_t i = 1; i + 1 < p.size(); ++i) {
    const double before = p[i].to - p[i - 1].to;
    const double behind = p[i + 1].to - p[i].to;
    const double wa = 2.0 * behind + before;
    const double wb = behind + 2.0 * before;
    slopes.push_back((wa + wb) / (wa / secants[i - 1] + wb / secants[i]));
  }
  slopes.push_back(secants.back());
  return slopes;
}

double hermite(const WarpPoint& a, const WarpPoint& b, double slope_a, double slope_b, double to) {
  const double h = b.to - a.to;
  const double t = (to - a.to) / h;
  const double t2 = t * t;
  const double t3 = t2 * t;
  return (2.0 * t3 - 3.0 * t2 + 1.0) * a.from + (t3 - 2.0 * t2 + t) * h * slope_a + (3.0 * t2 - 2.0 * t3) * b.from +
         (t3 - t2) * h * slope_b;
}

}  // namespace

Result<std::vector<WarpPoint>> parse_warp_points(std::string_view text) {
  std::vector<WarpPoint> points;
  while (!text.empty()) {
    const std::string_view pair = text.substr(0, text.find(','));
    text.remove_prefix(std::min(pair.size() + 1, text.size()));
    const std::size_t colon = std::min(pair.find(':'), pair.size());
    const auto from = parse_frame(pair.substr(0, colon));
    const auto to = parse_frame(pair.substr(std::min(colon + 1, pair.size())));
    if (!from || !to) return refusal(fmt::format("\"{}\" is not FRAME:FRAME, counted from 1, such as 50:80.", pair));
    if (!points.empty() && (*from <= points.back().from || *to <= points.back().to)) {
      return refusal(fmt::format("\"{}\" does not lie behind the point before it.", pair));
    }
    points.push_back({*from, *to});
  }
  return points;
}

Result<std::vector<double>> make_warped_times(std::vector<WarpPoint> points, int frame_count, double most) {
  const double last = frame_count - 1;
  std::erase_if(points, [last](const WarpPoint& point) { return point.from > last; });
  if (points.empty()) points.push_back({0.0, 0.0});
  if (points.front().from > 0.0) points.insert(points.begin(), {0.0, points.front().to - points.front().from});
  if (points.back().from < last) points.push_back({last, points.back().to + last - points.back().from});
  const double length = points.back().to - points.front().to;
  if (length + 1.0 > most) return refusal("The warp gives more frames than fit in memory.");
  if (points.size() == 1) return std::vector<double>{0.0};
  const std::vector<double> slopes = make_slopes(points);
  std::vector<double> times;
  std::size_t i = 0;
  for (int frame = 0; frame <= static_cast<int>(std::round(length)); ++frame) {
    const double to = points.front().to + frame;
    while (i + 2 < points.size() && to >= points[i + 1].to) ++i;
    const double place = hermite(points[i], points[i + 1], slopes[i], slopes[i + 1], to);
    times.push_back(std::clamp(snapped_to_frame(place), 0.0, last));
  }
  return times;
}

}  // namespace marey
