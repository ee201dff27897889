// SPDX-License-Identifier: MIT
// What keys do: the one table that the window obeys and its help shows.
#pragma once

#include "app/session/lesson_session.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace polhode {

enum class Command {
  next_step,
  previous_step,
  next_stage,
  previous_stage,
  first_stage,
  last_stage,
  find,
  play_pause,
  frame_forward,
  frame_back,
  reset_time,
  start_of_time,
  next_flip,
  previous_flip,
  faster,
  slower,
  next_symbol,
  previous_symbol,
  explain,
  replay,
  leave,
  switch_focus,
  outline,
  body,
  method,
  show,
  question,
  save,
  settings,
  lessons,
  help,
  reset_scene,
  undo,
  redo,
  follow,
  enlarge,
  next_view,
  turn_left,
  turn_right,
  turn_up,
  turn_down,
  nearer,
  farther,
  ghost,
  larger_number,
  smaller_number,
  larger_second_number,
  smaller_second_number,
  scroll_down,
  scroll_up,
  save_page,
  copy_step,
  larger_text,
  smaller_text,
  normal_text,
  theme,
  full_screen,
  present,
  notes,
  black,
  freeze,
  point,
  read_aloud,
  quit,
};

struct CommandFacts {
  Command command;
  std::string_view keys;   ///< "Right", "Shift+Tab", "Ctrl+S"; several: "Right, L" — as help shows them
  std::string_view group;  ///< "Walk", "Time", "Body", "Understand", "Panels", "Window"
  std::string_view does;   ///< "next step"
  bool repeats = false;    ///< while the key is held
  /// What is done to the session; null: only a window can do it (app/window/screen/screen.cpp).
  void (*act)(LessonSession&) = nullptr;
};
/// Group by group.
std::span<const CommandFacts> all_commands();

/// `key` is a name such as "Right", "PageDown", "Space", "Tab", "A", "+", "F1", with "Shift+" and "Ctrl+"
/// before it in this order.
std::optional<Command> command_of(std::string_view key);
/// A key that types a letter, a digit or a sign: those are no commands for who wants none
/// (Preferences::letter_keys).
bool is_character(std::string_view key);

const CommandFacts& facts_of(Command command);

/// Changes nothing where it is idle (why_idle). False for what only a window can do, with nothing changed.
bool do_command(LessonSession& session, Command command);

/// Why the command has nothing to do here, in a sentence to be told: "This step has no figure."; empty: it
/// has, or only a window knows.
std::string why_idle(const LessonSession& session, Command command);

}  // namespace polhode
