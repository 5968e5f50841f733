#pragma once

#include <cstdint>

#include "core/document/session.h"
#include "wasm/app/theme.h"
#include "wasm/render/scene.h"
#include "wasm/views/viewport/figure_cache.h"

namespace marey::app {

/// Frames of the strobe picture: every `every`-th frame of `range`, counted from its first; at most `limit` of them,
/// those around `frame`.
struct StrobeFrames {
  FrameIndex first = 0;
  int every = 1;
  int count = 0;
  friend bool operator==(const StrobeFrames&, const StrobeFrames&) = default;
};
[[nodiscard]] StrobeFrames find_strobe_frames(FrameRange range, int every, FrameIndex frame, int limit);

/// A distance of poses that keeps a picture clear: about a dozen in a short clip, half a second in a long one.
[[nodiscard]] int usual_strobe_distance(int frame_count, double frame_time_s);

/// The poses of a motion on one plate, as Marey photographed it: earlier ones fainter. Computed when clip, frames or
/// theme change, not in every frame.
class Strobe {
 public:
  static constexpr int kMostPoses = 60;

  /// Brings the faded solids of the scene up to date; empties them when the strobe is off.
  void update(const Session& session, const FigureCache& figure, bool visible, int every, const Theme& theme,
              Scene& scene);

 private:
  struct Key {
    StrobeFrames frames;
    std::uint64_t revision = 0;
    std::uint64_t figure_serial = 0;
    ThemeKind theme = ThemeKind::Dark;
    bool visible = false;
    friend bool operator==(const Key&, const Key&) = default;
  };

  Key key_;
  LocalPose local_;
  WorldPose pose_;
};

}  // namespace marey::app
