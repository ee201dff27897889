// SPDX-License-Identifier: MIT
// The window of `polhode play`: GLFW's events go to the screen, its picture goes to the display.
#pragma once

#include "app/session/answers/progress.h"
#include "app/session/lesson_session.h"
#include "app/session/saved/window_place.h"
#include "base/result.h"
#include "render/typeset/fonts.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace polhode {

struct WindowOptions {
  /// A new reading of the lesson if its file has changed, or what is wrong with it; called a few times a
  /// second. Empty: the lesson is not watched.
  std::function<void(LessonSession&, std::string& errors)> look_for_changes{};
  /// Called after each frame: place, answers or preferences may have changed. It must not wait. The answer is
  /// to be told. What changed after the last frame is for the caller of run_window to keep.
  std::function<std::string(const LessonSession&)> keep{};
  std::string notice{};  ///< to be told at the beginning
  /// What lessons there are, asked for when they are listed.
  std::function<std::vector<LessonProgress>()> lessons{};
  /// Over the page stands the list of all lessons, until one is chosen.
  bool begins_with_lessons = false;
  /// Whether theme and motion are as the desktop wishes where the person has not chosen.
  bool follows_desktop = false;
  WindowPlace place{};  ///< of the window when it was closed last
  /// Begins to make slides of the stages that are chosen, in a file of this name (.html, .pdf), and does not
  /// wait. The answer is to be told.
  std::function<std::string(const LessonSession&, const std::filesystem::path& file)> make_slides{};
  /// Asked a few times a second what has become of that; empty: nothing new.
  std::function<std::string()> news{};
};

struct WindowEnd {
  enum class Kind { closed, interrupted, other_lesson };
  Kind kind = Kind::closed;
  std::string lesson{};  ///< id of the other one
  WindowPlace place{};   ///< of the window; empty: it filled the screen
};

/// Runs until the user closes the window, or until a signal, which counts as an interruption. Draws with the
/// display's OpenGL; if that is older than 3.3, it draws off-screen and shows the pictures in a plain window.
/// An error if there is no display, or nothing to draw with: it says what to do.
Result<WindowEnd> run_window(LessonSession& session, const Fonts& fonts, const WindowOptions& options);

}  // namespace polhode
