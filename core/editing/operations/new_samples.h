#pragma once

#include <cstdint>
#include <functional>
#include <glm/gtc/quaternion.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/editing/operation.h"
#include "core/motion/euler_channels.h"

namespace marey {

/// What an operation wants for the frames of the target in one channel, before weights and blends.
struct NewSamples {
  ChannelIndex channel = 0;
  std::vector<double> values;
};

/// How old and new samples are mixed where the weight is neither 0 nor 1.
enum class Mix : std::uint8_t {
  Values,     ///< straight, channel by channel
  Rotations,  ///< joints of two or three rotations by slerp, to the angles nearest to the straight mix; others straight
};

/// Samples that are not finite: kept as they are, or given the new value at once where the weight is above 0.
enum class Missing : std::uint8_t { Stay, AreFilled };

/// The edit that brings in the new samples with the target's weights. Channels rise; none stands twice.
[[nodiscard]] Edit blended_edit(const OperationCall& call, std::vector<NewSamples> samples, Mix mix = Mix::Values,
                                Missing missing = Missing::Stay);

/// A curve of the target while an operation works on it.
struct Curve {
  ChannelIndex channel = 0;
  ChannelKind kind = ChannelKind::Other;
  std::span<const double> samples;  ///< of the whole clip
  FrameRange frames;                ///< of the target, at least one

  /// The last finite sample before the range; the first finite one within it where there is none.
  [[nodiscard]] double before() const;
  /// The first finite sample behind the range, or the last finite one within it.
  [[nodiscard]] double behind() const;
};

/// Works on each channel of the target: `work(curve, values)` changes `values`, which are the samples of the range.
using CurveWork = std::function<void(const Curve& curve, std::span<double> values)>;
[[nodiscard]] OperationOutcome make_curves_edit(const OperationCall& call, const CurveWork& work,
                                                Missing missing = Missing::Stay);

/// The same by a rule for a single sample.
[[nodiscard]] OperationOutcome make_mapped_edit(const OperationCall& call, const std::function<double(double)>& rule);

/// "Smooth LeftArm Zrotation", "Smooth 3 channels": the label and what it is done to.
[[nodiscard]] std::string edit_name(const OperationCall& call, std::span<const NewSamples> samples);

/// The samples of one channel in the frames of the target.
[[nodiscard]] std::span<const double> target_samples(const OperationCall& call, ChannelIndex channel);

/// Copies of the samples of the target's frames for the rotation channels of a joint, in their order.
[[nodiscard]] std::vector<NewSamples> copied_angles(const OperationCall& call, const EulerChannels& euler);

/// Puts angles back: `angles_deg[i]` into each of the rotation channels at the i-th frame of the target.
void set_angles(std::vector<NewSamples>& samples, std::size_t frame, const glm::dvec3& angles_deg);

/// The rotation `weight` of the way from one set of angles to another by slerp, as the angles nearest to the straight mix.
[[nodiscard]] glm::dvec3 mixed_angles(const EulerChannels& euler, const glm::dvec3& from_deg, const glm::dvec3& to_deg,
                                      double weight);

/// Moves all of `from` to the end of `to`.
void append(std::vector<NewSamples>& to, std::vector<NewSamples> from);

}  // namespace marey
