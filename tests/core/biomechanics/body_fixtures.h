#pragma once

#include "core/biomechanics/analysis.h"
#include "core/motion/clip.h"
#include "tests/core/kinematics/figures.h"

namespace marey::test {

/// The gymnast of the founding paper: three links of 10, 12 and 16 units, 23 frames at 0.033333 s.
[[nodiscard]] Clip make_gymnast();

/// 70 kg on it, with average male proportions (fixture D of the shared theory, section 7.3): 0.055 m a unit; mass fractions
/// .0988, .5040 and .3972; centres at .5315, .3158 and .2899 of the lengths; radii of gyration .2789, .4435 and .2536 of them.
[[nodiscard]] BodyModel make_gymnast_model();

/// A clip of a figure in metres; sample(frame, channel) gives its samples in degrees and metres.
template <class Sample>
[[nodiscard]] Clip make_moving(Skeleton skeleton, int frames, double rate_hz, Sample sample) {
  Clip clip;
  clip.motion = Motion(skeleton.channel_count(), frames, 1.0 / rate_hz);
  clip.skeleton = std::move(skeleton);
  clip.settings.metres_per_unit = 1.0;
  for (ChannelIndex channel = 0; channel < clip.motion.channel_count(); ++channel) {
    for (FrameIndex frame = 0; frame < frames; ++frame) clip.motion.channel_samples(channel)[idx(frame)] = sample(frame, channel);
  }
  return clip;
}

/// A segment for each joint of a figure: masses, centres and tensors at random, all of them such as a body can have.
[[nodiscard]] BodyModel make_random_model(const Skeleton& skeleton, unsigned seed);

/// The values of a column, which the table must have.
[[nodiscard]] const std::vector<double>& column_of(const AnalysisTable& table, std::string_view name);

/// The table of some quantities, which must not be refused.
[[nodiscard]] AnalysisTable table_of(const Clip& clip, const AnalysisRequest& request);

}  // namespace marey::test
