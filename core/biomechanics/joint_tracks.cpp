#include "core/biomechanics/joint_tracks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/kinematics/pose.h"
#include "core/math/angle.h"
#include "core/math/rotation_vector.h"
#include "core/signal/butterworth.h"
#include "core/signal/rotation_filter.h"
#include "core/signal/savitzky_golay.h"
#include "core/signal/smoothing_spline.h"

namespace marey {
namespace {

/// Weights of neighbouring frames for value, first and second derivative at one frame.
struct Stencil {
  int first = 0;  ///< frame of the first weight, from the one that is judged
  std::vector<double> value;
  std::vector<double> velocity;
  std::vector<double> acceleration;
};

Stencil scaled(Stencil stencil, double rate_hz) {
  for (double& weight : stencil.velocity) weight *= rate_hz;
  for (double& weight : stencil.acceleration) weight *= rate_hz * rate_hz;
  return stencil;
}

Stencil mirrored(Stencil stencil) {
  stencil.first = 1 - size_of(stencil.value) - stencil.first;
  for (auto* weights : {&stencil.value, &stencil.velocity, &stencil.acceleration}) std::reverse(weights->begin(), weights->end());
  for (double& weight : stencil.velocity) weight = -weight;
  return stencil;
}

/// `end` is -1 at the first frame, 1 at the last one, else 0.
Stencil difference_stencil(int end, int frame_count) {
  if (frame_count == 1) return {0, {1}, {0}, {0}};
  if (end == 0) return {-1, {0, 1, 0}, {-0.5, 0, 0.5}, {1, -2, 1}};
  Stencil begin{0, {1, 0, 0, 0}, {-1.5, 2, -0.5, 0}, {2, -5, 4, -1}};
  if (frame_count == 2) begin = {0, {1, 0}, {-1, 1}, {0, 0}};
  if (frame_count == 3) begin = {0, {1, 0, 0}, {-1.5, 2, -0.5}, {1, -2, 1}};
  return end < 0 ? begin : mirrored(begin);
}

/// The stencils of a method, by where a frame lies in its window.
class Stencils {
 public:
  Stencils(const Derivation& derivation, int frame_count, double rate_hz)
      : derivation_(derivation), frame_count_(frame_count), rate_hz_(rate_hz) {}

  [[nodiscard]] const Stencil& at(FrameIndex frame) {
    const bool fits_polynomial = derivation_.kind == DerivationKind::SavitzkyGolay;
    const int half = fits_polynomial ? derivation_.window / 2 : 1;
    const int middle = frame_count_ > 2 * half ? std::clamp(frame, half, frame_count_ - 1 - half) : 0;
    int place = frame - middle;
    if (!fits_polynomial) place = frame == 0 ? -1 : frame == frame_count_ - 1 ? 1 : 0;
    const auto found = known_.find(place);
    if (found != known_.end()) return found->second;
    const Stencil stencil = fits_polynomial ? polynomial_stencil(place) : difference_stencil(place, frame_count_);
    return known_.emplace(place, scaled(stencil, rate_hz_)).first->second;
  }

 private:
  [[nodiscard]] Stencil polynomial_stencil(int place) const {
    const auto weights = [&](int derivative) {
      return make_savitzky_golay_weights({derivation_.window, derivation_.degree, derivative}, place);
    };
    return {-derivation_.window / 2 - place, weights(0), weights(1), weights(2)};
  }

  Derivation derivation_;
  int frame_count_;
  double rate_hz_;
  std::map<int, Stencil> known_;
};

void differentiate_rotations(JointTrack& track, Stencils& stencils) {
  const std::vector<glm::dquat> given = track.rotations;
  for (FrameIndex frame = 0; frame < size_of(given); ++frame) {
    const Stencil& stencil = stencils.at(frame);
    const glm::dquat here = given[idx(frame)];
    glm::dvec3 value(0.0);
    for (int k = 0; k < size_of(stencil.value); ++k) {
      const glm::dvec3 away = rotation_vector(given[idx(frame + stencil.first + k)] * glm::conjugate(here));
      value += stencil.value[idx(k)] * away;
      track.angular_velocities[idx(frame)] += stencil.velocity[idx(k)] * away;
      track.angular_accelerations[idx(frame)] += stencil.acceleration[idx(k)] * away;
    }
    track.rotations[idx(frame)] = rotation_by(value) * here;
  }
}

void differentiate_positions(PointTrack& track, Stencils& stencils) {
  const std::vector<glm::dvec3> given = track.positions;
  for (FrameIndex frame = 0; frame < size_of(given); ++frame) {
    const Stencil& stencil = stencils.at(frame);
    glm::dvec3 value(0.0);
    for (int k = 0; k < size_of(stencil.value); ++k) {
      const glm::dvec3& there = given[idx(frame + stencil.first + k)];
      value += stencil.value[idx(k)] * there;
      track.velocities[idx(frame)] += stencil.velocity[idx(k)] * there;
      track.accelerations[idx(frame)] += stencil.acceleration[idx(k)] * there;
    }
    track.positions[idx(frame)] = value;
  }
}

/// One component of vectors or quaternions over time.
template <class T>
std::vector<double> component_of(const std::vector<T>& values, int component) {
  std::vector<double> curve;
  curve.reserve(values.size());
  for (const T& value : values) curve.push_back(value[component]);
  return curve;
}

void filter_positions(std::vector<glm::dvec3>& positions, const CurveFilter& filter) {
  std::vector<double> filtered(positions.size());
  for (int c = 0; c < 3; ++c) {
    filter(component_of(positions, c), filtered);
    for (std::size_t i = 0; i < filtered.size(); ++i) positions[i][c] = filtered[i];
  }
}

/// From the derivatives of quaternions of any length: w = 2 Im(q' q*) / |q|^2 and its derivative.
void take_from_quaternions(JointTrack& track, const std::vector<glm::dquat>& first, const std::vector<glm::dquat>& second) {
  const auto imaginary = [](const glm::dquat& q) { return glm::dvec3(q.x, q.y, q.z); };
  for (std::size_t i = 0; i < first.size(); ++i) {
    const glm::dquat q = track.rotations[i];
    const double squared = glm::dot(q, q);
    const glm::dvec3 velocity = 2.0 * imaginary(first[i] * glm::conjugate(q)) / squared;
    track.angular_velocities[i] = velocity;
    track.angular_accelerations[i] =
        (2.0 * imaginary(second[i] * glm::conjugate(q)) - velocity * (2.0 * glm::dot(q, first[i]))) / squared;
    track.rotations[i] = glm::normalize(q);
  }
}

/// A spline through each of some curves that belong together: each with its own smoothing by cross-validation, or all with the
/// one that leaves the noise of `noisy` independent curves.
std::vector<SplineFit> fit_splines(const std::vector<std::vector<double>>& curves, const Derivation& derivation, double rate_hz,
                                   double noise_rms, int noisy) {
  std::vector<SplineFit> fits;
  const double residual = noise_rms * noise_rms * noisy * static_cast<double>(curves[0].size());
  const double lambda = derivation.kind == DerivationKind::Spline ? find_smoothing_for_residual(curves, rate_hz, residual) : 0.0;
  for (const std::vector<double>& curve : curves) {
    fits.push_back(derivation.kind == DerivationKind::Spline ? fit_smoothing_spline(curve, rate_hz, lambda)
                                                             : fit_smoothing_spline(curve, rate_hz));
  }
  return fits;
}

void fit_rotation_splines(JointTrack& track, int channels, const Derivation& derivation, double rate_hz) {
  std::vector<glm::dquat>& rotations = track.rotations;
  for (std::size_t i = 1; i < rotations.size(); ++i) {
    if (glm::dot(rotations[i - 1], rotations[i]) < 0.0) rotations[i] = -rotations[i];
  }
  std::vector<std::vector<double>> curves;
  for (int c = 0; c < 4; ++c) curves.push_back(component_of(rotations, c));
  // A small rotation has half its angle in a quaternion.
  const auto fits = fit_splines(curves, derivation, rate_hz, 0.5 * to_radians(derivation.noise_deg), channels);
  std::vector<glm::dquat> first(rotations.size());
  std::vector<glm::dquat> second(rotations.size());
  for (int c = 0; c < 4; ++c) {
    for (std::size_t i = 0; i < rotations.size(); ++i) {
      rotations[i][c] = fits[idx(c)].values[i];
      first[i][c] = fits[idx(c)].first[i];
      second[i][c] = fits[idx(c)].second[i];
    }
  }
  take_from_quaternions(track, first, second);
}

void fit_position_splines(PointTrack& track, const Derivation& derivation, double rate_hz) {
  std::vector<std::vector<double>> curves;
  for (int c = 0; c < 3; ++c) curves.push_back(component_of(track.positions, c));
  const auto moves = [](const std::vector<double>& curve) {
    return std::any_of(curve.begin(), curve.end(), [&](double value) { return value != curve[0]; });
  };
  const auto noisy = static_cast<int>(std::count_if(curves.begin(), curves.end(), moves));
  const auto fits = fit_splines(curves, derivation, rate_hz, 1e-3 * derivation.noise_mm, noisy);
  for (int c = 0; c < 3; ++c) {
    for (std::size_t i = 0; i < track.positions.size(); ++i) {
      track.positions[i][c] = fits[idx(c)].values[i];
      track.velocities[i][c] = fits[idx(c)].first[i];
      track.accelerations[i][c] = fits[idx(c)].second[i];
    }
  }
}

bool is_spline(const Derivation& derivation) {
  return derivation.kind == DerivationKind::Gcv || derivation.kind == DerivationKind::Spline;
}

CurveFilter butterworth_filter(const Derivation& derivation, double rate_hz) {
  return [=](std::span<const double> curve, std::span<double> result) {
    compute_butterworth(curve, derivation.cutoff_hz, rate_hz, result);
  };
}

void differentiate(JointTrack& track, int channels, const Derivation& derivation, double rate_hz) {
  track.angular_velocities.assign(track.rotations.size(), glm::dvec3(0.0));
  track.angular_accelerations = track.angular_velocities;
  if (is_spline(derivation)) {
    fit_rotation_splines(track, channels, derivation, rate_hz);
  } else {
    // So far back the filter remembers.
    const int reach = static_cast<int>(std::min(5.2 * rate_hz / derivation.cutoff_hz, 1e8));
    if (derivation.kind == DerivationKind::Butterworth) filter_rotations(track.rotations, reach, butterworth_filter(derivation, rate_hz));
    Stencils stencils(derivation, size_of(track.rotations), rate_hz);
    differentiate_rotations(track, stencils);
  }
  track.origin = differentiate_path(std::move(track.origin.positions), derivation, rate_hz);
}

std::vector<JointTrack> read_tracks(const Clip& clip, double metres_per_unit) {
  const Skeleton& skeleton = clip.skeleton;
  const int frames = clip.motion.frame_count();
  std::vector<JointTrack> tracks(idx(skeleton.joint_count()));
  for (JointTrack& track : tracks) {
    track.rotations.resize(idx(frames));
    track.origin.positions.resize(idx(frames));
  }
  LocalPose local;
  local.resize(skeleton);
  for (FrameIndex frame = 0; frame < frames; ++frame) {
    compute_local_pose(skeleton, clip.motion, frame, clip.settings.position_rule, local);
    for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
      tracks[idx(joint)].rotations[idx(frame)] = local.local_rotations[idx(joint)];
      tracks[idx(joint)].origin.positions[idx(frame)] = metres_per_unit * local.local_translations[idx(joint)];
    }
  }
  return tracks;
}

Status check(const Clip& clip, const Derivation& derivation, double rate_hz) {
  const auto refusal = [](std::string message) { return Error{DiagnosticCode::InvalidArgument, {}, std::move(message), {}, {}}; };
  constexpr int kLeastOfSpline = 6;
  const int frames = clip.motion.frame_count();
  const auto samples = clip.motion.samples();
  if (!std::all_of(samples.begin(), samples.end(), [](double sample) { return std::isfinite(sample); })) {
    return Error{DiagnosticCode::NotFinite, {}, "The clip has gaps. Fill them first: they have no velocity.", {}, {}};
  }
  if (derivation.kind == DerivationKind::Butterworth && 2.0 * derivation.cutoff_hz >= rate_hz) {
    return refusal(fmt::format("The cut-off is below half the frame rate, {:.4g} Hz, not {:.4g}.", 0.5 * rate_hz, derivation.cutoff_hz));
  }
  const int needed = derivation.kind == DerivationKind::SavitzkyGolay ? derivation.window
                     : is_spline(derivation)                            ? kLeastOfSpline
                                                                      : 0;
  if (frames >= needed) return {};
  return refusal(fmt::format("'{}' needs {} frames; the clip has {}.", describe(derivation), needed, frames));
}

}  // namespace

PointTrack differentiate_path(std::vector<glm::dvec3> positions, const Derivation& derivation, double rate_hz) {
  PointTrack track;
  track.positions = std::move(positions);
  track.velocities.assign(track.positions.size(), glm::dvec3(0.0));
  track.accelerations = track.velocities;
  if (is_spline(derivation)) {
    fit_position_splines(track, derivation, rate_hz);
    return track;
  }
  if (derivation.kind == DerivationKind::Butterworth) filter_positions(track.positions, butterworth_filter(derivation, rate_hz));
  Stencils stencils(derivation, size_of(track.positions), rate_hz);
  differentiate_positions(track, stencils);
  return track;
}

Result<std::vector<JointTrack>> find_joint_tracks(const Clip& clip, const Derivation& derivation, double frame_time_s,
                                                  double metres_per_unit) {
  const double rate_hz = 1.0 / frame_time_s;
  if (Status status = check(clip, derivation, rate_hz); !status) return status.error();
  std::vector<JointTrack> tracks = read_tracks(clip, metres_per_unit);
  for (JointIndex joint = 0; joint < size_of(tracks); ++joint) {
    const auto channels = clip.skeleton.channels(joint);
    const auto turning = std::count_if(channels.begin(), channels.end(), [](const Channel& c) { return is_rotation(c.kind); });
    differentiate(tracks[idx(joint)], static_cast<int>(turning), derivation, rate_hz);
  }
  return tracks;
}

}  // namespace marey
