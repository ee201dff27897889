// SPDX-License-Identifier: MIT
#include "app/window/window.h"

#include "app/interrupt.h"
#include "app/window/input_portion.h"
#include "app/window/key_names.h"
#include "app/window/plain_window.h"
#include "app/window/screen.h"
#include "app/window/window_context.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cstdlib>
#include <ctime>
#include <deque>
#include <fstream>

namespace polhode {

namespace {

constexpr int kWidth = 1280, kHeight = 800, kLeastWidth = 640, kLeastHeight = 480;
constexpr double kLeastFrame_s = 1.0 / 60;
/// Dear ImGui answers some input one or two frames later.
constexpr int kSettlingFrames = 3;
/// So long at most nothing is looked at: signals, changes of the lesson.
constexpr double kLongestWait_s = 0.5, kWatchEvery_s = 0.25;

std::string last_glfw_error() {
  const char* text = nullptr;
  return glfwGetError(&text) == GLFW_NO_ERROR || !text ? "no reason given" : text;
}

/// GLFW while it lives.
class Glfw {
 public:
  Glfw() {
    if (glfwInit() != GLFW_TRUE)
      throw CommandError(
          ExitCode::failed,
          fmt::format("no window can be opened here ({}); without a display, write the pages to files: "
                      "polhode export LESSON -o DIR",
                      last_glfw_error()));
  }
  ~Glfw() { glfwTerminate(); }
  Glfw(const Glfw&) = delete;
  Glfw& operator=(const Glfw&) = delete;
};

struct WindowDeleter {
  void operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }
};
using WindowPointer = std::unique_ptr<GLFWwindow, WindowDeleter>;

WindowPointer make_glfw_window(bool with_opengl) {
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
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
  WindowPointer window(glfwCreateWindow(kWidth, kHeight, "polhode", nullptr, nullptr));
  if (window)
    glfwSetWindowSizeLimits(window.get(), kLeastWidth, kLeastHeight, GLFW_DONT_CARE, GLFW_DONT_CARE);
  return window;
}

/// A window, what is drawn with, and how a picture gets from one to the other.
class Display {
 public:
  /// @throws CommandError
  Display() {
    window_ = make_glfw_window(true);
    std::string why = window_ ? "" : last_glfw_error();
    if (window_) {
      auto context = context_of_window(window_.get());
      if (context)
        context_ = std::move(context).value();
      else
        why = context.error();
    }
    if (!context_) fall_back(why);
    auto screen = Screen::create(*context_);
    if (!screen) throw CommandError(ExitCode::failed, screen.error());
    screen_ = std::move(screen).value();
    if (!plain_) {
      glfwSwapInterval(1);
      gl_.emplace(std::move(Gl::load(*context_)).value());
    }
  }

  GLFWwindow* window() const { return window_.get(); }
  Screen& screen() { return *screen_; }
  /// Why there is no OpenGL in the window; empty: there is.
  const std::string& fallback() const { return fallback_; }

  void present() {
    if (plain_) return plain_->show(screen_->read());
    const Size size = screen_->picture().size();
    gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, screen_->picture().resolved());
    gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    gl_->BlitFramebuffer(0, 0, size.width, size.height, 0, 0, size.width, size.height, GL_COLOR_BUFFER_BIT,
                         GL_NEAREST);
    glfwSwapBuffers(window_.get());
  }

 private:
  /// Off-screen, and the pictures in a plain window. The off-screen context may be on this thread: GLFW calls
  /// no OpenGL then.
  void fall_back(const std::string& why) {
    window_ = make_glfw_window(false);
    if (!window_)
      throw CommandError(ExitCode::failed,
                         fmt::format("no window can be opened here ({}); pages can be written to files: "
                                     "polhode export LESSON -o DIR",
                                     last_glfw_error()));
    auto plain = PlainWindow::create(window_.get());
    auto context = plain ? open_context(ContextKind::any)
                         : Result<std::unique_ptr<GlContext>>(failure("no plain window: " + plain.error()));
    if (!context)
      throw CommandError(
          ExitCode::failed,
          fmt::format("the window has no OpenGL 3.3 ({}), and there is nothing else to draw with: {} Pages "
                      "can be written to files where there is: polhode export LESSON -o DIR",
                      why, context.error()));
    plain_ = std::move(plain).value();
    context_ = std::move(context).value();
    fallback_ = why;
  }

  WindowPointer window_;
  std::unique_ptr<PlainWindow> plain_;
  std::unique_ptr<GlContext> context_;
  std::unique_ptr<Screen> screen_;
  std::optional<Gl> gl_;
  std::string fallback_;
};

/// What the callbacks reach by the window's user pointer.
struct Input {
  std::deque<InputEvent> waiting{};
  int settling = kSettlingFrames;  ///< frames still to be drawn
};

Input& input_of(GLFWwindow* window) {
  Input& input = *static_cast<Input*>(glfwGetWindowUserPointer(window));
  input.settling = kSettlingFrames;
  return input;
}

void listen(GLFWwindow* window) {
  using Kind = InputEvent::Kind;
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int modifiers) {
    input_of(w).waiting.push_back({Kind::key, key, scancode, action, modifiers});
  });
  glfwSetCharCallback(window, [](GLFWwindow* w, unsigned code_point) {
    input_of(w).waiting.push_back({Kind::character, static_cast<int>(code_point)});
  });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int modifiers) {
    input_of(w).waiting.push_back({Kind::button, button, 0, action, modifiers});
  });
  glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
    input_of(w).waiting.push_back({.kind = Kind::wheel, .x = x, .y = y});
  });
  glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
    input_of(w).waiting.push_back({.kind = Kind::pointer, .x = x, .y = y});
  });
  glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
    if (!entered) input_of(w).waiting.push_back({.kind = Kind::pointer, .x = -FLT_MAX, .y = -FLT_MAX});
  });
  glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int focused) {
    input_of(w);
    ImGui_ImplGlfw_WindowFocusCallback(w, focused);
  });
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { input_of(w); });
  glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { input_of(w); });
}

/// Keyboard and mouse as the controls are told of them: as much as they can see in one frame.
class ControlInput {
 public:
  ControlInput(GLFWwindow* window, Companion& companion, Screen& screen)
      : window_(window), companion_(companion), screen_(screen) {}

  /// After the back end has told what it knows, which is where they are by now.
  void feed(std::deque<InputEvent>& waiting) {
    InputPortion portion;
    while (!waiting.empty() && portion.takes(waiting.front())) {
      const InputEvent event = waiting.front();
      waiting.pop_front();
      if (is_command(event)) continue;
      portion.add(event);
      give(event);
    }
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = pointer_;
    std::copy(buttons_.begin(), buttons_.end(), io.MouseDown);
  }

 private:
  bool is_command(const InputEvent& event) {
    std::string name;
    if (event.kind == InputEvent::Kind::character) name = character_name(static_cast<unsigned>(event.code));
    if (event.kind == InputEvent::Kind::key && event.action != GLFW_RELEASE)
      name = key_name(event.code, event.modifiers);
    return !name.empty() && screen_.press(companion_, name);
  }

  void give(const InputEvent& event) {
    switch (event.kind) {
      case InputEvent::Kind::pointer:
        move_to(static_cast<float>(event.x), static_cast<float>(event.y));
        break;
      case InputEvent::Kind::wheel:
        ImGui_ImplGlfw_ScrollCallback(window_, event.x, event.y);
        break;
      case InputEvent::Kind::button:
        if (event.code >= 0 && event.code < static_cast<int>(buttons_.size()))
          buttons_[static_cast<std::size_t>(event.code)] = event.action == GLFW_PRESS;
        break;
      case InputEvent::Kind::key:
        ImGui_ImplGlfw_KeyCallback(window_, event.code, event.scancode, event.action, event.modifiers);
        break;
      case InputEvent::Kind::character:
        ImGui_ImplGlfw_CharCallback(window_, static_cast<unsigned>(event.code));
        break;
    }
  }

  /// A hand that holds something does not let go of it where the window ends.
  void move_to(float x, float y) {
    const bool is_out = x == -FLT_MAX;
    const bool holds = std::find(buttons_.begin(), buttons_.end(), true) != buttons_.end();
    if (!is_out || !holds) pointer_ = {x, y};
  }

  GLFWwindow* window_;
  Companion& companion_;
  Screen& screen_;
  ImVec2 pointer_{-FLT_MAX, -FLT_MAX};
  std::array<bool, 5> buttons_{};  // as many as Dear ImGui knows
};

std::string title_of(const Companion& companion, const std::string& stage) {
  return fmt::format("{} — stage {} of {}, step {} of {} — polhode", stage, companion.place().stage + 1,
                     companion.lesson().stages.size(), companion.place().step + 1,
                     companion.stage().steps.size());
}

/// Fills the screen of the primary monitor, and gives the window back its place.
class FullScreen {
 public:
  explicit FullScreen(GLFWwindow* window) : window_(window) {}
  bool is_on() const { return glfwGetWindowMonitor(window_) != nullptr; }
  void set(bool on) {
    if (on == is_on()) return;
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    if (on && monitor) {
      glfwGetWindowPos(window_, &x_, &y_);
      glfwGetWindowSize(window_, &width_, &height_);
      const GLFWvidmode* mode = glfwGetVideoMode(monitor);
      glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    } else if (!on) {
      glfwSetWindowMonitor(window_, nullptr, x_, y_, width_, height_, GLFW_DONT_CARE);
    }
  }

 private:
  GLFWwindow* window_;
  int x_ = 0, y_ = 0, width_ = kWidth, height_ = kHeight;
};

double process_cpu_s() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// For the benchmark (tests/bench/window_figures): a line for each frame to the file that POLHODE_FRAME_LOG
/// names: time, CPU time since the frame before in ms, whether something moves, whether the page has all its
/// pixels.
class FrameLog {
 public:
  FrameLog() {
    if (const char* name = std::getenv("POLHODE_FRAME_LOG"); name && *name) file_.open(name);
  }
  void note(bool moving, bool full) {
    if (!file_.is_open()) return;
    const double cpu_s = process_cpu_s();
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    file_ << fmt::format("{:.6f} {:.3f} {} {}\n",
                         static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec),
                         1e3 * (cpu_s - cpu_before_s_), moving ? 1 : 0, full ? 1 : 0)
          << std::flush;
    cpu_before_s_ = cpu_s;
  }

 private:
  std::ofstream file_;
  double cpu_before_s_ = 0;
};

/// The loop of events and frames.
class Loop {
 public:
  Loop(Companion& companion, const WindowOptions& options)
      : companion_(companion),
        options_(options),
        control_input_(display_.window(), companion, display_.screen()),
        full_screen_(display_.window()) {
    glfwSetWindowUserPointer(display_.window(), &input_);
    listen(display_.window());
    ImGui_ImplGlfw_InitForOther(display_.window(), false);
    if (!display_.fallback().empty())
      screen().tell("This display has no OpenGL 3.3 (" + display_.fallback() + "): drawn off-screen.");
    if (!options.news.empty()) screen().tell(options.news);
  }
  ~Loop() { ImGui_ImplGlfw_Shutdown(); }
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  void run() {
    const InterruptWatch watch;
    while (!glfwWindowShouldClose(display_.window()) && !screen().wishes().quit && !watch.interrupted()) {
      wait();
      look_for_changes();
      if (!must_draw()) continue;
      draw();
      if (options_.keep) options_.keep(companion_);
    }
  }

 private:
  Screen& screen() { return display_.screen(); }

  bool must_draw() { return input_.settling > 0 || glfwGetTime() >= wake_s_; }

  void wait() {
    const double now_s = glfwGetTime();
    const double until_s =
        input_.settling > 0 ? drawn_s_ + kLeastFrame_s : std::max(wake_s_, drawn_s_ + kLeastFrame_s);
    if (until_s <= now_s)
      glfwPollEvents();
    else
      glfwWaitEventsTimeout(
          std::min(until_s - now_s, options_.look_for_changes ? kWatchEvery_s : kLongestWait_s));
  }

  void look_for_changes() {
    if (!options_.look_for_changes || glfwGetTime() - looked_s_ < kWatchEvery_s) return;
    looked_s_ = glfwGetTime();
    std::string errors = lesson_errors_;
    const LoadedLesson* before = &companion_.loaded();
    options_.look_for_changes(companion_, errors);
    if (errors == lesson_errors_ && before == &companion_.loaded()) return;
    lesson_errors_ = errors;
    screen().set_lesson_errors(errors);
    input_.settling = kSettlingFrames;
  }

  void draw() {
    const double now_s = glfwGetTime();
    ImGui_ImplGlfw_NewFrame();
    control_input_.feed(input_.waiting);
    const ScreenFrame frame = measured_frame(now_s);
    drawn_s_ = now_s;
    if (Status drawn = screen().draw(companion_, frame); !drawn)
      throw CommandError(ExitCode::failed, drawn.error());
    display_.present();
    frame_log_.note(companion_.is_moving(), screen().is_full());
    input_.settling = input_.waiting.empty() ? std::max(0, input_.settling - 1) : kSettlingFrames;
    wake_s_ = now_s + screen().seconds_to_wake(companion_);
    follow_wishes();
    update_title();
  }

  /// The pointer comes in the window's units, which need not be pixels.
  ScreenFrame measured_frame(double now_s) {
    ScreenFrame frame;
    glfwGetFramebufferSize(display_.window(), &frame.size.width, &frame.size.height);
    frame.size = {std::max(1, frame.size.width), std::max(1, frame.size.height)};
    int width = 0, height = 0;
    glfwGetWindowSize(display_.window(), &width, &height);
    float scale_x = 1, scale_y = 1;
    glfwGetWindowContentScale(display_.window(), &scale_x, &scale_y);
    ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsMousePosValid(&io.MousePos) && width > 0 && height > 0) {
      io.MousePos.x *= static_cast<float>(frame.size.width) / static_cast<float>(width);
      io.MousePos.y *= static_cast<float>(frame.size.height) / static_cast<float>(height);
    }
    io.DisplayFramebufferScale = {1, 1};
    frame.scale = std::clamp(static_cast<double>(std::max(scale_x, scale_y)), 1.0, 4.0);
    frame.seconds = drawn_s_ > 0 ? now_s - drawn_s_ : 0;
    return frame;
  }

  void follow_wishes() {
    if (screen().wishes().full_screen) {
      full_screen_.set(!full_screen_.is_on());
      screen().wishes().full_screen = false;
    }
    if (companion_.presenting != presenting_) {
      presenting_ = companion_.presenting;
      full_screen_.set(presenting_);
    }
  }

  void update_title() {
    const std::string title = title_of(companion_, screen().stage_title());
    if (title == title_) return;
    title_ = title;
    glfwSetWindowTitle(display_.window(), title.c_str());
  }

  Companion& companion_;
  const WindowOptions& options_;
  Glfw glfw_;
  Display display_;
  Input input_;
  ControlInput control_input_;
  FullScreen full_screen_;
  FrameLog frame_log_;
  std::string title_, lesson_errors_;
  bool presenting_ = false;
  double drawn_s_ = 0, wake_s_ = 0, looked_s_ = 0;
};

}  // namespace

ExitCode run_window(Companion& companion, const WindowOptions& options) {
  Loop(companion, options).run();
  if (options.keep) options.keep(companion);
  return ExitCode::done;
}

}  // namespace polhode
