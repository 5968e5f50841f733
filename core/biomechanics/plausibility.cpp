#include "core/biomechanics/plausibility.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/counted.h"
#include "core/biomechanics/mechanics.h"

namespace marey {
namespace {

constexpr double kDeep_m = 0.02;
constexpr double kSlide_mps = 0.1;
constexpr double kLeastStature_m = 1.2;
constexpr double kMostStature_m = 2.2;
constexpr int kLeastFlightFrames = 5;
constexpr double kFallTolerance = 0.15;
constexpr double kClearlyBetter = 0.5;  // of the change of energy with the clip's frame time

double range_of(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return values.empty() ? 0.0 : *high - *low;
}

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

// The end frames have no velocity.
void judge_energy(const std::vector<BodyState>& states, double frame_time_s, Plausibility& found) {
  std::vector<double> kinetic;
  std::vector<double> potential;
  for (std::size_t i = 1; i + 1 < states.size(); ++i) {
    kinetic.push_back(states[i].kinetic_energy);
    potential.push_back(states[i].potential_energy);
  }
  const double kinetic_mean = mean_of(kinetic);
  const double potential_mean = mean_of(potential);
  double covariance = 0.0;
  double variance = 0.0;
  for (std::size_t i = 0; i < kinetic.size(); ++i) {
    covariance += (kinetic[i] - kinetic_mean) * (potential[i] - potential_mean);
    variance += (kinetic[i] - kinetic_mean) * (kinetic[i] - kinetic_mean);
  }
  const double scale = variance > 0.0 ? -covariance / variance : 0.0;
  const double height = range_of(potential);
  if (!(scale > 0.0) || !(height > 0.0)) return;
  const auto change_with = [&](double s) {
    std::vector<double> total;
    for (std::size_t i = 0; i < kinetic.size(); ++i) total.push_back(potential[i] + s * kinetic[i]);
    return range_of(total) / height;
  };
  found.best_frame_time_s = frame_time_s / std::sqrt(scale);
  found.energy_change = change_with(1.0);
  found.best_energy_change = change_with(scale);
}

void judge_flight(const std::vector<BodyState>& states, const Contacts& contacts, int up, Plausibility& found) {
  double sum = 0.0;
  for (std::size_t i = 1; i + 1 < states.size(); ++i) {
    const auto frame = static_cast<FrameIndex>(i);
    if (contacts.any_down(frame - 1) || contacts.any_down(frame) || contacts.any_down(frame + 1)) continue;
    sum -= states[i].com_acceleration[up];
    ++found.flight_frames;
  }
  if (found.flight_frames >= kLeastFlightFrames) found.fall_mps2 = sum / found.flight_frames;
}

void judge_floor(const BodyMotion& body, const Contacts& contacts, int up, Plausibility& found) {
  double slide = 0.0;
  int touching = 0;
  for (FrameIndex frame = 0; frame < body.frame_count; ++frame) {
    double lowest = 0.0;
    for (std::size_t p = 0; p < contacts.points.size(); ++p) {
      const JointState state = state_of_point(body.state(frame, contacts.points[p].joint), contacts.points[p].local_m);
      lowest = std::min(lowest, state.position[up] - contacts.floor_m);
      if (!contacts.is_down(frame, p) || frame == 0 || frame + 1 == body.frame_count) continue;
      glm::dvec3 along = state.velocity;
      along[up] = 0.0;
      slide += glm::length(along);
      ++touching;
    }
    found.deepest_m = std::max(found.deepest_m, -lowest);
    found.deep_frames += -lowest > kDeep_m ? 1 : 0;
  }
  found.has_contacts = touching > 0;
  if (touching > 0) found.slide_mps = slide / touching;
}

void describe_energy(const Plausibility& found, double frame_time_s, std::vector<std::string>& sentences) {
  if (!found.best_frame_time_s) return;
  const double best = *found.best_frame_time_s;
  if (found.best_energy_change > kClearlyBetter * found.energy_change) {
    sentences.push_back(fmt::format("Its energy changes by {:.0f} % of what a swing of this height holds; no other frame time makes that much less.",
                                    100.0 * found.energy_change));
  } else {
    sentences.push_back(fmt::format("With {:.4f} s a frame instead of {:.4f} s its energy would change by {:.0f} %, not {:.0f} %, of what a swing of "
                                    "this height holds: the frame time may be wrong.",
                                    best, frame_time_s, 100.0 * found.best_energy_change, 100.0 * found.energy_change));
  }
}

void describe_flight(const Plausibility& found, std::vector<std::string>& sentences) {
  if (!found.fall_mps2) return;
  const std::string frames = counted(found.flight_frames, "frame");
  if (std::abs(*found.fall_mps2 - found.gravity_mps2) <= kFallTolerance * kGravity_mps2) {
    sentences.push_back(fmt::format("In {} without contact it falls by {:.1f} m/s², as it should.", frames, *found.fall_mps2));
  } else {
    sentences.push_back(fmt::format("In {} without contact it falls by {:.1f} m/s² instead of {:.1f}: the unit of length or the frame time is off, "
                                    "or something holds it.",
                                    frames, *found.fall_mps2, found.gravity_mps2));
  }
}

void describe_floor(const Plausibility& found, std::vector<std::string>& sentences) {
  if (found.deep_frames > 0) {
    sentences.push_back(fmt::format("In {} a point is below the floor, by up to {:.0f} cm.", counted(found.deep_frames, "frame"),
                                    100.0 * found.deepest_m));
  }
  if (!found.has_contacts) return;
  if (found.slide_mps > kSlide_mps) {
    sentences.push_back(fmt::format("What touches the floor slides, by {:.2f} m/s on average.", found.slide_mps));
  } else {
    sentences.push_back(fmt::format("What touches the floor stands: it moves by {:.2f} m/s on average.", found.slide_mps));
  }
}

}  // namespace

Result<Plausibility> judge(const Clip& clip, const BodyModel& model, const Derivation& derivation) {
  const double unit = model.metres_per_unit.value_or(clip.settings.metres_per_unit);
  const double frame_time = clip.motion.frame_time_s();
  Result<BodyMotion> body = find_body_motion(clip, derivation, frame_time, unit);
  if (!body) return body.error();
  const int up = static_cast<int>(clip.settings.up_axis);
  const glm::dvec3 gravity = find_gravity(model.gravity_mps2, clip.settings.up_axis);
  std::vector<BodyState> states;
  for (FrameIndex frame = 0; frame < body->frame_count; ++frame) states.push_back(find_body_state(*body, model, gravity, frame));
  Plausibility found;
  found.gravity_mps2 = -gravity[up];
  found.stature_m = compute_stature(clip.skeleton) * unit;
  if (roots_stand_still(*body, clip.skeleton)) {
    judge_energy(states, frame_time, found);
    return found;
  }
  const Contacts contacts = apply_own_contacts(find_contacts(*body, clip.skeleton, clip.settings.up_axis), clip.body.contacts);
  judge_flight(states, contacts, up, found);
  judge_floor(*body, contacts, up, found);
  return found;
}

std::vector<std::string> describe(const Plausibility& found, double frame_time_s) {
  std::vector<std::string> sentences;
  if (found.stature_m >= kLeastStature_m && found.stature_m <= kMostStature_m) {
    sentences.push_back(fmt::format("A stature of {:.2f} m is that of a person.", found.stature_m));
  } else {
    sentences.push_back(fmt::format("A stature of {:.2f} m is not that of a grown person: look at the unit of length.", found.stature_m));
  }
  describe_energy(found, frame_time_s, sentences);
  describe_flight(found, sentences);
  describe_floor(found, sentences);
  return sentences;
}

}  // namespace marey
