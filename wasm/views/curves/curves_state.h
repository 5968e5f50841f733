#pragma once

#include <imgui.h>

#include <vector>

#include "core/document/session.h"
#include "wasm/app/time_window.h"
#include "wasm/views/graph/graph_axes.h"
#include "wasm/views/graph/value_axis.h"

namespace marey::app {

/// What the pointer is over in the curve editor. `on_sample`: near the sample itself, not only the line.
struct CurveHit {
  ChannelIndex channel = -1;
  FrameIndex frame = -1;
  bool on_sample = false;

  [[nodiscard]] explicit operator bool() const { return channel >= 0; }
};

enum class KeyPart { Key, LeftHandle, RightHandle };

/// A key of the active layer, or a handle of it, under the pointer.
struct KeyHit {
  ChannelIndex channel = -1;
  int key = -1;
  KeyPart part = KeyPart::Key;

  [[nodiscard]] explicit operator bool() const { return channel >= 0; }
};

enum class CurveDragKind { None, Pan, Zoom, Box, Move, Cursor, Key };

/// A drag in the canvas from press to release.
struct CurveDrag {
  CurveDragKind kind = CurveDragKind::None;
  ImVec2 start{0.0f, 0.0f};
  CurveHit grabbed;
  KeyHit grabbed_key;
  bool moved = false;     ///< beyond the click threshold
  GestureId gesture = 0;  ///< of a Move or a Key
};

/// What the curve editor remembers between frames. Angles and lengths have an axis each: angles on the left, lengths on
/// the right; both are zoomed and panned together except in their own gutters.
struct CurvesState {
  ValueAxis angles;
  ValueAxis lengths;
  GraphArea area;
  std::vector<ChannelIndex> shown;
  std::vector<ChannelIndex> shown_next;  ///< what update_shown_channels() compares with
  bool shows_angles = false;
  bool shows_lengths = false;
  CurveHit hit;
  KeyHit key_hit;
  CurveDrag drag;

  /// The axis that a channel is drawn against.
  [[nodiscard]] ValueAxis& axis_of(const Skeleton& skeleton, ChannelIndex channel) {
    return is_rotation(skeleton.channel(channel).kind) ? angles : lengths;
  }
  [[nodiscard]] const ValueAxis& axis_of(const Skeleton& skeleton, ChannelIndex channel) const {
    return is_rotation(skeleton.channel(channel).kind) ? angles : lengths;
  }
};

/// Updates the shown channels from the selection; returns true when they are others than before.
bool update_shown_channels(CurvesState& state, const Session& session);

/// Fits both axes to the shown curves within the frames that are in sight.
void fit_values(CurvesState& state, const Session& session, const TimeWindow& time);

/// Fits time and values to the selected samples; to everything shown when none is selected.
void fit_selection(CurvesState& state, const Session& session, TimeWindow& time);

/// The sample or curve under a point, nearest first; nothing outside of a few units.
[[nodiscard]] CurveHit find_curve_hit(const CurvesState& state, const Session& session, const TimeWindow& time,
                                      ImVec2 point);

/// The samples of the shown curves that lie in a screen rectangle.
[[nodiscard]] SampleSelection find_samples_in_box(const CurvesState& state, const Session& session,
                                                  const TimeWindow& time, ImVec2 corner, ImVec2 opposite);

/// The selected samples of channels with the unit of `channel`: those that one drag can move.
[[nodiscard]] SampleSelection selected_samples_like(const Session& session, ChannelIndex channel);

/// "°" for rotations, "units" for positions, "" for others.
[[nodiscard]] const char* unit_of(ChannelKind kind);

/// Short name of a channel in a curve view: "X", "Y", "Z" for rotations, "X pos" ... for positions.
[[nodiscard]] const char* short_name_of(const Channel& channel);

}  // namespace marey::app
