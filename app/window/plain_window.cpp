// SPDX-License-Identifier: MIT
#include "app/window/plain_window.h"

#define GLFW_INCLUDE_NONE
#define GLFW_EXPOSE_NATIVE_X11
#include <GLFW/glfw3.h>
#include <GLFW/glfw3native.h>
#include <X11/Xutil.h>

#include <cstdlib>

namespace polhode {

namespace {

/// Rows of 32-bit pixels as the usual visuals have them: red in the third byte.
class XWindow final : public PlainWindow {
 public:
  XWindow(Display* display, Window window, const XWindowAttributes& look)
      : display_(display), window_(window), look_(look), pen_(XCreateGC(display, window, 0, nullptr)) {}
  ~XWindow() override { XFreeGC(display_, pen_); }

  void show(const Image& picture) override {
    pixels_.resize(picture.rgba.size());
    for (std::size_t i = 0; i < pixels_.size(); i += 4) {
      pixels_[i] = static_cast<char>(picture.rgba[i + 2]);
      pixels_[i + 1] = static_cast<char>(picture.rgba[i + 1]);
      pixels_[i + 2] = static_cast<char>(picture.rgba[i]);
      pixels_[i + 3] = static_cast<char>(0xFF);
    }
    const auto width = static_cast<unsigned>(picture.size.width),
               height = static_cast<unsigned>(picture.size.height);
    XImage* image = XCreateImage(display_, look_.visual, static_cast<unsigned>(look_.depth), ZPixmap, 0,
                                 pixels_.data(), width, height, 32, 0);
    if (!image) return;
    image->byte_order = LSBFirst;
    XPutImage(display_, window_, pen_, image, 0, 0, 0, 0, width, height);
    XFlush(display_);
    image->data = nullptr;  // ours
    XDestroyImage(image);
  }

 private:
  Display* display_;
  Window window_;
  XWindowAttributes look_;
  GC pen_;
  std::vector<char> pixels_;
};

}  // namespace

Result<std::unique_ptr<PlainWindow>> PlainWindow::create(GLFWwindow* window) {
  Display* display = glfwGetX11Display();
  const Window native = display ? glfwGetX11Window(window) : 0;
  XWindowAttributes look{};
  if (native == 0 || XGetWindowAttributes(display, native, &look) == 0)
    return failure("this display is not X11.");
  if (look.depth < 24 || look.visual->red_mask != 0xFF0000 || look.visual->blue_mask != 0xFF)
    return failure("this display has " + std::to_string(look.depth) + " bits a pixel, 24 are needed.");
  return std::unique_ptr<PlainWindow>(new XWindow(display, native, look));
}

}  // namespace polhode
