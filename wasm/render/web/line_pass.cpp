#include "wasm/render/web/line_pass.h"

#include "core/base/index.h"
#include "wasm/render/web/shaders/common.h"
#include "wasm/render/web/shaders/line.h"

namespace marey::app::gl {

Status LinePass::start() {
  if (Status status = program_.build({"lines", "", {kFrameBlock, kLineVertex}, {kLineFragment}}); !status) return status;
  half_width_ = program_.find_uniform("u_half_width");
  array_.create();
  points_.create();
  return {};
}

// Each line with its first and last point doubled: an instance reads four neighbouring points, and the ends need
// neighbours too.
void LinePass::upload(const Scene& scene) {
  padded_points_.clear();
  for (const SceneLine& line : scene.lines) {
    if (line.count < 2) continue;
    const auto first = scene.line_points.begin() + line.first;
    padded_points_.push_back(*first);
    padded_points_.insert(padded_points_.end(), first, first + line.count);
    padded_points_.push_back(*(first + line.count - 1));
  }
  if (!padded_points_.empty()) points_.upload(padded_points_.data(), padded_points_.size() * sizeof(SceneLinePoint));
}

void LinePass::draw(const Scene& scene, float pixels_per_unit) {
  glBindVertexArray(array_.name());
  upload(scene);
  if (padded_points_.empty()) return;
  program_.use();
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glDepthMask(GL_FALSE);
  constexpr std::size_t kStride = sizeof(SceneLinePoint);
  std::size_t point = 0;
  for (const SceneLine& line : scene.lines) {
    if (line.count < 2) continue;
    const std::size_t start = point * kStride;
    set_attribute(0, 3, kStride, start + offsetof(SceneLinePoint, position), 1);
    set_attribute(1, 3, kStride, start + kStride + offsetof(SceneLinePoint, position), 1);
    set_attribute(2, 4, kStride, start + kStride + offsetof(SceneLinePoint, color), 1);
    set_attribute(3, 3, kStride, start + 2 * kStride + offsetof(SceneLinePoint, position), 1);
    set_attribute(4, 4, kStride, start + 2 * kStride + offsetof(SceneLinePoint, color), 1);
    set_attribute(5, 3, kStride, start + 3 * kStride + offsetof(SceneLinePoint, position), 1);
    set_uniform(half_width_, 0.5f * line.width * pixels_per_unit);
    draw_arrays_instanced(GL_TRIANGLE_STRIP, 0, 4, line.count - 1);
    point += idx(line.count) + 2;
  }
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

}  // namespace marey::app::gl
