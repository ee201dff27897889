// SPDX-License-Identifier: MIT
// `polhode play` on a display, with a home of its own; played by keys and mouse and judged by what is seen.
#pragma once

#include "render/image/compare.h"
#include "tests/window/display.h"

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace polhode::window_test {

struct Point {
  int x = 0, y = 0;
};

/// What the title of the window tells: "No torque — stage 3 of 29, step 2 of 4 — polhode".
struct TitlePlace {
  std::string stage_title;
  int stage = 0, stages = 0, step = 0, steps = 0;  ///< from 1; 0: the title tells none
  bool operator==(const TitlePlace&) const = default;
};
TitlePlace place_in(const std::string& title);

/// State, working folder and home of one or several runs.
struct Home {
  ScratchFolder folder;
  std::filesystem::path state() const { return folder / "state" / "polhode"; }
};

class PlayedLesson {
 public:
  /// Returns when the window is there, has the keyboard, and the first picture of full quality is in it.
  PlayedLesson(const Display& display, const Home& home, const std::vector<std::string>& arguments,
               const Environment& environment = {});

  /// Keys as xdotool calls them, one after another: "Right", "shift+Tab", "ctrl+s", "plus".
  void press(const std::vector<std::string>& keys);
  void type(const std::string& text);
  void move_to(Point point);
  void click(Point point);
  /// Notches away from the hand are positive.
  void turn_wheel(Point point, int notches);
  /// Takes hold at the first point, passes the others, lets go at the last one.
  void drag(const std::vector<Point>& points);

  TitlePlace place() const { return place_in(display_.title_of(window_)); }
  /// Waits for it.
  bool comes_to(int stage, int step) const;
  bool comes_to_stage(int stage) const;

  Image picture() const { return display_.picture(); }
  /// The picture at rest: of full quality, and for a while nothing else was drawn.
  Image picture_at_rest() const;
  /// Waits until something else is seen than this. @return whether it is
  bool changes_from(const Image& before, std::chrono::milliseconds patience = kPatience) const;
  /// Pictures drawn so far.
  int frames() const;

  Child& process() { return process_; }
  unsigned window() const { return window_; }
  std::string said() const { return text_of(err_); }  ///< on stderr
  void close() const { display_.ask_to_close(window_); }

 private:
  const Display& display_;
  std::filesystem::path err_, frame_log_;
  Child process_;
  unsigned window_ = 0;
};

/// What `polhode play` is to be started with.
Start start_of_play(const Display& display, const Home& home, const std::vector<std::string>& arguments,
                    const Environment& environment = {});

/// Part of the pixels that differ by more than 3 levels in a rectangle.
double changed_part(const Image& a, const Image& b, Point from, Point to);

}  // namespace polhode::window_test
