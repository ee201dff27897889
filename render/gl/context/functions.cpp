// SPDX-License-Identifier: MIT
#include "render/gl/context/functions.h"

namespace polhode {
namespace {

const char* error_name(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM:
      return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
      return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
      return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
      return "GL_OUT_OF_MEMORY";
    default:
      return "an unknown GL error";
  }
}

std::string text_of(const Gl& gl, GLenum name) {
  const GLubyte* text = gl.GetString(name);
  return text ? reinterpret_cast<const char*>(text) : "?";
}

}  // namespace

Result<Gl> Gl::load(const GlContext& context) {
  Gl gl;
  std::string missing;
#define POLHODE_GL_LOAD(name, TYPE)                                            \
  gl.name = reinterpret_cast<PFNGL##TYPE##PROC>(context.function("gl" #name)); \
  if (!gl.name) missing += missing.empty() ? "gl" #name : ", gl" #name;
  POLHODE_GL_FUNCTIONS(POLHODE_GL_LOAD)
#undef POLHODE_GL_LOAD
  if (!missing.empty())
    return failure("The OpenGL driver lacks functions of OpenGL 3.3: " + missing + "; install a newer Mesa.");
  return gl;
}

GlLimits limits(const Gl& gl) {
  GlLimits found;
  gl.GetIntegerv(GL_MAX_SAMPLES, &found.samples);
  gl.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &found.renderbuffer_side);
  gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &found.texture_side);
  return found;
}

std::string driver_name(const Gl& gl) { return text_of(gl, GL_RENDERER) + "; " + text_of(gl, GL_VERSION); }

std::string pending_errors(const Gl& gl) {
  std::string names;
  // A lost context may report for ever: eight are enough to see what happened.
  for (int i = 0; i < 8; ++i) {
    const GLenum error = gl.GetError();
    if (error == GL_NO_ERROR) break;
    names += (names.empty() ? "" : ", ") + std::string(error_name(error));
  }
  return names;
}

}  // namespace polhode
