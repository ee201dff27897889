// SPDX-License-Identifier: MIT
// Draws what Dear ImGui has laid out into a framebuffer of ours. Its own OpenGL 3 back end opens libGL by
// itself, and fails on an off-screen context; this one works on any.
#pragma once

#include "render/gl/framebuffer.h"
#include "render/gl/shader.h"
#include "render/gl/stream.h"

#include <imgui.h>

#include <memory>

namespace polhode {

/// Names a texture of the context to Dear ImGui: an RGBA picture, premultiplied, of one pixel for each of the
/// window's. The atlas of the fonts has no name.
ImTextureID control_texture(GLuint texture);

/// `gl` must outlive it, and its context be current wherever it is used or destroyed.
class ControlPass {
 public:
  static Result<std::unique_ptr<ControlPass>> create(const Gl& gl);
  ~ControlPass();
  ControlPass(const ControlPass&) = delete;
  ControlPass& operator=(const ControlPass&) = delete;

  /// The fonts of the current ImGui context, whenever they were built anew.
  void load_fonts();
  /// Over what is there, premultiplied.
  void draw(const ImDrawData& data, const Framebuffer& onto) const;

 private:
  ControlPass(const Gl& gl, Program program);

  const Gl& gl_;
  Program program_;
  VertexStream stream_;
  GLuint atlas_ = 0;  ///< of the fonts
};

}  // namespace polhode
