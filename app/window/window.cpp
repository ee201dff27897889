// SPDX-License-Identifier: MIT
#include "app/window/window.h"

#include "app/session/words/step_words.h"
#include "app/window/controls/control_input.h"
#include "app/window/desktop_watch.h"
#include "app/window/display.h"
#include "app/window/frame_log.h"
#include "app/window/speaker/speaker_window.h"
#include "app/window/voice.h"
#include "base/interrupt.h"
#include "base/words/window_words.h"

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

/// The loop of events and frames.
class Loop {
 public:
  Loop(LessonSession& session, const WindowOptions& options, Display& display)
      : session_(session),
        options_(options),
        display_(display),
        control_input_(display_.window(),
                       [this](std::string_view key, bool is_repeated) {
                         return screen().press(session_, key, is_repeated);
                       }),
        full_screen_(display_.window()) {
    ImGui::SetCurrentContext(screen().imgui());
    input_.imgui = screen().imgui();
    listen(display_.window(), input_);
    ImGui_ImplGlfw_InitForOther(display_.window(), false);
    if (!display_.fallback().empty())
      screen().tell("This display has no OpenGL 3.3 (" + display_.fallback() + "): drawn off-screen.");
    screen().set_lessons(options.lessons);
    if (!options.notice.empty()) screen().tell(options.notice);
    if (options.follows_desktop) desktop_.ask();
    if (options.begins_with_lessons) screen().press(session, facts_of(Command::lessons).keys);
  }
  ~Loop() {
    speaker_.reset();
    ImGui::SetCurrentContext(screen().imgui());
    ImGui_ImplGlfw_Shutdown();
  }
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  Result<WindowEnd> run() {
    const InterruptWatch watch;
    try {
      while (!glfwWindowShouldClose(display_.window()) && !is_over() && !watch.interrupted()) {
        wait();
        look_for_changes();
        listen_for_news();
        follow_desktop();
        if (must_draw()) {
          if (Status drawn = draw(); !drawn) return failure(drawn.error());
          keep();
        }
        if (Status drawn = draw_for_speaker(); !drawn) return failure(drawn.error());
      }
    } catch (const Interrupted&) {  // while a motion was computed
    }
    WindowEnd end;
    if (!full_screen_.is_on()) end.place = place_of(display_.window());
    if (speaker_ && speaker_->audience_before()) end.place = *speaker_->audience_before();
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
    double until_s =
        input_.settling > 0 ? drawn_s_ + kLeastFrame_s : std::max(wake_s_, drawn_s_ + kLeastFrame_s);
    if (speaker_) until_s = std::min(until_s, speaker_->wakes_at_s() + kLeastFrame_s);
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

  void tell(const std::string& text) {
    if (text.empty()) return;
    screen().tell(text);
    input_.settling = kSettlingFrames;
  }

  /// Of what goes on beside the window: slides that are made, a voice that cannot speak.
  void listen_for_news() {
    if (options_.news) tell(options_.news());
    tell(voice_.trouble());
  }

  /// Who comes back to the window may have changed the desktop meanwhile.
  void follow_desktop() {
    if (!options_.follows_desktop) return;
    const bool has_focus = glfwGetWindowAttrib(display_.window(), GLFW_FOCUSED) == GLFW_TRUE;
    if (has_focus && !std::exchange(had_focus_, has_focus)) desktop_.ask();
    had_focus_ = has_focus;
    const auto& wishes = desktop_.wishes();
    if (wishes && follow(*wishes, session_.preferences)) input_.settling = kSettlingFrames;
  }

  /// Another step has other words.
  void read_aloud() {
    if (read_ && *read_ != session_.place()) voice_.be_quiet();
    if (!voice_.is_speaking()) read_.reset();
    const std::string words = std::exchange(screen().requests().read_aloud, "");
    if (words.empty()) return;
    if (read_) return voice_.be_quiet();
    const Status begun = voice_.say(words, std::string(tag_of(session_.lesson().about.language)));
    tell(begun ? std::string(words::kIsReadAloud.in(session_.lesson().about.language)) : begun.error());
    if (begun) read_ = session_.place();
  }

  Status draw() {
    const double now_s = glfwGetTime();
    ImGui::SetCurrentContext(screen().imgui());
    ImGui_ImplGlfw_NewFrame();
    control_input_.feed(input_.waiting);
    ScreenFrame frame = frame_of_window(display_.window());
    frame.seconds = drawn_s_ > 0 ? now_s - drawn_s_ : 0;
    drawn_s_ = now_s;
    if (Status drawn = screen().draw(session_, frame); !drawn) return drawn;
    display_.present();
    frame_log_.note(session_.is_moving(), screen().is_full());
    input_.settling = input_.waiting.empty() ? std::max(0, input_.settling - 1) : kSettlingFrames;
    wake_s_ = now_s + screen().seconds_to_wake(session_);
    if (speaker_) speaker_->follow_audience();
    follow_requests();
    update_title();
    return success();
  }

  /// The speaker's window comes and goes as the session wants it, and is drawn where it has something new.
  Status draw_for_speaker() {
    if (speaker_ && speaker_->is_closed()) session_.set_speaker(false);
    if (speaker_ && !session_.has_speaker()) {
      // The half that it had beside the speaker's is not what it goes back to.
      if (const auto before = speaker_->audience_before(); before && full_screen_.is_on())
        full_screen_.go_back_to(*before);
      speaker_.reset();
      input_.settling = kSettlingFrames;
    }
    if (!speaker_ && session_.has_speaker()) open_for_speaker();
    const double now_s = glfwGetTime();
    if (!speaker_ || now_s < speaker_->wakes_at_s() + kLeastFrame_s - kClock_s) return success();
    const Result<bool> used = speaker_->draw(now_s);
    if (!used) return failure(used.error());
    if (*used) input_.settling = kSettlingFrames;
    return success();
  }

  /// Where there can be none, the page stays alone and says so.
  void open_for_speaker() {
    if (!presenting_) was_full_ = full_screen_.is_on();
    full_screen_.set(false);  // so that it can be moved
    auto opened = SpeakerWindow::open(display_, session_);
    if (opened) {
      speaker_ = std::move(opened).value();
    } else {
      session_.set_speaker(false);
      screen().tell("There is no window for the speaker: " + opened.error());
    }
    input_.settling = kSettlingFrames;
  }

  void follow_requests() {
    if (screen().requests().full_screen) {
      full_screen_.set(!full_screen_.is_on());
      screen().requests().full_screen = false;
    }
    if (std::exchange(screen().requests().leave_full_screen, false)) full_screen_.set(false);
    read_aloud();
    if (const auto file = std::exchange(screen().requests().slides_file, {}); !file.empty())
      tell(options_.make_slides ? options_.make_slides(session_, file) : "");
    if (session_.has_speaker() && !speaker_) return;  // its window decides where this one goes
    const bool is_new = session_.is_presenting() != presenting_;
    if (!is_new && (speaker_ != nullptr) == has_speaker_) return;
    presenting_ = session_.is_presenting();
    has_speaker_ = speaker_ != nullptr;
    if (is_new && presenting_ && !has_speaker_) was_full_ = full_screen_.is_on();
    // On the only screen there is, both have to be seen.
    const bool fills = presenting_ && (!session_.has_speaker() || monitor_count() > 1);
    full_screen_.set(fills || (was_full_ && !session_.has_speaker()));
  }

  /// A frozen page keeps its own.
  void update_title() {
    if (session_.is_frozen()) return;
    const std::string title = window_title(session_, screen().stage_title());
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
  std::unique_ptr<SpeakerWindow> speaker_;
  Voice voice_;
  DesktopWatch desktop_;
  bool had_focus_ = true;          ///< when it was looked at last
  std::optional<StepPlace> read_;  ///< what is read aloud
  std::string title_, lesson_errors_;
  bool presenting_ = false, was_full_ = false;  ///< before it presented
  bool has_speaker_ = false;                    ///< when it was looked at last
  double drawn_s_ = 0, wake_s_ = 0, looked_s_ = 0;
};

}  // namespace

Result<WindowEnd> run_window(LessonSession& session, const Fonts& fonts, const WindowOptions& options) {
  const auto glfw = Glfw::start();
  if (!glfw) return failure(glfw.error());
  const auto display = Display::open(fonts, options.place);
  if (!display) return failure(display.error());
  return Loop(session, options, **display).run();
}

}  // namespace polhode
