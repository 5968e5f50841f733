#include "wasm/render/web/curve_pass.h"

#include <cmath>

#include "core/base/index.h"
#include "wasm/render/web/shaders/curve.h"

namespace marey::app {
namespace gl {
namespace {

// ImGui calls back without a word of whose frame it is.
CurvePass* started_pass = nullptr;

constexpr std::size_t kStride = sizeof(CurvePlace);
// An instance reads its two places and the one on either side of them.
constexpr int kPlacesOfInstance = 4;

void set_place(GLuint location, std::size_t place) {
  set_attribute(location, 3, kStride, place * kStride, 1);
}

void set_color(GLuint location, std::size_t place) {
  glEnableVertexAttribArray(location);
  glVertexAttribPointer(location, 4, GL_UNSIGNED_BYTE, GL_TRUE, static_cast<GLsizei>(kStride),
                        reinterpret_cast<const void*>(place * kStride + offsetof(CurvePlace, color)));
  glVertexAttribDivisor(location, 1);
}

void clip_to(const ImVec4& clip) {
  const ImDrawData& frame = *ImGui::GetDrawData();
  const ImVec2 scale = frame.FramebufferScale;
  const auto left = static_cast<GLint>(clip.x * scale.x);
  const auto bottom = static_cast<GLint>((frame.DisplaySize.y - clip.w) * scale.y);
  glEnable(GL_SCISSOR_TEST);
  glScissor(left, bottom, static_cast<GLsizei>((clip.z - clip.x) * scale.x), static_cast<GLsizei>((clip.w - clip.y) * scale.y));
}

}  // namespace

CurvePass::~CurvePass() {
  if (started_pass == this) started_pass = nullptr;
}

CurvePass* CurvePass::started() { return started_pass; }

Status CurvePass::start() {
  if (Status status = program_.build({"curves", "", {kCurveVertex}, {kCurveFragment}}); !status) return status;
  to_clip_ = program_.find_uniform("u_to_clip");
  options_ = program_.find_uniform("u_options");
  array_.create();
  places_.create();
  uploaded_ = nullptr;
  started_pass = this;
  return {};
}

void CurvePass::upload(const CurveBatch& batch) {
  if (uploaded_ == &batch && uploaded_serial_ == batch.serial) return;
  places_.upload(batch.places.data(), batch.places.size() * kStride);
  for (std::size_t place = 0; place < kPlacesOfInstance; ++place) {
    set_place(static_cast<GLuint>(2 * place), place);
    set_color(static_cast<GLuint>(2 * place + 1), place);
  }
  uploaded_ = &batch;
  uploaded_serial_ = batch.serial;
}

void CurvePass::draw(const CurveBatch& batch, const ImVec4& clip) {
  const int count = size_of(batch.places) - (kPlacesOfInstance - 1);
  if (count <= 0 || clip.z <= clip.x || clip.w <= clip.y) return;
  const ImDrawData& frame = *ImGui::GetDrawData();
  glBindVertexArray(array_.name());
  upload(batch);
  program_.use();
  const ImVec2 size = frame.DisplaySize;
  set_uniform(to_clip_, glm::vec4(2.0f / size.x, -2.0f / size.y, -1.0f - 2.0f * frame.DisplayPos.x / size.x,
                                  1.0f + 2.0f * frame.DisplayPos.y / size.y));
  set_uniform(options_, glm::vec2(0.5f / frame.FramebufferScale.y, batch.lines ? 1.0f : 0.0f));
  clip_to(clip);
  draw_arrays_instanced(GL_TRIANGLE_STRIP, 0, 4, count);
}

}  // namespace gl

namespace {

void draw_batch(const ImDrawList* /*list*/, const ImDrawCmd* command) {
  gl::CurvePass* const pass = gl::CurvePass::started();
  if (pass != nullptr) pass->draw(*static_cast<const CurveBatch*>(command->UserCallbackData), command->ClipRect);
}

}  // namespace

void add_curve_batch(ImDrawList& list, const CurveBatch& batch) {
  list.AddCallback(draw_batch, const_cast<CurveBatch*>(&batch));
  list.AddCallback(ImDrawCallback_ResetRenderState, nullptr);
}

}  // namespace marey::app
