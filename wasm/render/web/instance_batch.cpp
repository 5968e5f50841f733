#include "wasm/render/web/instance_batch.h"

#include <cstddef>

namespace marey::app::gl {

void Mesh::create(std::span<const std::byte> vertices, std::span<const std::uint16_t> indices) {
  // The element array belongs to the vertex array that is bound; none may be.
  glBindVertexArray(0);
  vertices_.create();
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size()), vertices.data(), GL_STATIC_DRAW);
  indices_.create();
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size_bytes()), indices.data(), GL_STATIC_DRAW);
  index_count_ = static_cast<GLsizei>(indices.size());
}

void Mesh::create(const BoneMesh& mesh) {
  create(std::as_bytes(std::span(mesh.vertices)), mesh.indices);
  is_bone_ = true;
}

void Mesh::create(const BallMesh& mesh) {
  create(std::as_bytes(std::span(mesh.vertices)), mesh.indices);
  is_bone_ = false;
}

void Mesh::bind() const {
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  if (is_bone_) {
    set_attribute(0, 4, sizeof(BoneVertex), offsetof(BoneVertex, section));
    set_attribute(1, 3, sizeof(BoneVertex), offsetof(BoneVertex, along));
  } else {
    set_attribute(0, 3, sizeof(glm::vec3), 0);
  }
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
}

void InstanceBatch::begin(const Mesh& mesh) {
  array_.create();
  instances_.create();
  count_ = 0;
  index_count_ = mesh.index_count();
  glBindVertexArray(array_.name());
  mesh.bind();
  instances_.bind();
}

void InstanceBatch::create_bones(const Mesh& mesh) {
  begin(mesh);
  constexpr std::size_t kStride = sizeof(SceneBone);
  set_attribute(3, 3, kStride, offsetof(SceneBone, from), 1);
  set_attribute(4, 1, kStride, offsetof(SceneBone, radius), 1);
  set_attribute(5, 3, kStride, offsetof(SceneBone, to), 1);
  set_attribute(6, 3, kStride, offsetof(SceneBone, side), 1);
  set_attribute(7, 4, kStride, offsetof(SceneBone, color), 1);
  glBindVertexArray(0);
}

void InstanceBatch::create_balls(const Mesh& mesh) {
  begin(mesh);
  constexpr std::size_t kStride = sizeof(SceneBall);
  set_attribute(3, 3, kStride, offsetof(SceneBall, center), 1);
  set_attribute(4, 1, kStride, offsetof(SceneBall, radius), 1);
  set_attribute(7, 4, kStride, offsetof(SceneBall, color), 1);
  glBindVertexArray(0);
}

void InstanceBatch::create_ellipsoids(const Mesh& ball) {
  begin(ball);
  constexpr std::size_t kStride = sizeof(SceneEllipsoid);
  set_attribute(3, 3, kStride, offsetof(SceneEllipsoid, center), 1);
  for (GLuint i = 0; i < 3; ++i) set_attribute(4 + i, 3, kStride, offsetof(SceneEllipsoid, axes) + i * sizeof(glm::vec3), 1);
  set_attribute(7, 4, kStride, offsetof(SceneEllipsoid, color), 1);
  glBindVertexArray(0);
}

void InstanceBatch::upload(const void* data, std::size_t count, std::size_t size_bytes) {
  count_ = static_cast<GLsizei>(count);
  if (count_ > 0) instances_.upload(data, count * size_bytes);
}

void InstanceBatch::draw() const {
  if (count_ == 0) return;
  glBindVertexArray(array_.name());
  draw_elements_instanced(GL_TRIANGLES, index_count_, GL_UNSIGNED_SHORT, count_);
}

}  // namespace marey::app::gl
