#include "wasm/views/viewport/strobe.h"

#include <algorithm>
#include <array>

#include "wasm/views/viewport/figure_drawing.h"

namespace marey::app {
namespace {

constexpr float kFirstAlpha = 0.20f;
constexpr float kLastAlpha = 0.42f;

}  // namespace

StrobeFrames find_strobe_frames(FrameRange range, int every, FrameIndex frame, int limit) {
  const int step = std::max(every, 1);
  const int all = range.count > 0 ? (range.count - 1) / step + 1 : 0;
  const int count = std::min(all, limit);
  const int here = std::clamp((frame - range.first) / step, 0, std::max(all - 1, 0));
  const int skipped = std::clamp(here - count / 2, 0, all - count);
  return {range.first + skipped * step, step, count};
}

int usual_strobe_distance(int frame_count, double frame_time_s) {
  constexpr std::array kRound = {1, 2, 5, 10, 20, 50, 100, 200, 500};
  const double half_second = frame_time_s > 0.0 ? 0.5 / frame_time_s : 1.0;
  const double wanted = std::min(frame_count / 12.0, half_second);
  const auto found = std::lower_bound(kRound.begin(), kRound.end(), wanted);
  return found == kRound.end() ? kRound.back() : *found;
}

void Strobe::update(const Session& session, const FigureCache& figure, bool visible, int every, const Theme& theme,
                    Scene& scene) {
  const Playback& playback = session.playback;
  const Clip& clip = session.document.clip();
  Key key;
  key.visible = visible && clip.motion.frame_count() > 0;
  if (key.visible) {
    key.frames = find_strobe_frames(playback.range(), every, playback.frame(), kMostPoses);
    key.revision = session.document.revision();
    key.figure_serial = figure.figure_serial();
    key.theme = theme.kind;
  }
  if (key == key_) return;
  key_ = key;
  ++scene.faded_revision;
  scene.faded_bones.clear();
  scene.faded_balls.clear();
  for (int i = 0; i < key.frames.count; ++i) {
    const int age = key.frames.count - 1 - i;
    const float share = 1.0f - static_cast<float>(age) / static_cast<float>(std::max(key.frames.count - 1, 1));
    compute_clip_pose(clip, key.frames.first + i * key.frames.every, local_, pose_);
    add_faded_figure(figure.shape(), pose_, theme, kFirstAlpha + (kLastAlpha - kFirstAlpha) * share, scene);
  }
}

}  // namespace marey::app
