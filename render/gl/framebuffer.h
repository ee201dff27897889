// SPDX-License-Identifier: MIT
// Where all drawing goes: an RGBA8 texture with 24-bit depth; one with several samples a pixel is resolved to
// such a texture. The window shows it and the exporter reads it, so both are the same pixels. No sRGB
// conversion by the driver.
#pragma once

#include "base/result.h"
#include "render/gl/context/functions.h"
#include "render/image/image.h"

namespace polhode {

/// A part of a picture, in px.
struct PixelArea {
  int x = 0, y = 0;  ///< of the lower left corner
  int width = 0, height = 0;
};

/// Owns the GL objects; `gl` must outlive it, and its context be current wherever it is used or destroyed.
/// Memory: 4 (1 + 2 samples) bytes a pixel, or 8 without multisampling.
class Framebuffer {
 public:
  /// `samples` 0: no multisampling. OpenGL 3.3 promises 4, llvmpipe has no more. The error names size,
  /// samples, and the driver's limit or refusal. Leaves this framebuffer bound.
  static Result<Framebuffer> create(const Gl& gl, Size size, int samples);
  Framebuffer(Framebuffer&& other) noexcept;
  Framebuffer& operator=(Framebuffer&& other) noexcept;
  ~Framebuffer();

  Size size() const { return size_; }
  int samples() const { return samples_; }

  /// Draw into it from now on; sets the viewport to the whole of it.
  void bind() const;
  /// Averages the samples into the texture (nothing to do without multisampling). Disables the scissor test,
  /// which would cut the copy, and binds other framebuffers: bind() again before drawing more.
  void resolve() const { resolve({0, 0, size_.width, size_.height}); }
  void resolve(const PixelArea& part) const;
  /// Copies the resolved pixels into the texture of another one, whose lower left corner of them lies at (x,
  /// y); what falls outside is left out.
  void copy_to(const Framebuffer& other, int x, int y) const { copy_to(other, x, y, size_); }
  /// Enlarged or reduced to `size`, between pixels in proportion.
  void copy_to(const Framebuffer& other, int x, int y, Size size) const;
  /// Copies the resolved pixels into what the context shows, a canvas of the same size.
  void show() const;
  /// The texture's pixels, top row first, as they were drawn: alpha stays premultiplied if the drawing
  /// premultiplied. Call resolve() before. 1080p: 2 ms of CPU.
  Image read() const;

  /// What resolve() fills: RGBA8, one level, nearest, clamped; the bottom row first.
  GLuint texture() const { return names_.texture; }
  /// A framebuffer around that texture, to read or blit from.
  GLuint resolved() const { return names_.resolved; }

 private:
  struct Names {
    GLuint drawn = 0;  ///< equals `resolved` without multisampling
    GLuint resolved = 0;
    GLuint texture = 0;
    GLuint color = 0;  ///< multisampled renderbuffer
    GLuint depth = 0;
  };
  Framebuffer(const Gl& gl, Size size, int samples) : gl_(&gl), size_(size), samples_(samples) {}
  void generate();
  void attach_texture() const;
  void attach_buffers() const;
  Status check() const;
  void destroy();

  const Gl* gl_;
  Size size_;
  int samples_;
  Names names_;
};

}  // namespace polhode
