// SPDX-License-Identifier: MIT
// The OpenGL functions we call, fetched from the context at run time; no GL library is on the link line.
#pragma once

#include "base/result.h"
#include "render/gl/context/context.h"

#include <GL/glcorearb.h>

#include <string>

/// One row per function: its name without `gl`, and the middle of its type PFNGL…PROC in glcorearb.h. All of
/// OpenGL 3.3 core and, apart from ReadBuffer's and DrawBuffers' enumerants, of WebGL 2.
#define POLHODE_GL_FUNCTIONS(F)                                     \
  F(ActiveTexture, ACTIVETEXTURE)                                   \
  F(AttachShader, ATTACHSHADER)                                     \
  F(BindAttribLocation, BINDATTRIBLOCATION)                         \
  F(BindBuffer, BINDBUFFER)                                         \
  F(BindBufferBase, BINDBUFFERBASE)                                 \
  F(BindBufferRange, BINDBUFFERRANGE)                               \
  F(BindFramebuffer, BINDFRAMEBUFFER)                               \
  F(BindRenderbuffer, BINDRENDERBUFFER)                             \
  F(BindTexture, BINDTEXTURE)                                       \
  F(BindVertexArray, BINDVERTEXARRAY)                               \
  F(BlendColor, BLENDCOLOR)                                         \
  F(BlendEquation, BLENDEQUATION)                                   \
  F(BlendEquationSeparate, BLENDEQUATIONSEPARATE)                   \
  F(BlendFunc, BLENDFUNC)                                           \
  F(BlendFuncSeparate, BLENDFUNCSEPARATE)                           \
  F(BlitFramebuffer, BLITFRAMEBUFFER)                               \
  F(BufferData, BUFFERDATA)                                         \
  F(BufferSubData, BUFFERSUBDATA)                                   \
  F(CheckFramebufferStatus, CHECKFRAMEBUFFERSTATUS)                 \
  F(Clear, CLEAR)                                                   \
  F(ClearBufferfi, CLEARBUFFERFI)                                   \
  F(ClearBufferfv, CLEARBUFFERFV)                                   \
  F(ClearColor, CLEARCOLOR)                                         \
  F(ClearStencil, CLEARSTENCIL)                                     \
  F(ColorMask, COLORMASK)                                           \
  F(CompileShader, COMPILESHADER)                                   \
  F(CreateProgram, CREATEPROGRAM)                                   \
  F(CreateShader, CREATESHADER)                                     \
  F(CullFace, CULLFACE)                                             \
  F(DeleteBuffers, DELETEBUFFERS)                                   \
  F(DeleteFramebuffers, DELETEFRAMEBUFFERS)                         \
  F(DeleteProgram, DELETEPROGRAM)                                   \
  F(DeleteRenderbuffers, DELETERENDERBUFFERS)                       \
  F(DeleteShader, DELETESHADER)                                     \
  F(DeleteTextures, DELETETEXTURES)                                 \
  F(DeleteVertexArrays, DELETEVERTEXARRAYS)                         \
  F(DepthFunc, DEPTHFUNC)                                           \
  F(DepthMask, DEPTHMASK)                                           \
  F(DetachShader, DETACHSHADER)                                     \
  F(Disable, DISABLE)                                               \
  F(DisableVertexAttribArray, DISABLEVERTEXATTRIBARRAY)             \
  F(DrawArrays, DRAWARRAYS)                                         \
  F(DrawArraysInstanced, DRAWARRAYSINSTANCED)                       \
  F(DrawBuffers, DRAWBUFFERS)                                       \
  F(DrawElements, DRAWELEMENTS)                                     \
  F(DrawElementsInstanced, DRAWELEMENTSINSTANCED)                   \
  F(Enable, ENABLE)                                                 \
  F(EnableVertexAttribArray, ENABLEVERTEXATTRIBARRAY)               \
  F(Finish, FINISH)                                                 \
  F(Flush, FLUSH)                                                   \
  F(FramebufferRenderbuffer, FRAMEBUFFERRENDERBUFFER)               \
  F(FramebufferTexture2D, FRAMEBUFFERTEXTURE2D)                     \
  F(FrontFace, FRONTFACE)                                           \
  F(GenBuffers, GENBUFFERS)                                         \
  F(GenFramebuffers, GENFRAMEBUFFERS)                               \
  F(GenRenderbuffers, GENRENDERBUFFERS)                             \
  F(GenTextures, GENTEXTURES)                                       \
  F(GenVertexArrays, GENVERTEXARRAYS)                               \
  F(GenerateMipmap, GENERATEMIPMAP)                                 \
  F(GetAttribLocation, GETATTRIBLOCATION)                           \
  F(GetError, GETERROR)                                             \
  F(GetFloatv, GETFLOATV)                                           \
  F(GetIntegerv, GETINTEGERV)                                       \
  F(GetProgramInfoLog, GETPROGRAMINFOLOG)                           \
  F(GetProgramiv, GETPROGRAMIV)                                     \
  F(GetShaderInfoLog, GETSHADERINFOLOG)                             \
  F(GetShaderiv, GETSHADERIV)                                       \
  F(GetString, GETSTRING)                                           \
  F(GetStringi, GETSTRINGI)                                         \
  F(GetUniformLocation, GETUNIFORMLOCATION)                         \
  F(IsEnabled, ISENABLED)                                           \
  F(LinkProgram, LINKPROGRAM)                                       \
  F(PixelStorei, PIXELSTOREI)                                       \
  F(PolygonOffset, POLYGONOFFSET)                                   \
  F(ReadBuffer, READBUFFER)                                         \
  F(ReadPixels, READPIXELS)                                         \
  F(RenderbufferStorageMultisample, RENDERBUFFERSTORAGEMULTISAMPLE) \
  F(Scissor, SCISSOR)                                               \
  F(ShaderSource, SHADERSOURCE)                                     \
  F(TexImage2D, TEXIMAGE2D)                                         \
  F(TexParameteri, TEXPARAMETERI)                                   \
  F(TexSubImage2D, TEXSUBIMAGE2D)                                   \
  F(Uniform1f, UNIFORM1F)                                           \
  F(Uniform1fv, UNIFORM1FV)                                         \
  F(Uniform1i, UNIFORM1I)                                           \
  F(Uniform2f, UNIFORM2F)                                           \
  F(Uniform2fv, UNIFORM2FV)                                         \
  F(Uniform3f, UNIFORM3F)                                           \
  F(Uniform3fv, UNIFORM3FV)                                         \
  F(Uniform4f, UNIFORM4F)                                           \
  F(Uniform4fv, UNIFORM4FV)                                         \
  F(UniformMatrix3fv, UNIFORMMATRIX3FV)                             \
  F(UniformMatrix4fv, UNIFORMMATRIX4FV)                             \
  F(UseProgram, USEPROGRAM)                                         \
  F(VertexAttribDivisor, VERTEXATTRIBDIVISOR)                       \
  F(VertexAttribIPointer, VERTEXATTRIBIPOINTER)                     \
  F(VertexAttribPointer, VERTEXATTRIBPOINTER)                       \
  F(Viewport, VIEWPORT)

namespace polhode {

/// `gl.DrawArrays(…)` calls glDrawArrays in the context the table was loaded from. Plain pointers: copy
/// freely.
struct Gl {
#define POLHODE_GL_MEMBER(name, TYPE) PFNGL##TYPE##PROC name = nullptr;
  POLHODE_GL_FUNCTIONS(POLHODE_GL_MEMBER)
#undef POLHODE_GL_MEMBER

  /// The error names the functions that the context does not have.
  static Result<Gl> load(const GlContext& context);
};

/// What the driver says about itself. Needs a current context.
struct GlLimits {
  int samples = 0;            ///< GL_MAX_SAMPLES
  int renderbuffer_side = 0;  ///< px, GL_MAX_RENDERBUFFER_SIZE
  int texture_side = 0;       ///< px, GL_MAX_TEXTURE_SIZE
};
GlLimits limits(const Gl& gl);

/// "GL_RENDERER; GL_VERSION", for manifests and failed goldens.
std::string driver_name(const Gl& gl);

/// The names of all pending GL errors, joined with commas; empty if there is none. Clears them.
std::string pending_errors(const Gl& gl);

}  // namespace polhode
