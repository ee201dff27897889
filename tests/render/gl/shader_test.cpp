// SPDX-License-Identifier: MIT
#include "render/gl/shader.h"

#include "render/gl/framebuffer.h"
#include "tests/render/gl/current.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

namespace polhode {
namespace {

using test::Current;
using testing::AllOf;
using testing::HasSubstr;

constexpr const char* kVertex =
    R"(void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); })";
constexpr const char* kWhite = R"(out vec4 fragment;
void main() { fragment = vec4(1.0); })";

std::string error_of(const Gl& gl, const char* vertex, const char* fragment) {
  const Result<Program> program = Program::create(gl, "ellipsoid", {vertex}, {fragment});
  return program ? "linked" : program.error();
}

TEST(Shader, AMistakeIsReportedWithProgramStageLineAndLog) {
  const Current current;
  const std::string vertex = error_of(current.gl, "void main() { gl_Position = nothing; }", kWhite);
  EXPECT_THAT(vertex, AllOf(HasSubstr("vertex shader of \"ellipsoid\""), HasSubstr("nothing")));
  const std::string fragment = error_of(current.gl, kVertex, "\nvoid main() { oops(); }");
  EXPECT_THAT(fragment,
              AllOf(HasSubstr("fragment shader of \"ellipsoid\""), HasSubstr(":3("), HasSubstr("oops")));
  EXPECT_EQ(pending_errors(current.gl), "");
}

TEST(Shader, StagesThatDoNotFitAreReportedWithTheLog) {
  const Current current;
  const std::string error = error_of(current.gl,
                                     R"(out vec2 normal;
void main() { normal = vec2(0.0); gl_Position = vec4(0.0); })",
                                     R"(in vec3 normal;
out vec4 fragment;
void main() { fragment = vec4(normal, 1.0); })");
  EXPECT_THAT(error, AllOf(HasSubstr("\"ellipsoid\" does not link"), HasSubstr("normal")));
}

TEST(Shader, MovesAndLeavesNothingBehind) {
  const Current current;
  Result<Program> made = Program::create(current.gl, "white", {kVertex}, {kWhite});
  ASSERT_TRUE(made.ok()) << made.error();
  const auto used = [&](const Program& program) {
    program.use();
    GLint handle = 0;
    current.gl.GetIntegerv(GL_CURRENT_PROGRAM, &handle);
    return handle;
  };
  const GLint handle = used(*made);
  EXPECT_GT(handle, 0);
  Program moved = std::move(*made);
  EXPECT_EQ(used(moved), handle);
  EXPECT_EQ(used(*made), 0);
}

TEST(Shader, AnUnusedUniformIsNoError) {
  const Current current;
  const Result<Program> program = Program::create(current.gl, "white", {kVertex}, {kWhite});
  ASSERT_TRUE(program.ok()) << program.error();
  program->use();
  program->set("nothing", 1.0f);
  EXPECT_EQ(pending_errors(current.gl), "");
}

// Each sample of the table must reach the shader: a pixel is white if all of them did.
TEST(Shader, EveryKindOfUniformArrives) {
  const Current current;
  const Result<Framebuffer> made = Framebuffer::create(current.gl, {2, 2}, 0);
  ASSERT_TRUE(made.ok()) << made.error();
  const Result<Program> program = Program::create(current.gl, "uniforms", {kVertex}, {R"(
uniform int i; uniform float f; uniform vec2 v2; uniform vec3 v3; uniform vec4 v4; uniform mat3 m3; uniform mat4 m4;
uniform float f_list[2]; uniform vec2 v2_list[2]; uniform vec3 v3_list[2]; uniform vec4 v4_list[2];
out vec4 fragment;
void main() {
  bool scalars = i == -7 && f == 0.5;
  bool vectors = v2 == vec2(1, 2) && v3 == vec3(3, 4, 5) && v4 == vec4(6, 7, 8, 9);
  bool matrices = m3 * vec3(0, 1, 0) == vec3(4, 5, 6) && m4 * vec4(0, 0, 0, 1) == vec4(13, 14, 15, 16);
  bool lists = f_list[1] == 2.0 && v2_list[1] == vec2(3, 4) && v3_list[1] == vec3(4, 5, 6) && v4_list[1] == vec4(5, 6, 7, 8);
  fragment = vec4(scalars, vectors, matrices, lists);
})"});
  ASSERT_TRUE(program.ok()) << program.error();
  const std::array<float, 16> count{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
  program->use();
  program->set("i", -7);
  program->set("f", 0.5f);
  program->set("v2", std::array{1.0f, 2.0f});
  program->set("v3", std::array{3.0f, 4.0f, 5.0f});
  program->set("v4", std::array{6.0f, 7.0f, 8.0f, 9.0f});
  program->set_mat3("m3", std::span(count).first<9>());
  program->set_mat4("m4", count);
  program->set_array("f_list", 1, std::span(count).first(2));
  program->set_array("v2_list", 2, std::span(count).first(4));
  program->set_array("v3_list", 3, std::span(count).first(6));
  program->set_array("v4_list", 4, std::span(count).first(8));
  GLuint array = 0;
  current.gl.GenVertexArrays(1, &array);
  current.gl.BindVertexArray(array);
  current.gl.DrawArrays(GL_TRIANGLES, 0, 3);
  EXPECT_EQ(pending_errors(current.gl), "");
  const Image image = made->read();
  EXPECT_EQ(image.pixel(0, 0)[0], 255) << "scalars";
  EXPECT_EQ(image.pixel(0, 0)[1], 255) << "vectors";
  EXPECT_EQ(image.pixel(0, 0)[2], 255) << "matrices";
  EXPECT_EQ(image.pixel(0, 0)[3], 255) << "lists";
}

}  // namespace
}  // namespace polhode
