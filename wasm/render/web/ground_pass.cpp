#include "wasm/render/web/ground_pass.h"

#include <glm/geometric.hpp>

#include "wasm/render/web/frame_uniforms.h"
#include "wasm/render/web/shaders/common.h"
#include "wasm/render/web/shaders/ground.h"
#include "wasm/render/web/shaders/screen.h"

namespace marey::app::gl {

Status GroundPass::start() {
  const ProgramSource background{"background", "", {kScreenVertex}, {kBackgroundFragment}};
  const ProgramSource ground{"ground", "", {kFrameBlock, kGroundVertex}, {kFrameBlock, kGroundFragment}};
  if (Status status = background_.build(background); !status) return status;
  if (Status status = ground_.build(ground); !status) return status;
  top_ = background_.find_uniform("u_top");
  bottom_ = background_.find_uniform("u_bottom");
  center_ = ground_.find_uniform("u_center");
  axis_u_ = ground_.find_uniform("u_axis_u");
  axis_v_ = ground_.find_uniform("u_axis_v");
  fade_radius_ = ground_.find_uniform("u_fade_radius");
  cell_ = ground_.find_uniform("u_cell");
  shadow_place_ = ground_.find_uniform("u_shadow_place");
  shadow_color_ = ground_.find_uniform("u_shadow_color");
  plane_color_ = ground_.find_uniform("u_plane_color");
  line_color_ = ground_.find_uniform("u_line_color");
  axis_color_u_ = ground_.find_uniform("u_axis_color_u");
  axis_color_v_ = ground_.find_uniform("u_axis_color_v");
  no_vertices_.create();
  return {};
}

void GroundPass::draw_background(const Scene& scene) const {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  background_.use();
  set_uniform(top_, scene.background_top);
  set_uniform(bottom_, scene.background_bottom);
  glBindVertexArray(no_vertices_.name());
  draw_arrays(GL_TRIANGLES, 0, 3);
}

void GroundPass::draw_ground(const Scene& scene, GLuint shadow_map) const {
  const SceneGround& ground = scene.ground;
  const glm::vec3 u = ground_axis_u(ground.up);
  const glm::vec3 v = ground_axis_v(ground.up);
  const glm::vec3 up = unit_vector(ground.up);
  const ShadowPlace shadow = ShadowPass::place_of(scene);
  const glm::vec4 none(0.0f);

  ground_.use();
  set_uniform(center_, ground.center + up * (ground.height - glm::dot(ground.center, up)));
  set_uniform(axis_u_, u);
  set_uniform(axis_v_, v);
  set_uniform(fade_radius_, ground.fade_radius);
  set_uniform(cell_, ground.cell);
  set_uniform(shadow_place_, glm::vec3(glm::dot(shadow.center, u), glm::dot(shadow.center, v), 1.0f / shadow.half_side));
  set_uniform(shadow_color_, scene.shadow.visible ? scene.shadow.color : none);
  set_uniform(plane_color_, ground.plane_color);
  set_uniform(line_color_, ground.grid ? ground.line_color : none);
  set_uniform(axis_color_u_, ground.grid ? ground.axis_colors[0] : none);
  set_uniform(axis_color_v_, ground.grid ? ground.axis_colors[1] : none);

  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBindTexture(GL_TEXTURE_2D, shadow_map);
  glBindVertexArray(no_vertices_.name());
  draw_arrays(GL_TRIANGLE_STRIP, 0, 4);
  glBindTexture(GL_TEXTURE_2D, 0);
  glDisable(GL_BLEND);
}

}  // namespace marey::app::gl
