// SPDX-License-Identifier: MIT
// A window on the display, what its pictures are drawn with, and how they get onto it.
#pragma once

#include "app/session/saved/window_place.h"
#include "app/window/plain_window.h"
#include "app/window/screen/screen.h"

#include <memory>
#include <optional>
#include <string>

namespace polhode {

/// GLFW while it lives; one at a time.
class Glfw {
 public:
  /// An error where there is no display; names `export`.
  static Result<std::unique_ptr<Glfw>> start();
  ~Glfw();
  Glfw(const Glfw&) = delete;
  Glfw& operator=(const Glfw&) = delete;

 private:
  Glfw() = default;
};

struct WindowDeleter {
  void operator()(GLFWwindow* window) const;
};
using WindowPointer = std::unique_ptr<GLFWwindow, WindowDeleter>;

/// With the display's OpenGL; where that is not 3.3, off-screen in a plain window. Needs a Glfw.
class Display {
 public:
  /// `fonts` must outlive it. What is not known of its place is as usual. The error says why neither is
  /// possible.
  static Result<std::unique_ptr<Display>> open(const Fonts& fonts, const WindowPlace& place = {});

  GLFWwindow* window() const { return window_.get(); }
  Screen& screen() { return *screen_; }
  /// Why there is no OpenGL in the window; empty: there is.
  const std::string& fallback() const { return fallback_; }
  /// The screen's picture, onto the window.
  void present();

 private:
  Display() = default;
  Status open_with_opengl(const Fonts& fonts, Size size);
  Status fall_back(const Fonts& fonts, const std::string& why, Size size);

  WindowPointer window_;
  std::unique_ptr<PlainWindow> plain_;
  std::unique_ptr<GlContext> context_;
  std::unique_ptr<Screen> screen_;
  std::optional<Gl> gl_;
  std::string fallback_;
};

/// A second window beside a display's, for pictures that are drawn in that one's context.
class SecondDisplay {
 public:
  /// On another monitor than the first, which goes to the last one if there are several; on the only one
  /// beside it, for which the first gives way if it has to, and comes back to its place when this one is
  /// gone. The first must outlive it. Leaves the first's context the current one.
  static Result<std::unique_ptr<SecondDisplay>> open(const Display& first, const char* title);
  ~SecondDisplay();

  GLFWwindow* window() const { return window_.get(); }
  void present(const Framebuffer& picture);
  /// Where the first was before it gave way; nothing: it did not.
  const std::optional<WindowPlace>& first_before() const { return first_before_; }

 private:
  explicit SecondDisplay(const Display& first) : first_(first) {}
  Status share();

  const Display& first_;
  WindowPointer window_;
  std::unique_ptr<PlainWindow> plain_;
  std::unique_ptr<GlContext> context_;
  std::optional<WindowPlace> first_before_;
  std::optional<Gl> gl_;  ///< of its own context, which has the first's textures
  unsigned around_ = 0;   ///< a framebuffer of its own around one of these
};

/// In the window's units.
WindowPlace place_of(GLFWwindow* window);

/// How many monitors there are.
int monitor_count();

/// Fills the screen of the monitor that the window is on, and gives the window back its place.
class FullScreen {
 public:
  explicit FullScreen(GLFWwindow* window) : window_(window) {}
  bool is_on() const;
  void set(bool on);
  /// Leaving it gives this place, whatever the window had before.
  void go_back_to(const WindowPlace& place);

 private:
  GLFWwindow* window_;
  int x_ = 0, y_ = 0, width_ = 0, height_ = 0;  ///< of the window before
};

}  // namespace polhode
