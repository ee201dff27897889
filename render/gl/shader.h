// SPDX-License-Identifier: MIT
// Shader programs, and their uniforms by name.
#pragma once

#include "base/result.h"
#include "render/gl/context/functions.h"

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// A linked vertex and fragment shader. `gl` must outlive it, and its context be current wherever it is used.
/// Attribute locations come from `layout(location = …)` in the source.
class Program {
 public:
  /// `name` is for messages ("body"). The error names program, stage and the driver's log.
  /// Each source is the version lines, which this adds for OpenGL or for OpenGL ES (where GL_ES is defined),
  /// and its parts one after the other: macros, functions that several shaders have, the shader.
  static Result<Program> create(const Gl& gl, const std::string& name,
                                const std::vector<std::string_view>& vertex,
                                const std::vector<std::string_view>& fragment);
  Program(Program&& other) noexcept;
  Program& operator=(Program&& other) noexcept;
  ~Program();

  void use() const { gl_->UseProgram(handle_); }

  // Each sets a uniform of this program, which must be in use; nothing where the program has none of that
  // name, or does not use it. Matrices: columns first, as Eigen and GLSL store them.
  void set(const char* name, int value) const;
  void set(const char* name, float value) const;
  void set(const char* name, float x, float y) const;
  void set(const char* name, float x, float y, float z) const;
  void set(const char* name, float x, float y, float z, float w) const;
  void set(const char* name, const std::array<float, 2>& v) const { set(name, v[0], v[1]); }
  void set(const char* name, const std::array<float, 3>& v) const { set(name, v[0], v[1], v[2]); }
  void set(const char* name, const std::array<float, 4>& v) const { set(name, v[0], v[1], v[2], v[3]); }
  void set_mat3(const char* name, std::span<const float, 9> columns) const;
  void set_mat4(const char* name, std::span<const float, 16> columns) const;
  /// An array of `components`-vectors: name[0], name[1], …
  void set_array(const char* name, int components, std::span<const float> values) const;

 private:
  Program(const Gl& gl, GLuint handle) : gl_(&gl), handle_(handle) {}
  GLint uniform(const char* name) const { return gl_->GetUniformLocation(handle_, name); }

  const Gl* gl_;
  GLuint handle_;
};

}  // namespace polhode
