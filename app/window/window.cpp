// SPDX-License-Identifier: MIT
#include "app/window/window.h"

#include "app/window/controls/control_input.h"
#include "app/window/display.h"
#include "app/window/frame_log.h"
#include "base/interrupt.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

namespace polhode {

namespace {

constexpr double kLeastFrame_s = 1.0 / 60, kClock_s = 1e-3;
/// So long at most nothing is looked at: signals, changes of the lesson.
constexpr double kLongestWait_s = 0.5, kWatchEvery_s = 0.25;

std::string title_of(const LessonSession& session, const std::string& stage) {
  return fmt::format("{} — stage {} of {}, step {} of {} — polhode", stage, session.place().stage + 1,
                     session.lesson().stages.size(), session.place().step + 1, session.stage().steps.size());
}

/// The loop of events and frames.
class Loop {
 public:
  Loop(LessonSession& session, const WindowOptions& options, Display& display)
      : session_(session),
        options_(options),
        display_(display),
        control_input_(display_.window(), session, display_.screen()),
        full_screen_(display_.window()) {
    listen(display_.window(), input_);
    ImGui_ImplGlfw_InitForOther(display_.window(), false);
    if (!display_.fallback().empty())
      screen().tell("This display has no OpenGL 3.3 (" + display_.fallback() + "): drawn off-screen.");
    screen().set_lessons(options.lessons);
    if (!options.notice.empty()) screen().tell(options.notice);
  }
  ~Loop() { ImGui_ImplGlfw_Shutdown(); }
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  Result<WindowEnd> run() {
    const InterruptWatch watch;
    try {
      while (!glfwWindowShouldClose(display_.window()) && !is_over() && !watch.interrupted()) {
        wait();
        look_for_changes();
        if (!must_draw()) continue;
        if (Status drawn = draw(); !drawn) return failure(drawn.error());
        keep();
      }
    } catch (const Interrupted&) {  // while a motion was computed
    }
    WindowEnd end;
    if (!full_screen_.is_on()) glfwGetWindowSize(display_.window(), &end.size.width, &end.size.height);
    end.lesson = screen().requests().open_lesson;
    if (!end.lesson.empty()) end.kind = WindowEnd::Kind::other_lesson;
    if (watch.interrupted()) end.kind = WindowEnd::Kind::interrupted;
    return end;
  }

 private:
  Screen& screen() { return display_.screen(); }
  bool is_over() { return screen().requests().quit || !screen().requests().open_lesson.empty(); }

  /// Not more often than kLeastFrame_s, however fast events come, and not what nobody sees.
  bool must_draw() {
    const double now_s = glfwGetTime();
    if (now_s < drawn_s_ + kLeastFrame_s - kClock_s) return false;
    if (glfwGetWindowAttrib(display_.window(), GLFW_ICONIFIED) == GLFW_TRUE) return false;
    return input_.settling > 0 || now_s >= wake_s_;
  }

  void keep() {
    if (!options_.keep) return;
    if (const std::string notice = options_.keep(session_); !notice.empty()) screen().tell(notice);
  }

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
    const LoadedLesson* before = &session_.loaded();
    options_.look_for_changes(session_, errors);
    if (errors == lesson_errors_ && before == &session_.loaded()) return;
    lesson_errors_ = errors;
    screen().set_lesson_errors(errors);
    input_.settling = kSettlingFrames;
  }

  Status draw() {
    const double now_s = glfwGetTime();
    ImGui_ImplGlfw_NewFrame();
    control_input_.feed(input_.waiting);
    const ScreenFrame frame = measured_frame(now_s);
    drawn_s_ = now_s;
    if (Status drawn = screen().draw(session_, frame); !drawn) return drawn;
    display_.present();
    frame_log_.note(session_.is_moving(), screen().is_full());
    input_.settling = input_.waiting.empty() ? std::max(0, input_.settling - 1) : kSettlingFrames;
    wake_s_ = now_s + screen().seconds_to_wake(session_);
    follow_requests();
    update_title();
    return success();
  }

  ScreenFrame measured_frame(double now_s) {
    ScreenFrame frame;
    glfwGetFramebufferSize(display_.window(), &frame.size.width, &frame.size.height);
    frame.size = {std::max(1, frame.size.width), std::max(1, frame.size.height)};
    float scale_x = 1, scale_y = 1;
    glfwGetWindowContentScale(display_.window(), &scale_x, &scale_y);
    ImGui::GetIO().DisplayFramebufferScale = {1, 1};
    frame.scale = std::clamp(static_cast<double>(std::max(scale_x, scale_y)), 1.0, 4.0);
    frame.seconds = drawn_s_ > 0 ? now_s - drawn_s_ : 0;
    return frame;
  }

  void follow_requests() {
    if (screen().requests().full_screen) {
      full_screen_.set(!full_screen_.is_on());
      screen().requests().full_screen = false;
    }
    if (std::exchange(screen().requests().leave_full_screen, false)) full_screen_.set(false);
    if (session_.is_presenting() != presenting_) {
      presenting_ = session_.is_presenting();
      if (presenting_) was_full_ = full_screen_.is_on();
      full_screen_.set(presenting_ || was_full_);
    }
  }

  void update_title() {
    const std::string title = title_of(session_, screen().stage_title());
    if (title == title_) return;
    title_ = title;
    glfwSetWindowTitle(display_.window(), title.c_str());
  }

  LessonSession& session_;
  const WindowOptions& options_;
  Display& display_;
  Input input_;
  ControlInput control_input_;
  FullScreen full_screen_;
  FrameLog frame_log_;
  std::string title_, lesson_errors_;
  bool presenting_ = false, was_full_ = false;  ///< before it presented
  double drawn_s_ = 0, wake_s_ = 0, looked_s_ = 0;
};

}  // namespace

Result<WindowEnd> run_window(LessonSession& session, const Fonts& fonts, const WindowOptions& options) {
  const auto glfw = Glfw::start();
  if (!glfw) return failure(glfw.error());
  const auto display = Display::open(fonts, options.size);
  if (!display) return failure(display.error());
  return Loop(session, options, **display).run();
}

}  // namespace polhode
