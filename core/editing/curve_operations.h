#pragma once

#include "core/base/result.h"
#include "core/editing/edit.h"
#include "core/editing/sample_selection.h"

namespace marey {

// All of these leave the clip as it is and return what to apply; check_edit() refuses the result when a finite sample
// would stop being finite. Selected samples outside of the clip do not count; without any the edit is empty.

/// How far a dragged sample pulls its unselected neighbours: weight 1 in the selection, falling to 0 at
/// `radius_frames` from its nearest selected sample along a raised cosine. 0 (or not finite): the selection alone
/// moves.
struct Falloff {
  double radius_frames = 0.0;
};

/// Weight of a sample `distance_frames` from the nearest selected one; 1 at 0, 0 from the radius on.
[[nodiscard]] double falloff_weight(const Falloff& falloff, double distance_frames);

/// Moves the selected samples by `delta` (the channel's unit) and their neighbours by the falloff's share. Samples that
/// are not finite stay.
[[nodiscard]] Edit make_move_edit(const Clip& clip, const SampleSelection& selection, double delta, Falloff falloff);

/// Gives all selected samples one value.
[[nodiscard]] Edit make_value_edit(const Clip& clip, const SampleSelection& selection, double value);

/// pivot + factor (value - pivot); values that are not finite stay, and a factor of 1 keeps the bits.
[[nodiscard]] double scaled_about(double pivot, double factor, double value);

/// Scales the selected samples about a pivot, see scaled_about().
[[nodiscard]] Edit make_scale_edit(const Clip& clip, const SampleSelection& selection, double factor, double pivot);

/// Smooths each selected run with a Gaussian of standard deviation `sigma_frames` > 0 (at most the length of the clip),
/// kernel cut at 4 sigma. Samples outside of the run feed the filter, so the run joins its surroundings; the curve is
/// continued beyond its first and last finite sample by point reflection about it. Samples that are not finite stay,
/// and weigh nothing in the others, nor does the sample opposite of them: so constants and straight lines stay exact.
[[nodiscard]] Edit make_smooth_edit(const Clip& clip, const SampleSelection& selection, double sigma_frames);

/// Sets one sample, for typed numbers in the inspector.
[[nodiscard]] Edit make_sample_edit(const Clip& clip, ChannelIndex channel, FrameIndex frame, double value);

/// Mean of the selected samples that are finite, the natural pivot of a scale; 0 when there is none.
[[nodiscard]] double compute_selection_mean(const Clip& clip, const SampleSelection& selection);

}  // namespace marey
