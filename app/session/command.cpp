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

void toggle(LessonSession& session, Panel panel) {
  session.panel = session.panel == panel ? Panel::none : panel;
}

void leave(LessonSession& session) {
  if (session.are_notes_shown())
    session.show_notes(false);
  else if (session.is_presenting())
    session.set_presenting(false);
  else if (session.panel != Panel::none)
    session.panel = Panel::none;
  else if (!session.lit().empty())
    session.light({});
}

/// From space, from the body, both.
void show_next_view(LessonSession& session) {
  if (!session.has_scene()) return;
  const std::vector<View> space{View::space}, body{View::body}, both{View::space, View::body};
  const std::vector<View>& shown = session.model()->scene.views;
  SceneEdits edits = session.edits();
  edits.views = shown == space ? body : shown == body ? both : space;
  static_cast<void>(session.set_edits(edits));
}

/// By a drag over this part of the picture's height.
void turn_camera(LessonSession& session, double right, double down) {
  if (session.has_scene()) session.set_camera(orbited(session.model()->scene.camera, right, down, 1.0));
}

void zoom_camera(LessonSession& session, double notches) {
  if (session.has_scene()) session.set_camera(zoomed(session.model()->scene.camera, notches));
}

void toggle_ghost(LessonSession& session) {
  if (!session.has_scene()) return;
  SceneEdits edits = session.edits();
  edits.motion = session.model()->scene.motion;
  edits.motion->ghost = !edits.motion->ghost;
  static_cast<void>(session.set_edits(edits));
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

bool do_command(LessonSession& session, Command command) {
  switch (command) {
    case C::next_step:
      session.next_step();
      return true;
    case C::previous_step:
      session.previous_step();
      return true;
    case C::next_stage:
      session.next_stage();
      return true;
    case C::previous_stage:
      session.previous_stage();
      return true;
    case C::first_stage:
      session.go_to({});
      return true;
    case C::last_stage:
      session.go_to({session.lesson().stages.size() - 1, 0});
      return true;
    case C::play_pause:
      session.set_playing(!session.is_playing());
      return true;
    case C::frame_forward:
      session.step_frames(1);
      return true;
    case C::frame_back:
      session.step_frames(-1);
      return true;
    case C::reset_time:
      session.reset_time();
      return true;
    case C::faster:
      session.set_speed(2 * session.speed());
      return true;
    case C::slower:
      session.set_speed(session.speed() / 2);
      return true;
    case C::leave:
      leave(session);
      return true;
    case C::outline:
      toggle(session, Panel::outline);
      return true;
    case C::body:
      toggle(session, Panel::body);
      return true;
    case C::method:
      toggle(session, Panel::method);
      return true;
    case C::show:
      toggle(session, Panel::show);
      return true;
    case C::question:
      toggle(session, Panel::question);
      return true;
    case C::save:
      toggle(session, Panel::save);
      return true;
    case C::settings:
      toggle(session, Panel::settings);
      return true;
    case C::help:
      toggle(session, Panel::help);
      return true;
    case C::reset_scene:
      session.reset_edits();
      return true;
    case C::follow:
      session.set_following(!session.is_following());
      return true;
    case C::turn_left:
      turn_camera(session, -kTurn, 0);
      return true;
    case C::turn_right:
      turn_camera(session, kTurn, 0);
      return true;
    case C::turn_up:
      turn_camera(session, 0, -kTurn);
      return true;
    case C::turn_down:
      turn_camera(session, 0, kTurn);
      return true;
    case C::nearer:
      zoom_camera(session, 1);
      return true;
    case C::farther:
      zoom_camera(session, -1);
      return true;
    case C::next_view:
      show_next_view(session);
      return true;
    case C::ghost:
      toggle_ghost(session);
      return true;
    case C::larger_text:
      session.change_text_scale(1);
      return true;
    case C::smaller_text:
      session.change_text_scale(-1);
      return true;
    case C::theme:
      toggle_theme(session.preferences);
      return true;
    case C::present:
      session.set_presenting(!session.is_presenting());
      return true;
    case C::notes:
      session.show_notes(!session.are_notes_shown());
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
