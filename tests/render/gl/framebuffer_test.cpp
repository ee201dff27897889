// SPDX-License-Identifier: MIT
#include "render/gl/framebuffer.h"

#include "render/gl/shader.h"
#include "tests/render/gl/current.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <set>

namespace polhode {
namespace {

using test::Current;
using testing::AllOf;
using testing::HasSubstr;

std::array<int, 4> color(const Image& image, int x, int y) {
  const std::uint8_t* p = image.pixel(x, y);
  return {p[0], p[1], p[2], p[3]};
}

// A triangle over the half of the picture above its rising diagonal, in one colour.
void draw_triangle(const Gl& gl) {
  const Result<Program> program = Program::create(gl, "triangle", {R"(
    void main() {
      vec2 corner = vec2(gl_VertexID == 1 ? 1.0 : -1.0, gl_VertexID == 2 ? -1.0 : 1.0);
      gl_Position = vec4(corner.x, corner.y, 0.0, 1.0);
    })"},
                                                  {R"(
    uniform vec4 color;
    out vec4 fragment;
    void main() { fragment = color; })"});
  ASSERT_TRUE(program.ok()) << program.error();
  GLuint array = 0;
  gl.GenVertexArrays(1, &array);
  gl.BindVertexArray(array);
  program->use();
  program->set("color", 1.0f, 1.0f, 1.0f, 1.0f);
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.DeleteVertexArrays(1, &array);
}

class EachSampling : public testing::TestWithParam<std::tuple<ContextKind, int>> {
 protected:
  Current current_{std::get<0>(GetParam())};
  const Gl& gl_ = current_.gl;
  int samples_ = std::get<1>(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Framebuffer, EachSampling,
                         testing::Combine(testing::Values(ContextKind::osmesa, ContextKind::egl),
                                          testing::Values(0, 4)),
                         [](const auto& tested) {
                           return std::string(std::get<0>(tested.param) == ContextKind::egl ? "egl"
                                                                                            : "osmesa") +
                                  std::to_string(std::get<1>(tested.param));
                         });

TEST_P(EachSampling, ClearComesBackToTheBit) {
  const Result<Framebuffer> made = Framebuffer::create(gl_, {33, 17}, samples_);
  ASSERT_TRUE(made.ok()) << made.error();
  EXPECT_EQ(made->size(), (Size{33, 17}));
  EXPECT_EQ(made->samples(), samples_);
  gl_.ClearColor(10.0f / 255, 20.0f / 255, 30.0f / 255, 40.0f / 255);
  gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  made->resolve();
  const Image image = made->read();
  ASSERT_EQ(image.size, (Size{33, 17}));
  for (int y = 0; y < 17; ++y)
    for (int x = 0; x < 33; ++x) ASSERT_EQ(color(image, x, y), (std::array{10, 20, 30, 40}));
  EXPECT_EQ(pending_errors(gl_), "");
}

TEST_P(EachSampling, TopRowComesFirst) {
  const Result<Framebuffer> made = Framebuffer::create(gl_, {5, 4}, samples_);
  ASSERT_TRUE(made.ok()) << made.error();
  gl_.ClearColor(0, 0, 0, 1);
  gl_.Clear(GL_COLOR_BUFFER_BIT);
  // Row 3 of OpenGL, counted from below, is the top one.
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.Scissor(1, 3, 1, 1);
  gl_.ClearColor(1, 0, 0, 1);
  gl_.Clear(GL_COLOR_BUFFER_BIT);
  made->resolve();  // in spite of the scissor
  const Image image = made->read();
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 5; ++x)
      EXPECT_EQ(color(image, x, y)[0], x == 1 && y == 0 ? 255 : 0) << x << ", " << y;
}

TEST_P(EachSampling, EdgesAreAveragedOnlyWithSamples) {
  const Result<Framebuffer> made = Framebuffer::create(gl_, {40, 25}, samples_);
  ASSERT_TRUE(made.ok()) << made.error();
  gl_.ClearColor(0, 0, 0, 1);
  gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  draw_triangle(gl_);
  made->resolve();
  const Image image = made->read();
  std::set<int> levels;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) levels.insert(image.rgba[i]);
  EXPECT_TRUE(levels.contains(0) && levels.contains(255));
  EXPECT_EQ(levels.size() > 2, samples_ > 0);
  EXPECT_LE(levels.size(), 5u) << "four samples give quarters";
}

TEST_P(EachSampling, DepthHidesWhatIsBehind) {
  const Result<Framebuffer> made = Framebuffer::create(gl_, {8, 8}, samples_);
  ASSERT_TRUE(made.ok()) << made.error();
  gl_.Enable(GL_DEPTH_TEST);
  gl_.ClearColor(0, 0, 0, 1);
  for (const float depth : {0.0f, 1.0f}) {  // nearest, farthest; the triangle is between
    made->bind();
    gl_.Clear(GL_COLOR_BUFFER_BIT);
    gl_.ClearBufferfv(GL_DEPTH, 0, &depth);
    draw_triangle(gl_);
    made->resolve();
    EXPECT_EQ(color(made->read(), 1, 1)[0], depth == 0.0f ? 0 : 255);
  }
}

TEST_P(EachSampling, MovedFromOwnsNothing) {
  Result<Framebuffer> first = Framebuffer::create(gl_, {4, 4}, samples_);
  Result<Framebuffer> second = Framebuffer::create(gl_, {6, 6}, samples_);
  ASSERT_TRUE(first.ok() && second.ok());
  const GLuint texture = second->texture();
  *first = std::move(*second);
  EXPECT_EQ(first->texture(), texture);
  EXPECT_EQ(second->texture(), 0u);
  EXPECT_EQ(first->size(), (Size{6, 6}));
  first->bind();
  EXPECT_EQ(gl_.CheckFramebufferStatus(GL_FRAMEBUFFER), GLenum{GL_FRAMEBUFFER_COMPLETE});
  EXPECT_EQ(pending_errors(gl_), "");
}

TEST(Framebuffer, BothContextsGiveTheSameBytes) {
  std::vector<std::uint8_t> first;
  for (const ContextKind kind : {ContextKind::osmesa, ContextKind::egl}) {
    const Current current(kind);
    const Result<Framebuffer> made = Framebuffer::create(current.gl, {64, 47}, 4);
    ASSERT_TRUE(made.ok()) << made.error();
    current.gl.ClearColor(0.2f, 0.3f, 0.4f, 1.0f);
    current.gl.Clear(GL_COLOR_BUFFER_BIT);
    draw_triangle(current.gl);
    made->resolve();
    const Image image = made->read();
    if (first.empty()) first = image.rgba;
    EXPECT_TRUE(image.rgba == first);
  }
}

TEST(Framebuffer, ImpossibleSizesAndSamplesAreRefusedByNumber) {
  const Current current;
  const GlLimits most = limits(current.gl);
  const auto error = [&](Size size, int samples) {
    const Result<Framebuffer> made = Framebuffer::create(current.gl, size, samples);
    return made ? std::string("made") : made.error();
  };
  const int side = most.texture_side + 1;
  EXPECT_THAT(error({side, 4}, 4),
              AllOf(HasSubstr(std::to_string(side)), HasSubstr(std::to_string(side - 1))));
  EXPECT_THAT(error({4, side}, 0), HasSubstr("too large"));
  EXPECT_THAT(error({0, 4}, 0), HasSubstr("no pixels"));
  EXPECT_THAT(error({4, -1}, 0), HasSubstr("no pixels"));
  EXPECT_THAT(error({4, 4}, most.samples + 1), HasSubstr("at most " + std::to_string(most.samples)));
  EXPECT_THAT(error({4, 4}, -1), HasSubstr("samples"));
}

TEST(Framebuffer, WhatTheDriverRefusesIsSaidWithItsMemory) {
  const Current current;
  const Result<Framebuffer> made = Framebuffer::create(current.gl, {16384, 16384}, 4);
  if (made) GTEST_SKIP() << "this driver (" << driver_name(current.gl) << ") has 10 GB for a picture";
  EXPECT_THAT(made.error(), AllOf(HasSubstr("16384 x 16384 px with 4 samples"), HasSubstr("MB")));
}

}  // namespace
}  // namespace polhode
