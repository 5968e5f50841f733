#include <GLES3/gl3.h>

#include <algorithm>

/// Stands in for glGetIntegerv in ImGui's renderer (cmake/third_party.cmake), which reads all state before it draws in
/// order to restore it. Asking the browser waits until the graphics card has drawn everything so far; the scene
/// renderer sets what it needs in each frame, so that any valid state will do.
extern "C" void marey_get_known_gl_state(GLenum name, GLint* values) {
  switch (name) {
    case GL_VIEWPORT:
    case GL_SCISSOR_BOX: std::fill_n(values, 4, 0); return;
    case GL_ACTIVE_TEXTURE: *values = GL_TEXTURE0; return;
    case GL_BLEND_EQUATION_RGB:
    case GL_BLEND_EQUATION_ALPHA: *values = GL_FUNC_ADD; return;
    case GL_BLEND_SRC_RGB:
    case GL_BLEND_SRC_ALPHA: *values = GL_ONE; return;
    case GL_BLEND_DST_RGB:
    case GL_BLEND_DST_ALPHA:
    case GL_CURRENT_PROGRAM:
    case GL_TEXTURE_BINDING_2D:
    case GL_SAMPLER_BINDING:
    case GL_ARRAY_BUFFER_BINDING:
    case GL_VERTEX_ARRAY_BINDING: *values = 0; return;
    default: glGetIntegerv(name, values);
  }
}
