// SPDX-License-Identifier: MIT
// An X display of a test's own: Xvfb, its hand (xdotool) and its eye. No window manager runs on it.
#pragma once

#include "render/image/image.h"
#include "tests/app/run_program.h"
#include "tests/window/child.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace polhode::window_test {

/// A rectangle of the display, px.
struct Box {
  int x = 0, y = 0, width = 0, height = 0;
  bool operator==(const Box&) const = default;
};

class Display {
 public:
  /// Why there can be none here ("Xvfb is not installed"); empty: there can.
  static std::string why_not();

  explicit Display(Size size = {1280, 800}, const std::vector<std::string>& more_arguments = {});
  ~Display();
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;

  const std::string& name() const { return name_; }  ///< ":1"
  Size size() const { return size_; }

  /// Commands of xdotool, one after another: {"mousemove", "10", "20", "click", "1"}.
  void act(const std::vector<std::string>& commands) const;

  /// What is seen.
  Image picture() const;
  /// As it was asked for last.
  const Image& last_picture() const { return last_picture_; }
  /// Those of this process that have a title, the lowest first.
  std::vector<unsigned> windows_of(pid_t process) const;
  /// Of the first window of this process that has a title.
  std::optional<unsigned> window_of(pid_t process) const;
  /// Where it is on the display; without whoever manages windows.
  Box box_of(unsigned window) const;
  std::string title_of(unsigned window) const;
  /// As the cross in a window's frame does: WM_DELETE_WINDOW.
  void ask_to_close(unsigned window) const;

 private:
  struct Connection;

  Size size_;
  ScratchFolder scratch_;
  std::string name_;
  std::unique_ptr<Child> server_;
  std::unique_ptr<Connection> connection_;
  mutable Image last_picture_;  // when a test has failed, the window is gone
};

}  // namespace polhode::window_test
