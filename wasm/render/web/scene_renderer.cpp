#include "wasm/render/scene_renderer.h"

#include <cmath>

#include "wasm/render/web/curve_pass.h"
#include "wasm/render/web/frame_uniforms.h"
#include "wasm/render/web/ground_pass.h"
#include "wasm/render/web/line_pass.h"
#include "wasm/render/web/shadow_pass.h"
#include "wasm/render/web/solid_pass.h"

namespace marey::app {
namespace {

gl::PixelRect pixel_rect(const Scene& scene, int framebuffer_height, float pixels_per_unit) {
  const auto to_pixels = [&](float units) { return static_cast<int>(std::lround(units * pixels_per_unit)); };
  const int left = to_pixels(scene.x);
  const int top = to_pixels(scene.y);
  const int right = to_pixels(scene.x + scene.width);
  const int bottom = to_pixels(scene.y + scene.height);
  return {left, framebuffer_height - bottom, right - left, bottom - top};
}

void clear_all(const Scene& scene, int framebuffer_width, int framebuffer_height) {
  const glm::vec4& color = scene.background_bottom;
  glDisable(GL_SCISSOR_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  glViewport(0, 0, framebuffer_width, framebuffer_height);
  glClearColor(color.r, color.g, color.b, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void leave_clean_state() {
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glUseProgram(0);
}

}  // namespace

struct SceneRenderer::Passes {
  gl::Buffer frame;
  gl::SolidPass solids;
  gl::ShadowPass shadow;
  gl::GroundPass ground;
  gl::LinePass lines;
  gl::CurvePass curves;

  Status start() {
    if (Status status = solids.start(); !status) return status;
    if (Status status = shadow.start(); !status) return status;
    if (Status status = ground.start(); !status) return status;
    if (Status status = lines.start(); !status) return status;
    if (Status status = curves.start(); !status) return status;
    frame.create();
    glBindBuffer(GL_UNIFORM_BUFFER, frame.name());
    glBufferData(GL_UNIFORM_BUFFER, sizeof(gl::FrameUniforms), nullptr, GL_DYNAMIC_DRAW);
    glBindBuffer(GL_UNIFORM_BUFFER, 0);
    return {};
  }

  void upload_frame(const gl::FrameUniforms& uniforms) const {
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, frame.name());
    glBufferSubData(GL_UNIFORM_BUFFER, 0, sizeof uniforms, &uniforms);
  }

  void draw_view(const Scene& scene, const gl::PixelRect& view, float pixels_per_unit) {
    solids.upload(scene);
    upload_frame(gl::make_frame_uniforms(scene, view, pixels_per_unit));
    glActiveTexture(GL_TEXTURE0);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    if (scene.shadow.visible) shadow.draw(scene, solids);

    glViewport(view.x, view.y, view.width, view.height);
    glScissor(view.x, view.y, view.width, view.height);
    glEnable(GL_SCISSOR_TEST);
    ground.draw_background(scene);
    ground.draw_ground(scene, shadow.map());
    solids.draw_faded();
    solids.draw_figure();
    solids.draw_outlines(scene.outline_width * pixels_per_unit);
    solids.draw_ellipsoids();
    lines.draw(scene, pixels_per_unit);
  }
};

SceneRenderer::SceneRenderer() = default;
SceneRenderer::~SceneRenderer() = default;

Status SceneRenderer::start() {
  auto passes = std::make_unique<Passes>();
  if (Status status = passes->start(); !status) return status;
  passes_ = std::move(passes);
  return {};
}

void SceneRenderer::draw(const Scene& scene, int framebuffer_width, int framebuffer_height, float pixels_per_unit) {
  clear_all(scene, framebuffer_width, framebuffer_height);
  const gl::PixelRect view = pixel_rect(scene, framebuffer_height, pixels_per_unit);
  if (passes_ == nullptr || view.width <= 0 || view.height <= 0) return;
  passes_->draw_view(scene, view, pixels_per_unit);
  leave_clean_state();
}

SceneRenderer::Count SceneRenderer::take_count() {
  const gl::DrawCount count = gl::take_draw_count();
  return {count.calls, count.vertices};
}

void SceneRenderer::release() { passes_.reset(); }

}  // namespace marey::app
