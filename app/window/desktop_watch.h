// SPDX-License-Identifier: MIT
// Asks the desktop what it wishes (app/window/desktop_wishes.h), by a program beside the window.
#pragma once

#include "app/export/background_program.h"
#include "app/window/desktop_wishes.h"

#include <optional>

namespace polhode {

class DesktopWatch {
 public:
  /// Where there is no session bus, or no program that asks it, nothing is wished.
  void ask();
  /// As of the last answer; absent: the first is awaited. Does not wait.
  const std::optional<DesktopWishes>& wishes();

 private:
  std::optional<BackgroundProgram> question_;
  std::optional<DesktopWishes> wishes_;
};

}  // namespace polhode
