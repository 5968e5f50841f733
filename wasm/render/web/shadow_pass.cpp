#include "wasm/render/web/shadow_pass.h"

#include <glm/geometric.hpp>

#include "wasm/render/web/frame_uniforms.h"
#include "wasm/render/web/shaders/common.h"
#include "wasm/render/web/shaders/screen.h"
#include "wasm/render/web/shaders/solid.h"

namespace marey::app::gl {
namespace {

// Shadows are soft, and a software renderer pays for every texel.
constexpr int kMapSize = 256;
// Height at which the dark core of the shadow has lost two thirds, in shadow radii.
constexpr float kCoreHeight = 0.12f;
// Room for the blur around the shadow.
constexpr float kMargin = 1.15f;

void create_map(Texture& map, Framebuffer& target) {
  map.create();
  glBindTexture(GL_TEXTURE_2D, map.name());
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_RG8, kMapSize, kMapSize);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glBindTexture(GL_TEXTURE_2D, 0);
  target.create();
  glBindFramebuffer(GL_FRAMEBUFFER, target.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, map.name(), 0);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

ProgramSource caster_source(const char* name, const char* defines) {
  return {name, defines, {kFrameBlock, kSolidShape, kShadowVertex}, {kShadowFragment}};
}

}  // namespace

Status ShadowPass::start() {
  if (Status status = bone_shadow_.build(caster_source("bone shadows", "#define BONE\n")); !status) return status;
  if (Status status = ball_shadow_.build(caster_source("joint shadows", "#define BALL\n")); !status) return status;
  if (Status status = blur_.build({"blur", "", {kScreenVertex}, {kBlurFragment}}); !status) return status;
  for (auto& [program, uniforms] : {std::pair{&bone_shadow_, &bone_uniforms_}, {&ball_shadow_, &ball_uniforms_}}) {
    *uniforms = {program->find_uniform("u_center"), program->find_uniform("u_axis_u"),
                 program->find_uniform("u_axis_v"), program->find_uniform("u_scale")};
  }
  blur_step_ = blur_.find_uniform("u_step");
  for (int i = 0; i < 2; ++i) create_map(maps_[i], targets_[i]);
  no_vertices_.create();
  return {};
}

ShadowPlace ShadowPass::place_of(const Scene& scene) {
  const glm::vec3 up = unit_vector(scene.ground.up);
  const float sine = glm::max(glm::dot(scene.light.direction, up), 0.1f);
  const float height = glm::dot(scene.shadow.center, up) - scene.ground.height;
  const glm::vec3 center = scene.shadow.center - scene.light.direction * (height / sine);
  return {center, kMargin * scene.shadow.radius / sine};
}

void ShadowPass::set_caster_uniforms(const Program& program, const CasterUniforms& uniforms, const Scene& scene) const {
  const ShadowPlace place = place_of(scene);
  program.use();
  set_uniform(uniforms.center, place.center);
  set_uniform(uniforms.axis_u, ground_axis_u(scene.ground.up));
  set_uniform(uniforms.axis_v, ground_axis_v(scene.ground.up));
  set_uniform(uniforms.scale, glm::vec2(1.0f / place.half_side, 1.0f / (kCoreHeight * scene.shadow.radius)));
}

void ShadowPass::blur(int from, int to, const glm::vec2& step) const {
  glBindFramebuffer(GL_FRAMEBUFFER, targets_[to].name());
  glBindTexture(GL_TEXTURE_2D, maps_[from].name());
  set_uniform(blur_step_, step);
  draw_arrays(GL_TRIANGLES, 0, 3);
}

void ShadowPass::draw(const Scene& scene, const SolidPass& solids) {
  glViewport(0, 0, kMapSize, kMapSize);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glBindFramebuffer(GL_FRAMEBUFFER, targets_[0].name());
  glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  glClear(GL_COLOR_BUFFER_BIT);
  set_caster_uniforms(bone_shadow_, bone_uniforms_, scene);
  set_caster_uniforms(ball_shadow_, ball_uniforms_, scene);
  glEnable(GL_BLEND);
  glBlendEquation(GL_MAX);
  solids.draw_casters(bone_shadow_, ball_shadow_);
  glBlendEquation(GL_FUNC_ADD);
  glDisable(GL_BLEND);

  blur_.use();
  glBindVertexArray(no_vertices_.name());
  constexpr float kTexel = 1.0f / static_cast<float>(kMapSize);
  blur(0, 1, {kTexel, 0.0f});
  blur(1, 0, {0.0f, kTexel});
  glBindTexture(GL_TEXTURE_2D, 0);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace marey::app::gl
