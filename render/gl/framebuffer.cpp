// SPDX-License-Identifier: MIT
#include "render/gl/framebuffer.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace polhode {
namespace {

std::string describe(Size size, int samples) {
  return std::to_string(size.width) + " x " + std::to_string(size.height) + " px" +
         (samples > 0 ? " with " + std::to_string(samples) + " samples" : "");
}

// Asked before anything is created: drivers answer too much with errors that do not say what was too much.
Status check_limits(const GlLimits& limits, Size size, int samples) {
  const int side = std::min(limits.renderbuffer_side, limits.texture_side);
  const std::string picture = "A picture of " + describe(size, samples);
  if (size.width < 1 || size.height < 1) return failure(picture + " has no pixels.");
  if (size.width > side || size.height > side)
    return failure(picture + " is too large: this OpenGL driver draws at most " + std::to_string(side) +
                   " px a side.");
  if (samples < 0 || samples > limits.samples)
    return failure(picture + " cannot be drawn: this OpenGL driver has at most " +
                   std::to_string(limits.samples) + " samples a pixel.");
  return success();
}

const char* status_name(GLenum status) {
  switch (status) {
    case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT:
      return "GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT";
    case GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT:
      return "GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT";
    case GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE:
      return "GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE";
    case GL_FRAMEBUFFER_UNSUPPORTED:
      return "GL_FRAMEBUFFER_UNSUPPORTED";
    default:
      return "an incomplete framebuffer";
  }
}

// Drivers answer bottom row first.
void flip_rows(Image& image) {
  const std::size_t row = 4 * static_cast<std::size_t>(image.size.width);
  std::vector<std::uint8_t> kept(row);
  std::uint8_t* low = image.rgba.data();
  std::uint8_t* high = low + row * static_cast<std::size_t>(image.size.height - 1);
  for (; low < high; low += row, high -= row) {
    std::memcpy(kept.data(), low, row);
    std::memcpy(low, high, row);
    std::memcpy(high, kept.data(), row);
  }
}

}  // namespace

Result<Framebuffer> Framebuffer::create(const Gl& gl, Size size, int samples) {
  const Status possible = check_limits(limits(gl), size, samples);
  if (!possible) return failure(possible.error());
  pending_errors(gl);  // forget what others left, so that what check() finds is ours
  Framebuffer made(gl, size, samples);
  made.generate();
  made.attach_texture();
  made.attach_buffers();
  const Status complete = made.check();
  if (!complete) return failure(complete.error());
  made.bind();
  return made;
}

Framebuffer::Framebuffer(Framebuffer&& other) noexcept
    : gl_(other.gl_), size_(other.size_), samples_(other.samples_), names_(std::exchange(other.names_, {})) {}

Framebuffer& Framebuffer::operator=(Framebuffer&& other) noexcept {
  if (this == &other) return *this;
  destroy();
  gl_ = other.gl_;
  size_ = other.size_;
  samples_ = other.samples_;
  names_ = std::exchange(other.names_, {});
  return *this;
}

Framebuffer::~Framebuffer() { destroy(); }

void Framebuffer::destroy() {
  // Moved from: no call, as the context may be gone by then.
  if (names_.resolved == 0) return;
  if (names_.drawn != names_.resolved) gl_->DeleteFramebuffers(1, &names_.drawn);
  gl_->DeleteFramebuffers(1, &names_.resolved);
  gl_->DeleteTextures(1, &names_.texture);
  gl_->DeleteRenderbuffers(1, &names_.color);
  gl_->DeleteRenderbuffers(1, &names_.depth);
  names_ = {};
}

void Framebuffer::generate() {
  gl_->GenFramebuffers(1, &names_.resolved);
  gl_->GenTextures(1, &names_.texture);
  gl_->GenRenderbuffers(1, &names_.depth);
  names_.drawn = names_.resolved;
  if (samples_ == 0) return;
  gl_->GenFramebuffers(1, &names_.drawn);
  gl_->GenRenderbuffers(1, &names_.color);
}

void Framebuffer::attach_texture() const {
  gl_->BindTexture(GL_TEXTURE_2D, names_.texture);
  gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size_.width, size_.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  nullptr);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, names_.resolved);
  gl_->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, names_.texture, 0);
}

void Framebuffer::attach_buffers() const {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, names_.drawn);
  if (names_.color != 0) {
    gl_->BindRenderbuffer(GL_RENDERBUFFER, names_.color);
    gl_->RenderbufferStorageMultisample(GL_RENDERBUFFER, samples_, GL_RGBA8, size_.width, size_.height);
    gl_->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, names_.color);
  }
  gl_->BindRenderbuffer(GL_RENDERBUFFER, names_.depth);
  gl_->RenderbufferStorageMultisample(GL_RENDERBUFFER, samples_, GL_DEPTH_COMPONENT24, size_.width,
                                      size_.height);
  gl_->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, names_.depth);
}

Status Framebuffer::check() const {
  std::string reason = pending_errors(*gl_);
  for (const GLuint name : {names_.drawn, names_.resolved}) {
    gl_->BindFramebuffer(GL_FRAMEBUFFER, name);
    const GLenum status = gl_->CheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE && reason.empty()) reason = status_name(status);
  }
  if (reason.empty()) return success();
  const double bytes = 4.0 * (samples_ > 0 ? 1 + 2 * samples_ : 2) * size_.width * size_.height;
  return failure("The OpenGL driver refuses a picture of " + describe(size_, samples_) + " (" + reason +
                 "), which takes about " + std::to_string(static_cast<long long>(bytes / 1e6) + 1) +
                 " MB of memory; ask for a smaller one.");
}

void Framebuffer::bind() const {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, names_.drawn);
  gl_->Viewport(0, 0, size_.width, size_.height);
}

void Framebuffer::resolve(const PixelArea& part) const {
  if (names_.drawn == names_.resolved) return;
  gl_->Disable(GL_SCISSOR_TEST);
  gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, names_.drawn);
  gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, names_.resolved);
  const int right = part.x + part.width, top = part.y + part.height;
  gl_->BlitFramebuffer(part.x, part.y, right, top, part.x, part.y, right, top, GL_COLOR_BUFFER_BIT,
                       GL_NEAREST);
}

void Framebuffer::copy_to(const Framebuffer& other, int x, int y, Size size) const {
  gl_->Disable(GL_SCISSOR_TEST);
  gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, names_.resolved);
  gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, other.names_.resolved);
  gl_->BlitFramebuffer(0, 0, size_.width, size_.height, x, y, x + size.width, y + size.height,
                       GL_COLOR_BUFFER_BIT, size == size_ ? GL_NEAREST : GL_LINEAR);
}

void Framebuffer::show() const {
  gl_->Disable(GL_SCISSOR_TEST);
  gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, names_.resolved);
  gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  gl_->BlitFramebuffer(0, 0, size_.width, size_.height, 0, 0, size_.width, size_.height, GL_COLOR_BUFFER_BIT,
                       GL_NEAREST);
}

Image Framebuffer::read() const {
  Image image = Image::blank(size_);
  gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, names_.resolved);
  gl_->PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl_->ReadPixels(0, 0, size_.width, size_.height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  flip_rows(image);
  return image;
}

}  // namespace polhode
