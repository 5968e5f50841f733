#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/biomechanics/body_model.h"
#include "core/biomechanics/derivation.h"
#include "core/biomechanics/support.h"
#include "core/motion/clip.h"

namespace marey {

/// What speaks for or against a clip's unit of length, frame time and floor.
struct Plausibility {
  double stature_m = 0.0;
  /// Of a body that hangs on a pivot: the frame time with which its energy changes least, as a swing that nothing drives would
  /// have it. Kinetic energy goes by the inverse square of the frame time, so it is the least square of PE + s KE.
  std::optional<double> best_frame_time_s;
  double energy_change = 0.0;       ///< range of the total energy with the clip's frame time, of its range of potential energy
  double best_energy_change = 0.0;  ///< the same with the best one
  /// Mean acceleration of the centre of mass down the up axis while nothing touches the ground, in m/s2.
  std::optional<double> fall_mps2;
  double gravity_mps2 = 0.0;  ///< what it should be
  int flight_frames = 0;
  double deepest_m = 0.0;  ///< how far a point goes below the floor
  int deep_frames = 0;     ///< in which a point is more than 2 cm below the floor
  double slide_mps = 0.0;  ///< mean speed along the floor of the points that touch it
  bool has_contacts = false;
};

/// Errors: those of find_body_motion().
[[nodiscard]] Result<Plausibility> judge(const Clip& clip, const BodyModel& model, const Derivation& derivation);

/// The findings in sentences for people: stature, energy, flight, floor. What is not as it should be says what to look at.
[[nodiscard]] std::vector<std::string> describe(const Plausibility& found, double frame_time_s);

}  // namespace marey
