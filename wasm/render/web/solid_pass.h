#pragma once

#include "wasm/render/scene.h"
#include "wasm/render/web/instance_batch.h"

namespace marey::app::gl {

/// Bones and balls: the figure, its outlines, the strobe poses, and what throws the shadow; ellipsoids over them.
class SolidPass {
 public:
  Status start();
  /// Takes the scene's solids over for the draws below.
  void upload(const Scene& scene);
  /// Strobe poses, blended once per pixel. Needs a cleared depth buffer and spends it.
  void draw_faded() const;
  /// The figure, with depth.
  void draw_figure() const;
  /// Edges around the outlined solids, behind the figure; after draw_figure.
  void draw_outlines(float width_pixels) const;
  /// Ellipsoids over the figure, blended once per pixel; afterwards the depth is that of the figure alone.
  void draw_ellipsoids() const;
  /// Bones, then balls, with programs of the caller's own that use kSolidShape.
  void draw_casters(const Program& bone_program, const Program& ball_program) const;

 private:
  Mesh bone_mesh_;
  Mesh coarse_bone_mesh_;
  Mesh ball_mesh_;
  Mesh ellipsoid_mesh_;
  InstanceBatch bones_;
  InstanceBatch balls_;
  InstanceBatch outlined_bones_;
  InstanceBatch outlined_balls_;
  InstanceBatch faded_bones_;
  InstanceBatch faded_balls_;
  InstanceBatch ellipsoids_;
  Program bone_lit_;
  Program ball_lit_;
  Program bone_edge_;
  Program ball_edge_;
  Program bone_faded_;
  Program ball_faded_;
  Program ellipsoid_faded_;
  GLint bone_edge_width_ = -1;
  GLint ball_edge_width_ = -1;
  bool faded_known_ = false;
  std::uint64_t faded_revision_ = 0;
};

}  // namespace marey::app::gl
