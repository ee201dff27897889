// SPDX-License-Identifier: MIT
#include "app/session/command.h"

#include "app/session/figure_interaction.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace polhode {

namespace {

using C = Command;

// What walks goes as in the deck (assets/deck/deck.js): remote clickers send Page Down and Page Up.
constexpr std::array kCommands = {
    CommandFacts{C::next_step, "Right, PageDown", "Walk", "next step", true},
    CommandFacts{C::previous_step, "Left, PageUp", "Walk", "previous step", true},
    CommandFacts{C::next_stage, "Down, Ctrl+PageDown, Shift+PageDown", "Walk", "next stage", true},
    CommandFacts{C::previous_stage, "Up, Ctrl+PageUp, Shift+PageUp", "Walk",
                 "beginning of this stage, or the stage before", true},
    CommandFacts{C::first_stage, "Home", "Walk", "first stage"},
    CommandFacts{C::last_stage, "End", "Walk", "last stage"},

    CommandFacts{C::play_pause, "Space", "Time", "play, pause"},
    CommandFacts{C::frame_forward, "Shift+Right", "Time", "one frame forward", true},
    CommandFacts{C::frame_back, "Shift+Left", "Time", "one frame back", true},
    CommandFacts{C::faster, "Shift+Up", "Time", "twice as fast", true},
    CommandFacts{C::slower, "Shift+Down", "Time", "half as fast", true},
    CommandFacts{C::reset_time, "0", "Time", "back to the time of the lesson"},

    CommandFacts{C::next_view, "V", "Body", "from space, from the body, both"},
    CommandFacts{C::turn_left, "Ctrl+Left", "Body", "turn the camera to the left", true},
    CommandFacts{C::turn_right, "Ctrl+Right", "Body", "to the right", true},
    CommandFacts{C::turn_up, "Ctrl+Up", "Body", "upward", true},
    CommandFacts{C::turn_down, "Ctrl+Down", "Body", "downward", true},
    CommandFacts{C::nearer, "Z", "Body", "nearer", true},
    CommandFacts{C::farther, "X", "Body", "farther", true},
    CommandFacts{C::follow, "C", "Body", "the camera turns with the body"},
    CommandFacts{C::ghost, "G", "Body", "the exact body beside the computed one"},
    CommandFacts{C::reset_scene, "R", "Body", "the scene of the lesson again"},

    CommandFacts{C::next_symbol, "Tab", "Understand", "next symbol", true},
    CommandFacts{C::previous_symbol, "Shift+Tab", "Understand", "previous symbol", true},
    CommandFacts{C::explain, "Enter", "Understand", "explain the symbol"},

    CommandFacts{C::outline, "O", "Panels", "stages of the lesson"},
    CommandFacts{C::body, "B", "Panels", "body and its spin"},
    CommandFacts{C::method, "M", "Panels", "method, step and errors"},
    CommandFacts{C::show, "S", "Panels", "what is shown"},
    CommandFacts{C::question, "Q", "Panels", "question"},
    CommandFacts{C::save, "E", "Panels", "save and copy"},
    CommandFacts{C::settings, "F2", "Panels", "settings"},
    CommandFacts{C::help, "?, F1", "Panels", "keys"},
    CommandFacts{C::leave, "Escape", "Panels", "close, leave"},
    CommandFacts{C::switch_focus, "F6", "Panels", "the keys go to the panel, or to the page"},

    CommandFacts{C::larger_text, "+, =", "Window", "larger text", true},
    CommandFacts{C::smaller_text, "-", "Window", "smaller text", true},
    CommandFacts{C::theme, "T", "Window", "paper, dark"},
    CommandFacts{C::full_screen, "F, F11", "Window", "full screen"},
    CommandFacts{C::present, "P, F5", "Window", "present: the page alone"},
    CommandFacts{
        C::notes, "N", "Window",
        "while presenting, and until you go on: what comes next and what to say, on the same screen"},
    CommandFacts{C::save_page, "Ctrl+S", "Window", "save this page"},
    CommandFacts{C::quit, "Ctrl+Q", "Window", "quit"},
};

constexpr double kTurn = 1.0 / 24;  ///< 7.5 degrees a key

bool has_key(std::string_view keys, std::string_view key) {
  constexpr std::string_view kBetween = ", ";
  while (true) {
    const std::size_t end = keys.find(kBetween);
    if (keys.substr(0, end) == key) return true;
    if (end == keys.npos) return false;
    keys.remove_prefix(end + kBetween.size());
  }
}

void toggle(Companion& companion, Panel panel) {
  companion.panel = companion.panel == panel ? Panel::none : panel;
}

void leave(Companion& companion) {
  if (companion.are_notes_shown())
    companion.show_notes(false);
  else if (companion.is_presenting())
    companion.set_presenting(false);
  else if (companion.panel != Panel::none)
    companion.panel = Panel::none;
  else if (!companion.lit().empty())
    companion.light({});
}

/// From space, from the body, both.
void show_next_view(Companion& companion) {
  if (!companion.has_scene()) return;
  const std::vector<View> space{View::space}, body{View::body}, both{View::space, View::body};
  const std::vector<View>& shown = companion.model()->scene.views;
  SceneEdits edits = companion.edits();
  edits.views = shown == space ? body : shown == body ? both : space;
  static_cast<void>(companion.set_edits(edits));
}

/// By a drag over this part of the picture's height.
void turn_camera(Companion& companion, double right, double down) {
  if (companion.has_scene()) companion.set_camera(orbited(companion.model()->scene.camera, right, down, 1.0));
}

void zoom_camera(Companion& companion, double notches) {
  if (companion.has_scene()) companion.set_camera(zoomed(companion.model()->scene.camera, notches));
}

void toggle_ghost(Companion& companion) {
  if (!companion.has_scene()) return;
  SceneEdits edits = companion.edits();
  edits.motion = companion.model()->scene.motion;
  edits.motion->ghost = !edits.motion->ghost;
  static_cast<void>(companion.set_edits(edits));
}

void toggle_theme(Preferences& preferences) {
  preferences.theme = preferences.theme == Theme::paper ? Theme::dark : Theme::paper;
}

}  // namespace

std::span<const CommandFacts> all_commands() { return kCommands; }

std::optional<Command> command_of(std::string_view key) {
  if (key.empty()) return std::nullopt;
  for (const CommandFacts& facts : kCommands)
    if (has_key(facts.keys, key)) return facts.command;
  return std::nullopt;
}

bool repeats(Command command) {
  const auto facts = std::find_if(kCommands.begin(), kCommands.end(),
                                  [&](const CommandFacts& f) { return f.command == command; });
  return facts != kCommands.end() && facts->repeats;
}

bool do_command(Companion& companion, Command command) {
  switch (command) {
    case C::next_step:
      companion.next_step();
      return true;
    case C::previous_step:
      companion.previous_step();
      return true;
    case C::next_stage:
      companion.next_stage();
      return true;
    case C::previous_stage:
      companion.previous_stage();
      return true;
    case C::first_stage:
      companion.go_to({});
      return true;
    case C::last_stage:
      companion.go_to({companion.lesson().stages.size() - 1, 0});
      return true;
    case C::play_pause:
      companion.set_playing(!companion.is_playing());
      return true;
    case C::frame_forward:
      companion.step_frames(1);
      return true;
    case C::frame_back:
      companion.step_frames(-1);
      return true;
    case C::reset_time:
      companion.reset_time();
      return true;
    case C::faster:
      companion.set_speed(2 * companion.speed());
      return true;
    case C::slower:
      companion.set_speed(companion.speed() / 2);
      return true;
    case C::leave:
      leave(companion);
      return true;
    case C::outline:
      toggle(companion, Panel::outline);
      return true;
    case C::body:
      toggle(companion, Panel::body);
      return true;
    case C::method:
      toggle(companion, Panel::method);
      return true;
    case C::show:
      toggle(companion, Panel::show);
      return true;
    case C::question:
      toggle(companion, Panel::question);
      return true;
    case C::save:
      toggle(companion, Panel::save);
      return true;
    case C::settings:
      toggle(companion, Panel::settings);
      return true;
    case C::help:
      toggle(companion, Panel::help);
      return true;
    case C::reset_scene:
      companion.reset_edits();
      return true;
    case C::follow:
      companion.set_following(!companion.is_following());
      return true;
    case C::turn_left:
      turn_camera(companion, -kTurn, 0);
      return true;
    case C::turn_right:
      turn_camera(companion, kTurn, 0);
      return true;
    case C::turn_up:
      turn_camera(companion, 0, -kTurn);
      return true;
    case C::turn_down:
      turn_camera(companion, 0, kTurn);
      return true;
    case C::nearer:
      zoom_camera(companion, 1);
      return true;
    case C::farther:
      zoom_camera(companion, -1);
      return true;
    case C::next_view:
      show_next_view(companion);
      return true;
    case C::ghost:
      toggle_ghost(companion);
      return true;
    case C::larger_text:
      companion.change_text_scale(1);
      return true;
    case C::smaller_text:
      companion.change_text_scale(-1);
      return true;
    case C::theme:
      toggle_theme(companion.preferences);
      return true;
    case C::present:
      companion.set_presenting(!companion.is_presenting());
      return true;
    case C::notes:
      companion.show_notes(!companion.are_notes_shown());
      return true;
    case C::switch_focus:
    case C::next_symbol:
    case C::previous_symbol:
    case C::explain:
    case C::save_page:
    case C::full_screen:
    case C::quit:
      return false;
  }
  return false;
}

}  // namespace polhode
