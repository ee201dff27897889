// SPDX-License-Identifier: MIT
#include "app/window/controls/control_pass.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace polhode {

namespace {

constexpr std::string_view kVertex = R"(
layout(location = 0) in vec2 a_position;
layout(location = 1) in vec2 a_place;
layout(location = 2) in vec4 a_color;
uniform vec4 u_display;  // x, y, width, height
out vec2 v_place;
out vec4 v_color;
void main() {
  v_place = a_place;
  v_color = a_color;
  vec2 at = (a_position - u_display.xy) / u_display.zw;
  gl_Position = vec4(2.0 * at.x - 1.0, 1.0 - 2.0 * at.y, 0.0, 1.0);
}
)";

constexpr std::string_view kFragment = R"(
in vec2 v_place;
in vec4 v_color;
uniform sampler2D u_texture;  // coverage in red; or a picture, premultiplied
uniform float u_is_picture;
out vec4 o_color;
void main() {
  vec4 texel = texture(u_texture, v_place);
  float alpha = v_color.a * texel.r;
  o_color = u_is_picture > 0.5 ? v_color.a * texel : vec4(v_color.rgb * alpha, alpha);
}
)";

struct ControlVertex {
  std::array<float, 2> position, place;
  std::array<float, 4> color;
};

std::array<float, 4> color_of(ImU32 packed) {
  const auto channel = [&](int shift) { return static_cast<float>((packed >> shift) & 0xFFU) / 255.0F; };
  return {channel(IM_COL32_R_SHIFT), channel(IM_COL32_G_SHIFT), channel(IM_COL32_B_SHIFT),
          channel(IM_COL32_A_SHIFT)};
}

Geometry<ControlVertex> geometry_of(const ImDrawList& list) {
  Geometry<ControlVertex> geometry;
  geometry.vertices.reserve(static_cast<std::size_t>(list.VtxBuffer.Size));
  for (const ImDrawVert& v : list.VtxBuffer)
    geometry.vertices.push_back({{v.pos.x, v.pos.y}, {v.uv.x, v.uv.y}, color_of(v.col)});
  geometry.indices.reserve(static_cast<std::size_t>(list.IdxBuffer.Size));
  for (const ImDrawCmd& command : list.CmdBuffer)
    for (unsigned i = 0; i < command.ElemCount; ++i)
      geometry.indices.push_back(command.VtxOffset + list.IdxBuffer[static_cast<int>(command.IdxOffset + i)]);
  return geometry;
}

/// Nothing of what has no name: that is the atlas.
GLuint texture_of(ImTextureID name) { return static_cast<GLuint>((std::uintptr_t)name); }

}  // namespace

// A pointer or a whole number, as the version has it.
ImTextureID control_texture(GLuint texture) { return (ImTextureID) static_cast<std::uintptr_t>(texture); }

Result<std::unique_ptr<ControlPass>> ControlPass::create(const Gl& gl) {
  auto program = Program::create(gl, "controls", {kVertex}, {kFragment});
  if (!program) return failure(program.error());
  return std::unique_ptr<ControlPass>(new ControlPass(gl, std::move(program).value()));
}

ControlPass::ControlPass(const Gl& gl, Program program)
    : gl_(gl), program_(std::move(program)), stream_(gl, {2, 2, 4}) {
  gl_.GenTextures(1, &atlas_);
}

ControlPass::~ControlPass() { gl_.DeleteTextures(1, &atlas_); }

void ControlPass::load_fonts() {
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D, atlas_);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, width, height, 0, GL_RED, GL_UNSIGNED_BYTE, pixels);
  for (const GLenum filter : {GLenum{GL_TEXTURE_MIN_FILTER}, GLenum{GL_TEXTURE_MAG_FILTER}})
    gl_.TexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  for (const GLenum wrap : {GLenum{GL_TEXTURE_WRAP_S}, GLenum{GL_TEXTURE_WRAP_T}})
    gl_.TexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
}

void ControlPass::draw(const ImDrawData& data, const Framebuffer& onto) const {
  onto.bind();
  gl_.Enable(GL_BLEND);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.Disable(GL_CULL_FACE);
  gl_.BlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.ActiveTexture(GL_TEXTURE0);
  program_.use();
  program_.set("u_texture", 0);
  program_.set("u_display", data.DisplayPos.x, data.DisplayPos.y, data.DisplaySize.x, data.DisplaySize.y);
  for (int i = 0; i < data.CmdListsCount; ++i) {
    const ImDrawList& list = *data.CmdLists[i];
    stream_.upload(geometry_of(list));
    std::size_t first = 0;
    for (const ImDrawCmd& command : list.CmdBuffer) {
      const auto px = [](float along, float origin, float scale) {
        return static_cast<int>(std::lround((along - origin) * scale));
      };
      const ImVec2 at = data.DisplayPos, scale = data.FramebufferScale;
      const int x0 = std::max(0, px(command.ClipRect.x, at.x, scale.x)),
                x1 = px(command.ClipRect.z, at.x, scale.x);
      const int y0 = std::max(0, px(command.ClipRect.y, at.y, scale.y)),
                y1 = px(command.ClipRect.w, at.y, scale.y);
      if (x0 < x1 && y0 < y1) {
        const GLuint picture = texture_of(command.GetTexID());
        gl_.BindTexture(GL_TEXTURE_2D, picture != 0 ? picture : atlas_);
        program_.set("u_is_picture", picture != 0 ? 1.0F : 0.0F);
        gl_.Scissor(x0, onto.size().height - y1, x1 - x0, y1 - y0);
        stream_.draw_range(first, command.ElemCount);
      }
      first += command.ElemCount;
    }
  }
  gl_.Disable(GL_SCISSOR_TEST);
}

}  // namespace polhode
