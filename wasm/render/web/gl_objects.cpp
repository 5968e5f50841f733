#include "wasm/render/web/gl_objects.h"

#include <algorithm>
#include <string>

namespace marey::app::gl {
namespace {

constexpr GLuint kFrameBlockSlot = 0;

DrawCount draw_count;

Error make_error(const char* program, std::string reason) {
  while (!reason.empty() && (reason.back() == '\0' || reason.back() == '\n')) reason.pop_back();
  Error error;
  error.code = DiagnosticCode::InvalidArgument;
  error.message = "The graphics program \"" + std::string(program) + "\" was refused: " + reason;
  return error;
}

std::string read_log(GLuint object, bool is_shader) {
  GLint length = 0;
  if (is_shader) {
    glGetShaderiv(object, GL_INFO_LOG_LENGTH, &length);
  } else {
    glGetProgramiv(object, GL_INFO_LOG_LENGTH, &length);
  }
  std::string log(static_cast<std::size_t>(std::max(length, 0)), '\0');
  if (log.empty()) return "no reason given";
  if (is_shader) {
    glGetShaderInfoLog(object, length, nullptr, log.data());
  } else {
    glGetProgramInfoLog(object, length, nullptr, log.data());
  }
  return log;
}

/// Returns the compiled shader, attached to `program` and flagged for deletion with it; the compiler's word is asked
/// for only when linking fails, so that the stages compile in parallel.
GLuint attach_shader(GLuint program, GLenum stage, const char* defines, const ShaderText& text) {
  const GLuint shader = glCreateShader(stage);
  std::array<const char*, 2 + std::tuple_size_v<ShaderText>> parts{
      "#version 300 es\nprecision highp float;\nprecision highp int;\n", defines};
  GLsizei count = 2;
  for (const char* part : text) {
    if (part != nullptr) parts[static_cast<std::size_t>(count++)] = part;
  }
  glShaderSource(shader, count, parts.data(), nullptr);
  glCompileShader(shader);
  glAttachShader(program, shader);
  glDeleteShader(shader);
  return shader;
}

}  // namespace

Program::~Program() {
  if (name_ != 0) glDeleteProgram(name_);
}

Status Program::build(const ProgramSource& source) {
  name_ = glCreateProgram();
  const GLuint vertex = attach_shader(name_, GL_VERTEX_SHADER, source.defines, source.vertex);
  const GLuint fragment = attach_shader(name_, GL_FRAGMENT_SHADER, source.defines, source.fragment);
  glLinkProgram(name_);
  GLint linked = GL_FALSE;
  glGetProgramiv(name_, GL_LINK_STATUS, &linked);
  if (linked != GL_TRUE) {
    for (const GLuint shader : {vertex, fragment}) {
      GLint compiled = GL_FALSE;
      glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
      if (compiled != GL_TRUE) return make_error(source.name, read_log(shader, true));
    }
    return make_error(source.name, read_log(name_, false));
  }
  const GLuint block = glGetUniformBlockIndex(name_, "Frame");
  if (block != GL_INVALID_INDEX) glUniformBlockBinding(name_, block, kFrameBlockSlot);
  return {};
}

void StreamBuffer::upload(const void* data, std::size_t size_bytes) {
  bind();
  if (size_bytes > capacity_) capacity_ = std::max(size_bytes, capacity_ * 2);
  // Fresh storage each time, so that the driver need not wait for the last frame's draws.
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(capacity_), nullptr, GL_STREAM_DRAW);
  glBufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(size_bytes), data);
}

DrawCount take_draw_count() { return std::exchange(draw_count, {}); }

void draw_arrays(GLenum mode, GLint first, GLsizei count) {
  ++draw_count.calls;
  draw_count.vertices += count;
  glDrawArrays(mode, first, count);
}

void draw_arrays_instanced(GLenum mode, GLint first, GLsizei count, GLsizei instances) {
  ++draw_count.calls;
  draw_count.vertices += count * instances;
  glDrawArraysInstanced(mode, first, count, instances);
}

void draw_elements_instanced(GLenum mode, GLsizei count, GLenum type, GLsizei instances) {
  ++draw_count.calls;
  draw_count.vertices += count * instances;
  glDrawElementsInstanced(mode, count, type, nullptr, instances);
}

void set_attribute(GLuint location, int components, std::size_t stride, std::size_t offset, GLuint divisor) {
  glEnableVertexAttribArray(location);
  glVertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                        reinterpret_cast<const void*>(offset));
  glVertexAttribDivisor(location, divisor);
}

}  // namespace marey::app::gl
