#include <algorithm>
#include <cmath>

#include "core/editing/operations/families.h"
#include "core/editing/operations/new_samples.h"
#include "core/math/angle.h"

namespace marey {
namespace {

using Outcome = Result<OperationOutcome>;

double toward(double from, double to, double share) { return share == 0.0 ? from : from + share * (to - from); }

// How far the i-th frame of a range lies between the frame before the range (0) and the one behind it (1).
double way_through(int i, int count) { return (i + 1.0) / (count + 1.0); }

Outcome make_blend_neighbour(const OperationCall& call) {
  const double factor = call.number("factor");
  return make_curves_edit(call, [factor](const Curve& curve, std::span<double> values) {
    const double neighbour = factor < 0.0 ? curve.before() : curve.behind();
    for (double& value : values) value = toward(value, neighbour, std::abs(factor));
  });
}

// What a channel has in the rest pose.
double default_of(const Clip& clip, const Curve& curve) {
  const JointIndex joint = clip.skeleton.channel(curve.channel).joint;
  if (is_scale(curve.kind)) return 1.0;
  if (!is_position(curve.kind) || clip.skeleton.positions_add(joint, clip.settings.position_rule)) return 0.0;
  return clip.skeleton.offset(joint)[static_cast<int>(axis_of(curve.kind))];
}

Outcome make_blend_default(const OperationCall& call) {
  const double factor = call.number("factor");
  return make_curves_edit(call, [&](const Curve& curve, std::span<double> values) {
    const double rest = default_of(call.clip, curve);
    for (double& value : values) value = toward(value, rest, factor);
  });
}

Outcome make_blend_ease(const OperationCall& call) {
  const double factor = call.number("factor");
  return make_curves_edit(call, [factor](const Curve& curve, std::span<double> values) {
    const double from = curve.before();
    const double to = curve.behind();
    for (int i = 0; i < size_of(values); ++i) {
      const double t = way_through(i, size_of(values));
      const double ease = factor < 0.0 ? 1.0 - (1.0 - t) * (1.0 - t) * (1.0 - t) : t * t * t;
      values[idx(i)] = toward(values[idx(i)], toward(from, to, ease), std::abs(factor));
    }
  });
}

Outcome make_push_pull(const OperationCall& call) {
  const double factor = call.number("factor");
  return make_curves_edit(call, [factor](const Curve& curve, std::span<double> values) {
    const double from = curve.before();
    const double to = curve.behind();
    for (int i = 0; i < size_of(values); ++i) {
      const double line = toward(from, to, way_through(i, size_of(values)));
      if (factor != 1.0) values[idx(i)] = toward(line, values[idx(i)], factor);
    }
  });
}

Outcome make_breakdown(const OperationCall& call) {
  const double factor = call.number("factor");
  return make_curves_edit(call, [factor](const Curve& curve, std::span<double> values) {
    std::fill(values.begin(), values.end(), toward(curve.before(), curve.behind(), factor));
  });
}

Outcome make_match_slope(const OperationCall& call) {
  const double factor = call.number("factor");
  return make_curves_edit(call, [factor](const Curve& curve, std::span<double> values) {
    const int direction = factor < 0.0 ? -1 : 1;
    const FrameIndex near = direction < 0 ? curve.frames.first - 1 : curve.frames.end();
    const FrameIndex far = near + direction;
    if (std::min(near, far) < 0 || std::max(near, far) >= size_of(curve.samples)) return;
    const double start = curve.samples[idx(near)];
    const double step = start - curve.samples[idx(far)];
    if (!std::isfinite(step)) return;
    for (int i = 0; i < size_of(values); ++i) {
      const int distance = direction < 0 ? i + 1 : size_of(values) - i;
      values[idx(i)] = toward(values[idx(i)], start + step * distance, std::abs(factor));
    }
  });
}

// From 0 where the change begins to 1 at the end of the range: straight over the whole range, eased over a part of it.
double closing_share(int from_end, int count, int over) {
  if (over == 0 || over >= count) return count > 1 ? 1.0 - from_end / (count - 1.0) : 0.0;
  const double t = std::max(0.0, 1.0 - static_cast<double>(from_end) / over);
  return t * t * (3.0 - 2.0 * t);
}

Outcome make_loop_match(const OperationCall& call) {
  const std::string_view at = call.choice("at");
  const int over = call.whole("over");
  return make_curves_edit(call, [&](const Curve& curve, std::span<double> values) {
    const int count = size_of(values);
    const double first = values.front();
    double last = values.back();
    // Whole turns are no gap: a figure that has turned once may go on.
    if (is_rotation(curve.kind)) last = nearest_turn(last, first);
    const double gap = first - last;
    if (!std::isfinite(gap) || gap == 0.0) return;
    const double at_end = at == "end" ? 1.0 : at == "start" ? 0.0 : 0.5;
    for (int i = 0; i < count; ++i) {
      const double closing = at_end * closing_share(count - 1 - i, count, over) - (1.0 - at_end) * closing_share(i, count, over);
      values[idx(i)] += gap * closing;
    }
  });
}

constexpr OperationParameter kNeighbour[] = {{.name = "factor", .label = "Factor",
                                              .help = "Below 0 toward the sample before the range, above 0 toward the one behind it.",
                                              .initial = 0.5, .least = -1.0, .most = 1.0}};
constexpr OperationParameter kDefault[] = {{.name = "factor", .label = "Factor", .help = "How much of the way to the rest pose.",
                                            .initial = 0.5, .least = 0.0, .most = 1.0}};
constexpr OperationParameter kEase[] = {
    {.name = "factor", .label = "Factor", .help = "Above 0 a curve that starts slowly, below 0 one that ends slowly.",
     .initial = 0.5, .least = -1.0, .most = 1.0}};
constexpr OperationParameter kPushPull[] = {
    {.name = "factor", .label = "Factor", .help = "0 gives the straight line, 1 the curve as it is, more exaggerates it.",
     .initial = 1.0, .least = -10.0, .most = 10.0}};
constexpr OperationParameter kBreakdown[] = {
    {.name = "factor", .label = "Factor", .help = "0 gives the value before the range, 1 the one behind it.", .initial = 0.5,
     .least = 0.0, .most = 1.0}};
constexpr OperationParameter kMatchSlope[] = {
    {.name = "factor", .label = "Factor", .help = "Below 0 the slope before the range, above 0 the one behind it.",
     .initial = -1.0, .least = -1.0, .most = 1.0}};
constexpr std::string_view kPlaces[] = {"end", "start", "both"};
constexpr OperationParameter kLoop[] = {
    {.name = "at", .label = "Change", .help = "Which end of the range gives way.", .kind = ParameterKind::Choice, .most = 2.0,
     .choices = kPlaces},
    {.name = "over", .label = "Over", .unit = "frames", .help = "Frames that take part in the change; 0 spreads it over the range.",
     .kind = ParameterKind::Whole, .initial = 0.0, .least = 0.0, .most = 1e6}};

constexpr Operation kBlends[] = {
    {.id = "blend-neighbour", .label = "Blend to neighbour", .group = "Blend",
     .help = "Draws the range toward the sample before or behind it.", .parameters = kNeighbour, .make = make_blend_neighbour},
    {.id = "blend-default", .label = "Blend to default", .group = "Blend",
     .help = "Draws the range toward the rest pose.", .parameters = kDefault, .make = make_blend_default},
    {.id = "blend-ease", .label = "Blend to ease", .group = "Blend",
     .help = "Draws the range toward an eased curve between its neighbours.", .parameters = kEase, .make = make_blend_ease},
    {.id = "push-pull", .label = "Push and pull", .group = "Blend",
     .help = "Makes the distance from the straight line between the neighbours larger or smaller.", .parameters = kPushPull,
     .make = make_push_pull},
    {.id = "breakdown", .label = "Breakdown", .group = "Blend",
     .help = "Gives the range one value between its neighbours.", .parameters = kBreakdown, .make = make_breakdown},
    {.id = "match-slope", .label = "Match slope", .group = "Blend",
     .help = "Continues the curve before or behind the range straight into it.", .parameters = kMatchSlope,
     .make = make_match_slope},
    {.id = "loop-match", .label = "Match loop", .group = "Blend",
     .help = "Lets the range end as it starts; whole turns are no difference.", .parameters = kLoop, .make = make_loop_match}};

}  // namespace

std::span<const Operation> blend_operations() { return kBlends; }

}  // namespace marey
