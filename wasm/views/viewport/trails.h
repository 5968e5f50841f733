#pragma once

#include <cstdint>
#include <vector>

#include "core/document/session.h"
#include "wasm/app/camera.h"
#include "wasm/app/theme.h"
#include "wasm/app/view_options.h"
#include "wasm/render/scene.h"
#include "wasm/views/viewport/figure_cache.h"

namespace marey::app {

/// The nodes whose paths are drawn: those of the selected joints; when none is selected the ends of the body that lie
/// far apart in the rest pose (hands, feet and head rather than ten fingers), at most five.
[[nodiscard]] std::vector<NodeIndex> find_trail_nodes(const Skeleton& skeleton, const Selection& selection);

/// Frames that a trail shows around `frame`: all of a short range, a few seconds before and after in a long one.
[[nodiscard]] FrameRange find_trail_frames(FrameRange range, double frame_time_s, FrameIndex frame);

/// Paths of joints through space, strong near the present pose and fading with time from it, with a tick across every
/// few frames. Paths are computed per revision, for a stretch of the clip around what is shown.
class Trails {
 public:
  /// Adds the lines to the scene; none when they are switched off.
  void add(const Session& session, const FigureCache& figure, const CameraView& camera, const ViewOptions& options,
           const Theme& theme, Scene& scene);

 private:
  struct Trail {
    NodeIndex node = 0;
    std::vector<float> positions;  // [frame][x y z] over key_.frames
  };
  struct Key {
    FrameRange frames;
    std::vector<JointIndex> joints;  // selected
    std::uint64_t revision = 0;
    std::uint64_t figure_serial = 0;
    friend bool operator==(const Key&, const Key&) = default;
  };

  void compute_paths(const Session& session, const FigureCache& figure, FrameRange shown);
  void add_line(const Trail& trail, FrameRange shown, double position, const glm::vec4& color, Scene& scene) const;
  void add_ticks(const Trail& trail, FrameRange shown, double position, const CameraView& camera,
                 const glm::vec4& color, Scene& scene) const;
  [[nodiscard]] glm::vec3 point(const Trail& trail, FrameIndex frame) const;

  Key key_;
  Key wanted_;  // kept so that comparing does not allocate
  std::vector<Trail> trails_;
};

}  // namespace marey::app
