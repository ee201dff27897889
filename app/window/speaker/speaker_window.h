// SPDX-License-Identifier: MIT
// The speaker's window on the display: what is done in it goes to the audience's screen.
#pragma once

#include "app/window/controls/control_input.h"
#include "app/window/display.h"
#include "app/window/speaker/screen_of_speaker.h"

#include <memory>

namespace polhode {

class SpeakerWindow {
 public:
  /// Beside the audience's window, which must outlive it, as must the session. The error says why there can
  /// be none.
  static Result<std::unique_ptr<SpeakerWindow>> open(Display& audience, LessonSession& session);
  ~SpeakerWindow();
  SpeakerWindow(const SpeakerWindow&) = delete;
  SpeakerWindow& operator=(const SpeakerWindow&) = delete;

  /// By the cross in its frame.
  bool is_closed() const;
  /// Where the audience's window was before it gave way to this one; nothing: it did not.
  const std::optional<WindowPlace>& audience_before() const { return display_->first_before(); }
  /// When it has something new to show: by input, by the clock, or since the audience saw another picture.
  double wakes_at_s() const;
  void follow_audience() { is_behind_ = true; }
  /// At a time of glfwGetTime(). True: something was done in it, which the audience may see.
  Result<bool> draw(double now_s);

 private:
  SpeakerWindow(Display& audience, LessonSession& session, std::unique_ptr<SecondDisplay> display,
                std::unique_ptr<ScreenOfSpeaker> screen);

  LessonSession& session_;
  std::unique_ptr<SecondDisplay> display_;
  std::unique_ptr<ScreenOfSpeaker> screen_;
  Input input_;
  ControlInput control_input_;
  bool is_behind_ = true;
  double drawn_s_ = 0;
};

/// How large a window's picture is, and at what scale its controls are.
ScreenFrame frame_of_window(GLFWwindow* window);

}  // namespace polhode
