#include "core/lint/turn_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/counted.h"
#include "core/base/stable_order.h"
#include "core/lint/curve_steps.h"
#include "core/lint/incidents.h"
#include "core/lint/wording.h"

namespace marey {
namespace {

// No angle turns by so much from frame to frame unless another name was chosen for the same rotation.
constexpr double kLeastLeap_deg = 90.0;
// A wrap is a leap of nearly a whole turn; the joint itself may turn on by the rest.
constexpr double kLeastWrap_deg = 300.0;
// Beyond this share of the leap the joint does turn, and other findings say so.
constexpr double kMostShareOfTurn = 0.4;

/// What leaps in one step of a joint.
struct Leap {
  bool is_flip = false;
  bool is_wrap = false;
  ChannelIndex channel = 0;  // of the largest leap
  double size_deg = 0.0;
};

/// All leaps of one joint of one kind.
struct LeapSeries {
  JointIndex joint = 0;
  Leap first_leap;
  FrameIndex first = 0;
  FrameIndex last = 0;
  int count = 0;
};

Leap leap_at(const Clip& clip, JointIndex joint, FrameIndex frame) {
  Leap leap;
  int leaping_angles = 0;
  for (int i = 0; i < clip.skeleton.channel_count(joint); ++i) {
    const ChannelIndex channel = clip.skeleton.first_channel(joint) + i;
    if (!is_rotation(clip.skeleton.channel(channel).kind)) continue;
    const auto samples = clip.motion.channel_samples(channel);
    const double step = std::abs(samples[idx(frame) + 1] - samples[idx(frame)]);
    if (!std::isfinite(step)) return {};
    leaping_angles += std::abs(std::remainder(step, 360.0)) >= kLeastLeap_deg ? 1 : 0;
    if (step >= kLeastWrap_deg) leap.is_wrap = true;
    if (step > leap.size_deg) leap = {leap.is_flip, leap.is_wrap, channel, step};
  }
  leap.is_flip = leaping_angles > 1;
  leap.is_wrap = leap.is_wrap && leaping_angles == 0;
  if (!leap.is_flip && !leap.is_wrap) return {};
  const double turn = lint::turn_between_deg(clip, joint, frame, frame + 1);
  return turn <= kMostShareOfTurn * std::min(leap.size_deg, 180.0) ? leap : Leap{};
}

/// Steps in which any angle of the joint leaps; `marks` has one entry per frame and is left all false.
template <class Visit>
void for_each_leap(const Clip& clip, JointIndex joint, FrameRange frames, std::vector<bool>& marks, Visit visit) {
  for (int i = 0; i < clip.skeleton.channel_count(joint); ++i) {
    const ChannelIndex channel = clip.skeleton.first_channel(joint) + i;
    if (!is_rotation(clip.skeleton.channel(channel).kind)) continue;
    const auto samples = clip.motion.channel_samples(channel);
    for (FrameIndex frame = frames.first; frame + 1 < frames.end(); ++frame) {
      if (std::abs(samples[idx(frame) + 1] - samples[idx(frame)]) >= kLeastLeap_deg) marks[idx(frame)] = true;
    }
  }
  for (FrameIndex frame = frames.first; frame + 1 < frames.end(); ++frame) {
    if (!marks[idx(frame)]) continue;
    marks[idx(frame)] = false;
    visit(frame);
  }
}

void count_leap(JointIndex joint, const Leap& leap, FrameIndex frame, std::vector<LeapSeries>& all) {
  if (all.empty() || all.back().joint != joint) all.push_back({joint, leap, frame, frame, 0});
  all.back().last = frame;
  ++all.back().count;
}

std::string sentence_about(const Clip& clip, FindingKind kind, const LeapSeries& series) {
  const Leap& leap = series.first_leap;
  const std::string where = fmt::format("between frames {} and {}", series.first + 1, series.first + 2);
  const std::string times = series.count > 1 ? fmt::format("; {} such steps up to frame {}", series.count, series.last + 2) : "";
  const std::string turn = lint::rounded(leap.size_deg);
  if (kind == FindingKind::AngleWrap) {
    return fmt::format("{} leaps by {} degrees {}, a whole turn that the pose does not show{}.",
                       lint::quoted(channel_label(clip.skeleton, leap.channel)), turn, where, times);
  }
  return fmt::format("The angles of {} leap by up to {} degrees {}, while the joint turns by {} only{}.",
                     lint::quoted(clip.skeleton.name(series.joint)), turn, where,
                     lint::rounded(lint::turn_between_deg(clip, series.joint, series.first, series.first + 1)), times);
}

void add_series(FindingKind kind, const Clip& clip, std::vector<LeapSeries> all, const LintOptions& options,
                LintReport& report) {
  report.left_out[static_cast<std::size_t>(kind)] =
      lint::keep_worst(all, options.most_per_kind, [](const LeapSeries& series) { return series.count; });
  sort_stably(all, [](const LeapSeries& a, const LeapSeries& b) { return a.first < b.first; });
  for (const LeapSeries& series : all) {
    report.findings.push_back({kind, series.joint, series.first_leap.channel,
                               FrameRange{series.first, series.last - series.first + 2}, series.count,
                               sentence_about(clip, kind, series)});
  }
}

}  // namespace

void add_turn_findings(const Clip& clip, FrameRange frames, const LintOptions& options, LintReport& report) {
  if (!lint::is_recording(clip.motion)) return;
  std::vector<LeapSeries> wraps;
  std::vector<LeapSeries> flips;
  std::vector<bool> marks(idx(clip.motion.frame_count()));
  for (JointIndex joint = 0; joint < clip.skeleton.joint_count(); ++joint) {
    for_each_leap(clip, joint, frames, marks, [&](FrameIndex frame) {
      const Leap leap = leap_at(clip, joint, frame);
      if (leap.is_flip) count_leap(joint, leap, frame, flips);
      if (leap.is_wrap) count_leap(joint, leap, frame, wraps);
    });
  }
  add_series(FindingKind::AngleWrap, clip, std::move(wraps), options, report);
  add_series(FindingKind::GimbalFlip, clip, std::move(flips), options, report);
}

}  // namespace marey
