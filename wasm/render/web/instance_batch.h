#pragma once

#include <span>

#include "wasm/render/scene.h"
#include "wasm/render/solid_mesh.h"
#include "wasm/render/web/gl_objects.h"

namespace marey::app::gl {

/// Triangles in GPU memory, to be drawn many times.
class Mesh {
 public:
  void create(const BoneMesh& mesh);
  void create(const BallMesh& mesh);
  /// Puts the vertices into the bound vertex array.
  void bind() const;
  [[nodiscard]] GLsizei index_count() const { return index_count_; }

 private:
  void create(std::span<const std::byte> vertices, std::span<const std::uint16_t> indices);

  Buffer vertices_;
  Buffer indices_;
  GLsizei index_count_ = 0;
  bool is_bone_ = false;
};

/// One mesh at many places: bones, balls or ellipsoids. The mesh outlives the batch.
class InstanceBatch {
 public:
  void create_bones(const Mesh& mesh);
  void create_balls(const Mesh& mesh);
  void create_ellipsoids(const Mesh& ball);

  void set(std::span<const SceneBone> bones) { upload(bones.data(), bones.size(), sizeof(SceneBone)); }
  void set(std::span<const SceneBall> balls) { upload(balls.data(), balls.size(), sizeof(SceneBall)); }
  void set(std::span<const SceneEllipsoid> all) { upload(all.data(), all.size(), sizeof(SceneEllipsoid)); }
  /// Draws with the program in use; nothing when the batch is empty.
  void draw() const;
  [[nodiscard]] bool empty() const { return count_ == 0; }

 private:
  void upload(const void* data, std::size_t count, std::size_t size_bytes);
  void begin(const Mesh& mesh);

  VertexArray array_;
  StreamBuffer instances_;
  GLsizei index_count_ = 0;
  GLsizei count_ = 0;
};

}  // namespace marey::app::gl
