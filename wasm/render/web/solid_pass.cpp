#include "wasm/render/web/solid_pass.h"

#include "wasm/render/web/shaders/common.h"
#include "wasm/render/web/shaders/solid.h"

namespace marey::app::gl {
namespace {

// Segments of a mesh: smooth at 200 pixels a bone, and cheap enough for 200 bones on a software renderer.
constexpr int kBoneSides = 16;
constexpr int kBoneRings = 9;
constexpr int kCoarseBoneSides = 8;
constexpr int kCoarseBoneRings = 4;
constexpr int kBallRings = 10;
constexpr int kEllipsoidRings = 18;  // as large as a trunk

ProgramSource solid_source(const char* name, const char* defines) {
  return {name, defines, {kFrameBlock, kSolidShape, kSolidVertex}, {kFrameBlock, kColorSpace, kSolidFragment}};
}

// Depth first, so that where solids overlap only the nearest is blended and the picture does not clot.
template <typename Draw>
void blend_once(const Draw& draw) {
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  draw();
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glEnable(GL_BLEND);
  draw();
  glDisable(GL_BLEND);
}

}  // namespace

Status SolidPass::start() {
  const std::pair<Program*, ProgramSource> programs[] = {
      {&bone_lit_, solid_source("bones", "#define BONE\n")},
      {&ball_lit_, solid_source("joints", "#define BALL\n")},
      {&bone_edge_, solid_source("bone outlines", "#define BONE\n#define EDGE\n")},
      {&ball_edge_, solid_source("joint outlines", "#define BALL\n#define EDGE\n")},
      {&bone_faded_, solid_source("strobe bones", "#define BONE\n#define FADED\n")},
      {&ball_faded_, solid_source("strobe joints", "#define BALL\n#define FADED\n")},
      {&ellipsoid_faded_, solid_source("segments", "#define ELLIPSOID\n#define FADED\n")},
  };
  for (const auto& [program, source] : programs) {
    if (Status status = program->build(source); !status) return status;
  }
  bone_edge_width_ = bone_edge_.find_uniform("u_edge_width");
  ball_edge_width_ = ball_edge_.find_uniform("u_edge_width");

  bone_mesh_.create(make_bone_mesh(kBoneSides, kBoneRings));
  coarse_bone_mesh_.create(make_bone_mesh(kCoarseBoneSides, kCoarseBoneRings));
  ball_mesh_.create(make_ball_mesh(kBallRings));
  ellipsoid_mesh_.create(make_ball_mesh(kEllipsoidRings));
  bones_.create_bones(bone_mesh_);
  outlined_bones_.create_bones(bone_mesh_);
  faded_bones_.create_bones(coarse_bone_mesh_);
  faded_balls_.create_balls(ball_mesh_);
  balls_.create_balls(ball_mesh_);
  outlined_balls_.create_balls(ball_mesh_);
  ellipsoids_.create_ellipsoids(ellipsoid_mesh_);
  return {};
}

void SolidPass::upload(const Scene& scene) {
  bones_.set(scene.bones);
  balls_.set(scene.balls);
  outlined_bones_.set(scene.outlined_bones);
  outlined_balls_.set(scene.outlined_balls);
  ellipsoids_.set(scene.ellipsoids);
  if (faded_known_ && faded_revision_ == scene.faded_revision) return;
  faded_bones_.set(scene.faded_bones);
  faded_balls_.set(scene.faded_balls);
  faded_revision_ = scene.faded_revision;
  faded_known_ = true;
}

void SolidPass::draw_faded() const {
  if (faded_bones_.empty() && faded_balls_.empty()) return;
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glEnable(GL_CULL_FACE);
  blend_once([this] {
    bone_faded_.use();
    faded_bones_.draw();
    ball_faded_.use();
    faded_balls_.draw();
  });
  glClear(GL_DEPTH_BUFFER_BIT);
}

void SolidPass::draw_figure() const {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_BACK);
  bone_lit_.use();
  bones_.draw();
  ball_lit_.use();
  balls_.draw();
}

void SolidPass::draw_outlines(float width_pixels) const {
  if (outlined_bones_.empty() && outlined_balls_.empty()) return;
  // The far side of a slightly thicker solid shows as an edge all around the solid itself.
  glCullFace(GL_FRONT);
  bone_edge_.use();
  glUniform1f(bone_edge_width_, width_pixels);
  outlined_bones_.draw();
  ball_edge_.use();
  glUniform1f(ball_edge_width_, width_pixels);
  outlined_balls_.draw();
  glCullFace(GL_BACK);
}

void SolidPass::draw_ellipsoids() const {
  if (ellipsoids_.empty()) return;
  blend_once([this] {
    ellipsoid_faded_.use();
    ellipsoids_.draw();
  });
  // Lines are to be seen in them, and hidden by bones as ever.
  glClear(GL_DEPTH_BUFFER_BIT);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  draw_figure();
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void SolidPass::draw_casters(const Program& bone_program, const Program& ball_program) const {
  bone_program.use();
  bones_.draw();
  ball_program.use();
  balls_.draw();
}

}  // namespace marey::app::gl
