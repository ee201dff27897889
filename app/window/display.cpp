// SPDX-License-Identifier: MIT
#include "app/window/display.h"

#include "app/window/speaker/two_places.h"
#include "app/window/window_context.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>

namespace polhode {

namespace {

constexpr int kWidth = 1280, kHeight = 800, kLeastWidth = 640, kLeastHeight = 480;

std::string last_glfw_error() {
  const char* text = nullptr;
  return glfwGetError(&text) == GLFW_NO_ERROR || !text ? "no reason given" : text;
}

/// As it was, but no larger than the screen is now.
Size fitting(Size size) {
  int x = 0, y = 0;
  Size room = size;
  if (GLFWmonitor* monitor = glfwGetPrimaryMonitor())
    glfwGetMonitorWorkarea(monitor, &x, &y, &room.width, &room.height);
  return {std::max(kLeastWidth, std::min(size.width, room.width)),
          std::max(kLeastHeight, std::min(size.height, room.height))};
}

/// Below it the bar has no room. Where a desktop counts pixels of the screen, as X11 does, text at 200 %
/// needs twice as many of them; no more than the screen has.
void limit_size(GLFWwindow* window) {
  float scale = 1, unused = 1;
  glfwGetWindowContentScale(window, &scale, &unused);
  int width = 0, height = 0, pixels = 0;
  glfwGetWindowSize(window, &width, &height);
  glfwGetFramebufferSize(window, &pixels, &height);
  const double units = pixels > 0 ? std::max(1.0, static_cast<double>(scale) * width / pixels) : 1.0;
  const Size least = fitting({static_cast<int>(kLeastWidth * units), static_cast<int>(kLeastHeight * units)});
  glfwSetWindowSizeLimits(window, least.width, least.height, GLFW_DONT_CARE, GLFW_DONT_CARE);
}

WindowPointer make_glfw_window(bool with_opengl, Size size, GLFWwindow* shared = nullptr) {
  const bool is_known = size.width > 0 && size.height > 0;
  size = is_known ? fitting(size) : Size{kWidth, kHeight};
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, is_known ? GLFW_FALSE : GLFW_TRUE);  // that one has been scaled
  // The page stays before the audience while the speaker's window has the keyboard, or goes.
  glfwWindowHint(GLFW_AUTO_ICONIFY, GLFW_FALSE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);  // all is drawn in framebuffers of our own
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  if (with_opengl) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  } else {
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  }
  WindowPointer window(glfwCreateWindow(size.width, size.height, "polhode", nullptr, shared));
  if (window) limit_size(window.get());
  return window;
}

/// That shows this place of the desktop; else the primary one. Null: there is none.
GLFWmonitor* monitor_at(int x, int y) {
  int count = 0;
  GLFWmonitor** monitors = glfwGetMonitors(&count);
  for (int i = 0; i < count; ++i) {
    int left = 0, top = 0;
    glfwGetMonitorPos(monitors[i], &left, &top);
    const GLFWvidmode* mode = glfwGetVideoMode(monitors[i]);
    if (mode && x >= left && y >= top && x < left + mode->width && y < top + mode->height) return monitors[i];
  }
  return glfwGetPrimaryMonitor();
}

/// The corner of what bars leave of the screen on which a window at this place is seen. Nothing: on one that
/// is unplugged by now.
std::optional<std::array<int, 2>> corner_around(const std::array<int, 2>& at) {
  constexpr int kSeen = 100;  // of its units at least
  int count = 0;
  GLFWmonitor** monitors = glfwGetMonitors(&count);
  for (int i = 0; i < count; ++i) {
    int left = 0, top = 0, width = 0, height = 0;
    glfwGetMonitorWorkarea(monitors[i], &left, &top, &width, &height);
    if (at[0] + kSeen > left && at[1] + kSeen > top && at[0] + kSeen <= left + width &&
        at[1] + kSeen <= top + height)
      return std::array{left, top};
  }
  return std::nullopt;
}

/// As much of a frame as is told of a window that may not be seen yet.
void put_back(GLFWwindow* window, const std::array<int, 2>& at) {
  const auto corner = corner_around(at);
  if (!corner) return;
  std::array<int, 2> frame{0, 0};
  glfwGetWindowFrameSize(window, &frame[0], &frame[1], nullptr, nullptr);
  const auto [x, y] = with_frame_seen(at, *corner, frame);
  glfwSetWindowPos(window, x, y);
}

}  // namespace

Result<std::unique_ptr<Glfw>> Glfw::start() {
#ifdef GLFW_PLATFORM
  // From version 3.4 on GLFW looks for Wayland before X11, and Wayland's library complains on stderr where it
  // is not.
  if (!std::getenv("WAYLAND_DISPLAY") && !std::getenv("WAYLAND_SOCKET"))
    glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
  if (glfwInit() != GLFW_TRUE)
    return failure(
        fmt::format("no window can be opened here ({}); without a display, write the pages to files: "
                    "polhode export LESSON -o DIR",
                    last_glfw_error()));
  return std::unique_ptr<Glfw>(new Glfw);
}

Glfw::~Glfw() { glfwTerminate(); }

void WindowDeleter::operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }

WindowPlace place_of(GLFWwindow* window) {
  WindowPlace place{.size = {}, .at = {{0, 0}}};
  glfwGetWindowSize(window, &place.size.width, &place.size.height);
  glfwGetWindowPos(window, &(*place.at)[0], &(*place.at)[1]);
  return place;
}

Result<std::unique_ptr<Display>> Display::open(const Fonts& fonts, const WindowPlace& place) {
  std::unique_ptr<Display> display(new Display);
  if (const Status opened = display->open_with_opengl(fonts, place.size); !opened)
    if (const Status fallen = display->fall_back(fonts, opened.error(), place.size); !fallen)
      return failure(fallen.error());
  if (place.at) put_back(display->window(), *place.at);
  return display;
}

Status Display::open_with_opengl(const Fonts& fonts, Size size) {
  window_ = make_glfw_window(true, size);
  if (!window_) return failure(last_glfw_error());
  auto context = context_of_window(window_.get());
  if (!context) return failure(context.error());
  auto screen = Screen::create(**context, fonts);
  if (!screen) return failure(screen.error());
  auto table = Gl::load(**context);
  if (!table) return failure(table.error());
  glfwSwapInterval(1);
  context_ = std::move(context).value();
  screen_ = std::move(screen).value();
  gl_ = *table;
  return success();
}

void Display::present() {
  const Framebuffer& shown = screen_->for_audience();
  if (plain_) return plain_->show(shown.read());
  // What is frozen fills a window that has another size by now.
  const Size from = shown.size(), to = screen_->picture().size();
  gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, shown.resolved());
  gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  gl_->BlitFramebuffer(0, 0, from.width, from.height, 0, 0, to.width, to.height, GL_COLOR_BUFFER_BIT,
                       from == to ? GL_NEAREST : GL_LINEAR);
  glfwSwapBuffers(window_.get());
}

/// Off-screen, and the pictures in a plain window. The off-screen context may be on this thread: GLFW calls
/// no OpenGL then.
Status Display::fall_back(const Fonts& fonts, const std::string& why, Size size) {
  window_ = make_glfw_window(false, size);
  if (!window_)
    return failure(fmt::format(
        "no window can be opened here ({}); pages can be written to files: polhode export LESSON -o "
        "DIR",
        last_glfw_error()));
  auto plain = PlainWindow::create(window_.get());
  auto context = plain ? open_context(ContextKind::any)
                       : Result<std::unique_ptr<GlContext>>(failure("no plain window: " + plain.error()));
  if (!context)
    return failure(
        fmt::format("the window has no OpenGL 3.3 ({}), and there is nothing else to draw with: {} Pages "
                    "can be written to files where there is: polhode export LESSON -o DIR",
                    why, context.error()));
  auto screen = Screen::create(**context, fonts);
  if (!screen) return failure(screen.error());
  plain_ = std::move(plain).value();
  context_ = std::move(context).value();
  screen_ = std::move(screen).value();
  fallback_ = why;
  return success();
}

int monitor_count() {
  int count = 0;
  glfwGetMonitors(&count);
  return count;
}

namespace {

/// Where a window can be on a monitor without covering its bars.
void move_onto(GLFWmonitor* monitor, GLFWwindow* window) {
  int x = 0, y = 0, width = 0, height = 0;
  glfwGetMonitorWorkarea(monitor, &x, &y, &width, &height);
  glfwSetWindowPos(window, x, y);
}

/// With its frame.
DesktopBox box_of(GLFWwindow* window) {
  int left = 0, top = 0, right = 0, bottom = 0;
  glfwGetWindowFrameSize(window, &left, &top, &right, &bottom);
  const WindowPlace place = place_of(window);
  return {(*place.at)[0] - left,
          (*place.at)[1] - top,
          {place.size.width + left + right, place.size.height + top + bottom}};
}

/// By the frame of one that is seen: that of a new window is not known yet.
void move_to(GLFWwindow* window, const DesktopBox& box, GLFWwindow* framed) {
  int left = 0, top = 0, right = 0, bottom = 0;
  glfwGetWindowFrameSize(framed, &left, &top, &right, &bottom);
  glfwSetWindowSize(window, box.size.width - left - right, box.size.height - top - bottom);
  glfwSetWindowPos(window, box.x + left, box.y + top);
}

/// On one screen, so that both are seen. True: the first had to give way.
bool move_apart(GLFWmonitor* monitor, GLFWwindow* first, GLFWwindow* second) {
  DesktopBox screen;
  glfwGetMonitorWorkarea(monitor, &screen.x, &screen.y, &screen.size.width, &screen.size.height);
  const DesktopBox before = box_of(first);
  const TwoPlaces places = two_places(screen, before, {kLeastWidth, kLeastHeight});
  const bool gives_way = places.first != before;
  if (gives_way) {
    if (glfwGetWindowAttrib(first, GLFW_MAXIMIZED) == GLFW_TRUE) glfwRestoreWindow(first);
    move_to(first, places.first, first);
  }
  move_to(second, places.second, first);
  return gives_way;
}

}  // namespace

Result<std::unique_ptr<SecondDisplay>> SecondDisplay::open(const Display& first, const char* title) {
  std::unique_ptr<SecondDisplay> second(new SecondDisplay(first));
  Size size;
  glfwGetWindowSize(first.window(), &size.width, &size.height);
  const bool has_opengl = first.fallback().empty();
  second->window_ = make_glfw_window(has_opengl, size, has_opengl ? first.window() : nullptr);
  if (!second->window_) return failure(last_glfw_error());
  glfwSetWindowTitle(second->window(), title);
  if (has_opengl) {
    if (const Status shared = second->share(); !shared) return failure(shared.error());
  } else {
    auto plain = PlainWindow::create(second->window());
    if (!plain) return failure(plain.error());
    second->plain_ = std::move(plain).value();
  }
  int count = 0;
  GLFWmonitor** monitors = glfwGetMonitors(&count);
  if (count > 1) {
    move_onto(monitors[count - 1], first.window());
    move_onto(monitors[0], second->window());
  } else if (count == 1) {
    const WindowPlace before = place_of(first.window());
    if (move_apart(monitors[0], first.window(), second->window())) second->first_before_ = before;
  }
  return second;
}

Status SecondDisplay::share() {
  auto context = context_of_window(window());
  Status made = success();
  if (context) {
    auto table = Gl::load(**context);
    if (table) {
      gl_ = *table;
      gl_->GenFramebuffers(1, &around_);
      glfwSwapInterval(0);  // the first one waits for its screen
      context_ = std::move(context).value();
    } else {
      made = failure(table.error());
    }
  } else {
    made = failure(context.error());
  }
  glfwMakeContextCurrent(first_.window());
  return made;
}

SecondDisplay::~SecondDisplay() {
  if (first_before_ && glfwGetWindowMonitor(first_.window()) == nullptr) {
    glfwSetWindowSize(first_.window(), first_before_->size.width, first_before_->size.height);
    glfwSetWindowPos(first_.window(), (*first_before_->at)[0], (*first_before_->at)[1]);
  }
  window_.reset();  // with its context and what that has
  if (first_.fallback().empty()) glfwMakeContextCurrent(first_.window());
}

void SecondDisplay::present(const Framebuffer& picture) {
  if (plain_) return plain_->show(picture.read());
  const Size size = picture.size();
  glfwMakeContextCurrent(window());
  gl_->BindFramebuffer(GL_FRAMEBUFFER, around_);
  gl_->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture.texture(), 0);
  gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  gl_->BlitFramebuffer(0, 0, size.width, size.height, 0, 0, size.width, size.height, GL_COLOR_BUFFER_BIT,
                       GL_NEAREST);
  glfwSwapBuffers(window());
  glfwMakeContextCurrent(first_.window());
}

bool FullScreen::is_on() const { return glfwGetWindowMonitor(window_) != nullptr; }

void FullScreen::go_back_to(const WindowPlace& place) {
  width_ = place.size.width;
  height_ = place.size.height;
  if (!place.at) return;
  x_ = (*place.at)[0];
  y_ = (*place.at)[1];
}

void FullScreen::set(bool on) {
  if (on == is_on()) return;
  if (!on) return glfwSetWindowMonitor(window_, nullptr, x_, y_, width_, height_, GLFW_DONT_CARE);
  glfwGetWindowPos(window_, &x_, &y_);
  glfwGetWindowSize(window_, &width_, &height_);
  GLFWmonitor* monitor = monitor_at(x_ + width_ / 2, y_ + height_ / 2);
  if (!monitor) return;
  const GLFWvidmode* mode = glfwGetVideoMode(monitor);
  glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

}  // namespace polhode
