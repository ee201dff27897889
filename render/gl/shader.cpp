// SPDX-License-Identifier: MIT
#include "render/gl/shader.h"

#include <utility>

namespace polhode {
namespace {

template <class Query, class Log>
std::string log_of(GLuint object, Query query, Log log) {
  GLint length = 0;
  query(object, GL_INFO_LOG_LENGTH, &length);
  std::string text(static_cast<std::size_t>(length > 0 ? length : 0), '\0');
  GLsizei written = 0;
  if (length > 0) log(object, length, &written, text.data());
  text.resize(static_cast<std::size_t>(written));
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return text.empty() ? "the driver gives no reason" : text;
}

// The language of OpenGL 3.3, or that of WebGL 2 and OpenGL ES 3, which has to be told how exact numbers are,
// and has no `noperspective`: where shaders say it, w is 1, and it changes the cost alone.
std::string_view version_lines(const Gl& gl) {
  const GLubyte* version = gl.GetString(GL_VERSION);
  const std::string_view name = version ? reinterpret_cast<const char*>(version) : "";
  return name.starts_with("OpenGL ES") ? "#version 300 es\nprecision highp float;\nprecision highp int;\n"
                                         "precision highp sampler2D;\n#define noperspective\n"
                                       : "#version 330 core\n";
}

Result<GLuint> compile(const Gl& gl, const std::string& name, GLenum stage,
                       const std::vector<std::string_view>& parts) {
  const GLuint shader = gl.CreateShader(stage);
  std::string source(version_lines(gl));
  for (const std::string_view part : parts) source += part;
  const GLchar* text = source.data();
  const GLint length = static_cast<GLint>(source.size());
  gl.ShaderSource(shader, 1, &text, &length);
  gl.CompileShader(shader);
  GLint compiled = GL_FALSE;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_TRUE) return shader;
  const std::string log = log_of(shader, gl.GetShaderiv, gl.GetShaderInfoLog);
  gl.DeleteShader(shader);
  return failure("The " + std::string(stage == GL_VERTEX_SHADER ? "vertex" : "fragment") + " shader of \"" +
                 name + "\" does not compile: " + log);
}

// Links and lets go of the shaders, which the program keeps alive as long as it needs them.
Result<GLuint> link(const Gl& gl, const std::string& name, GLuint vertex, GLuint fragment) {
  const GLuint program = gl.CreateProgram();
  for (const GLuint shader : {vertex, fragment}) gl.AttachShader(program, shader);
  gl.LinkProgram(program);
  for (const GLuint shader : {vertex, fragment}) {
    gl.DetachShader(program, shader);
    gl.DeleteShader(shader);
  }
  GLint linked = GL_FALSE;
  gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return program;
  const std::string log = log_of(program, gl.GetProgramiv, gl.GetProgramInfoLog);
  gl.DeleteProgram(program);
  return failure("The shader program \"" + name + "\" does not link: " + log);
}

}  // namespace

Result<Program> Program::create(const Gl& gl, const std::string& name,
                                const std::vector<std::string_view>& vertex,
                                const std::vector<std::string_view>& fragment) {
  const Result<GLuint> vertex_shader = compile(gl, name, GL_VERTEX_SHADER, vertex);
  if (!vertex_shader) return failure(vertex_shader.error());
  const Result<GLuint> fragment_shader = compile(gl, name, GL_FRAGMENT_SHADER, fragment);
  if (!fragment_shader) {
    gl.DeleteShader(*vertex_shader);
    return failure(fragment_shader.error());
  }
  const Result<GLuint> program = link(gl, name, *vertex_shader, *fragment_shader);
  if (!program) return failure(program.error());
  return Program(gl, *program);
}

Program::Program(Program&& other) noexcept : gl_(other.gl_), handle_(std::exchange(other.handle_, 0)) {}

Program& Program::operator=(Program&& other) noexcept {
  std::swap(gl_, other.gl_);
  std::swap(handle_, other.handle_);
  return *this;
}

Program::~Program() {
  if (handle_ != 0) gl_->DeleteProgram(handle_);
}

void Program::set(const char* name, int value) const { gl_->Uniform1i(uniform(name), value); }

void Program::set(const char* name, float value) const { gl_->Uniform1f(uniform(name), value); }

void Program::set(const char* name, float x, float y) const { gl_->Uniform2f(uniform(name), x, y); }

void Program::set(const char* name, float x, float y, float z) const {
  gl_->Uniform3f(uniform(name), x, y, z);
}

void Program::set(const char* name, float x, float y, float z, float w) const {
  gl_->Uniform4f(uniform(name), x, y, z, w);
}

void Program::set_mat3(const char* name, std::span<const float, 9> columns) const {
  gl_->UniformMatrix3fv(uniform(name), 1, GL_FALSE, columns.data());
}

void Program::set_mat4(const char* name, std::span<const float, 16> columns) const {
  gl_->UniformMatrix4fv(uniform(name), 1, GL_FALSE, columns.data());
}

void Program::set_array(const char* name, int components, std::span<const float> values) const {
  const GLsizei count = static_cast<GLsizei>(values.size()) / components;
  if (components == 1) gl_->Uniform1fv(uniform(name), count, values.data());
  if (components == 2) gl_->Uniform2fv(uniform(name), count, values.data());
  if (components == 3) gl_->Uniform3fv(uniform(name), count, values.data());
  if (components == 4) gl_->Uniform4fv(uniform(name), count, values.data());
}

}  // namespace polhode
