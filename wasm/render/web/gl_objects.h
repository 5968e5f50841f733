#pragma once

#include <GLES3/gl3.h>

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <utility>

#include "core/base/result.h"

namespace marey::app::gl {

/// Owner of one GL name.
template <void (*Generate)(GLsizei, GLuint*), void (*Delete)(GLsizei, const GLuint*)>
class Object {
 public:
  Object() = default;
  ~Object() { reset(); }
  Object(Object&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  Object& operator=(Object&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }

  void create() {
    reset();
    Generate(1, &name_);
  }
  void reset() {
    if (name_ != 0) Delete(1, &name_);
    name_ = 0;
  }
  [[nodiscard]] GLuint name() const { return name_; }

 private:
  GLuint name_ = 0;
};

using Buffer = Object<glGenBuffers, glDeleteBuffers>;
using VertexArray = Object<glGenVertexArrays, glDeleteVertexArrays>;
using Texture = Object<glGenTextures, glDeleteTextures>;
using Framebuffer = Object<glGenFramebuffers, glDeleteFramebuffers>;

/// A shader's text in pieces, put together in order; unused places stay null.
using ShaderText = std::array<const char*, 4>;

/// What a program is made of. `defines`: preprocessor lines put before both stages.
struct ProgramSource {
  const char* name = "";  ///< for messages
  const char* defines = "";
  ShaderText vertex{};
  ShaderText fragment{};
};

/// A linked program. Its uniform block "Frame", when it has one, is bound to slot 0.
class Program {
 public:
  Program() = default;
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  Status build(const ProgramSource& source);
  void use() const { glUseProgram(name_); }
  [[nodiscard]] GLint find_uniform(const char* uniform) const { return glGetUniformLocation(name_, uniform); }

 private:
  GLuint name_ = 0;
};

/// Vertex buffer filled anew each frame: keeps its storage and grows by doubling.
class StreamBuffer {
 public:
  void create() {
    buffer_.create();
    capacity_ = 0;
  }
  /// Leaves the buffer bound to GL_ARRAY_BUFFER.
  void upload(const void* data, std::size_t size_bytes);
  void bind() const { glBindBuffer(GL_ARRAY_BUFFER, buffer_.name()); }

 private:
  Buffer buffer_;
  std::size_t capacity_ = 0;
};

/// What has been drawn since it was last taken.
struct DrawCount {
  int calls = 0;
  int vertices = 0;
};
[[nodiscard]] DrawCount take_draw_count();

/// As in GL, and counted.
void draw_arrays(GLenum mode, GLint first, GLsizei count);
void draw_arrays_instanced(GLenum mode, GLint first, GLsizei count, GLsizei instances);
void draw_elements_instanced(GLenum mode, GLsizei count, GLenum type, GLsizei instances);

/// Enables float attribute `location` of the bound array buffer; `divisor` 1 for one value per instance.
void set_attribute(GLuint location, int components, std::size_t stride, std::size_t offset, GLuint divisor = 0);

inline void set_uniform(GLint location, float value) { glUniform1f(location, value); }
inline void set_uniform(GLint location, const glm::vec2& value) { glUniform2f(location, value.x, value.y); }
inline void set_uniform(GLint location, const glm::vec3& value) { glUniform3f(location, value.x, value.y, value.z); }
inline void set_uniform(GLint location, const glm::vec4& value) {
  glUniform4f(location, value.x, value.y, value.z, value.w);
}

}  // namespace marey::app::gl
