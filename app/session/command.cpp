// SPDX-License-Identifier: MIT
#include "app/session/command.h"

#include "app/session/camera_moves.h"
#include "base/words/window_words.h"
#include "render/scene/model/scene_needs.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace polhode {

namespace {

using C = Command;

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
  if (session.is_black())
    session.set_black(false);
  else if (session.panel != Panel::none)
    session.panel = Panel::none;
  else if (session.is_enlarged())
    session.set_enlarged(false);
  else if (session.is_presenting())
    session.set_presenting(false);
  else if (!session.lit().empty())
    session.light({});
}

/// Behind the last step comes what is to be repeated, and the next lesson.
void go_on(LessonSession& session) {
  if (!session.next_step()) session.panel = Panel::lessons;
}

/// An audience is not shown how somebody has answered unless the speaker opens it.
bool leads_to_lessons(const LessonSession& session) {
  return !session.is_presenting() && session.panel != Panel::lessons;
}

/// To the first (-1) or the last (1) stage that is not passed over.
void go_to_end(LessonSession& session, int way) {
  std::size_t stage = way < 0 ? 0 : session.lesson().stages.size() - 1;
  while (session.passes_over(stage)) stage = way < 0 ? stage + 1 : stage - 1;
  session.go_to({stage, 0});
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

/// Empty: it is to be seen.
std::string why_no_ghost(Scene scene, Language language) {
  if (!is_computed(scene)) return std::string(words::kNothingMoreExact.in(language));
  scene.motion.ghost = true;
  return requirements(scene).ghost ? "" : std::string(words::kNothingForGhost.in(language));
}

/// By a fiftieth of its range.
void change_number(LessonSession& session, std::size_t number, double steps) {
  constexpr double kSteps = 50;
  const std::vector<Variation> numbers = session.variations();
  if (number >= numbers.size()) return;
  const Variation& present = numbers[number];
  static_cast<void>(session.vary(number, present.value + steps / kSteps * (present.to - present.from)));
}

void toggle_theme(Preferences& preferences) {
  preferences.theme = preferences.theme == Theme::paper ? Theme::dark : Theme::paper;
  preferences.own_theme = true;
}

// What walks goes as in the deck (assets/deck/deck.js): remote clickers send Page Down and Page Up.
constexpr std::array kCommands = {
    CommandFacts{C::next_step, "Right, PageDown", "Walk", "next step", true,
                 [](LessonSession& session) { go_on(session); }},
    CommandFacts{C::previous_step, "Left, PageUp", "Walk", "previous step", true,
                 [](LessonSession& session) { session.previous_step(); }},
    CommandFacts{C::next_stage, "Down, Ctrl+PageDown, Shift+PageDown", "Walk", "next stage", true,
                 [](LessonSession& session) { session.next_stage(); }},
    CommandFacts{C::previous_stage, "Up, Ctrl+PageUp, Shift+PageUp", "Walk",
                 "beginning of this stage, or the stage before", true,
                 [](LessonSession& session) { session.previous_stage(); }},
    CommandFacts{C::first_stage, "Home", "Walk", "first stage", false,
                 [](LessonSession& session) { go_to_end(session, -1); }},
    CommandFacts{C::last_stage, "End", "Walk", "last stage", false,
                 [](LessonSession& session) { go_to_end(session, 1); }},
    CommandFacts{C::find, "Ctrl+F", "Walk", "find words or a formula in the lesson"},

    CommandFacts{C::play_pause, "Space", "Time", "play, pause", false,
                 [](LessonSession& session) { session.set_playing(!session.is_playing()); }},
    CommandFacts{C::frame_forward, "Shift+Right", "Time", "one frame forward", true,
                 [](LessonSession& session) { session.step_frames(1); }},
    CommandFacts{C::frame_back, "Shift+Left", "Time", "one frame back", true,
                 [](LessonSession& session) { session.step_frames(-1); }},
    CommandFacts{C::faster, "Shift+Up", "Time", "twice as fast", true,
                 [](LessonSession& session) { session.set_speed(2 * session.speed()); }},
    CommandFacts{C::slower, "Shift+Down", "Time", "half as fast", true,
                 [](LessonSession& session) { session.set_speed(session.speed() / 2); }},
    CommandFacts{C::reset_time, "0", "Time", "back to the time of the lesson", false,
                 [](LessonSession& session) { session.reset_time(); }},
    CommandFacts{C::start_of_time, "Shift+Home", "Time", "to t = 0", false,
                 [](LessonSession& session) { session.scrub_to(0); }},
    CommandFacts{C::next_flip, ">", "Time", "the next flip", true,
                 [](LessonSession& session) { session.go_to_flip(1); }},
    CommandFacts{C::previous_flip, "<", "Time", "the flip before", true,
                 [](LessonSession& session) { session.go_to_flip(-1); }},

    CommandFacts{C::next_view, "V", "Body", "from space, from the body, both", false,
                 [](LessonSession& session) { show_next_view(session); }},
    CommandFacts{C::turn_left, "Ctrl+Left", "Body", "turn the camera to the left", true,
                 [](LessonSession& session) { turn_camera(session, -kTurn, 0); }},
    CommandFacts{C::turn_right, "Ctrl+Right", "Body", "to the right", true,
                 [](LessonSession& session) { turn_camera(session, kTurn, 0); }},
    CommandFacts{C::turn_up, "Ctrl+Up", "Body", "upward", true,
                 [](LessonSession& session) { turn_camera(session, 0, -kTurn); }},
    CommandFacts{C::turn_down, "Ctrl+Down", "Body", "downward", true,
                 [](LessonSession& session) { turn_camera(session, 0, kTurn); }},
    CommandFacts{C::nearer, "Z", "Body", "nearer", true,
                 [](LessonSession& session) { zoom_camera(session, 1); }},
    CommandFacts{C::farther, "X", "Body", "farther", true,
                 [](LessonSession& session) { zoom_camera(session, -1); }},
    CommandFacts{C::follow, "C", "Body", "the camera turns with the body", false,
                 [](LessonSession& session) { session.set_following(!session.is_following()); }},
    CommandFacts{C::enlarge, "D", "Body", "the figure as large as the page, and back", false,
                 [](LessonSession& session) { session.set_enlarged(!session.is_enlarged()); }},
    CommandFacts{C::ghost, "G", "Body", "the exact body beside the computed one", false,
                 [](LessonSession& session) { toggle_ghost(session); }},
    CommandFacts{C::larger_number, "]", "Body", "the number of the slider larger", true,
                 [](LessonSession& session) { change_number(session, 0, 1); }},
    CommandFacts{C::smaller_number, "[", "Body", "smaller", true,
                 [](LessonSession& session) { change_number(session, 0, -1); }},
    CommandFacts{C::larger_second_number, "}", "Body", "that of the second slider larger", true,
                 [](LessonSession& session) { change_number(session, 1, 1); }},
    CommandFacts{C::smaller_second_number, "{", "Body", "smaller", true,
                 [](LessonSession& session) { change_number(session, 1, -1); }},
    CommandFacts{C::reset_scene, "R", "Body", "the scene of the lesson again", false,
                 [](LessonSession& session) { session.reset_edits(); }},
    CommandFacts{C::undo, "Ctrl+Z", "Body", "undo the last change", true,
                 [](LessonSession& session) { session.undo(); }},
    CommandFacts{C::redo, "Ctrl+Y, Shift+Ctrl+Z", "Body", "make it again", true,
                 [](LessonSession& session) { session.redo(); }},

    CommandFacts{C::next_symbol, "Tab", "Understand", "next symbol", true},
    CommandFacts{C::previous_symbol, "Shift+Tab", "Understand", "previous symbol", true},
    CommandFacts{C::explain, "Enter", "Understand", "explain the symbol"},
    CommandFacts{C::replay, "Y", "Understand", "how this step came out of the one before, again and slowly",
                 false, [](LessonSession& session) { session.replay_step(); }},
    CommandFacts{C::scroll_down, "J", "Understand", "the text of a long stage: further down", true},
    CommandFacts{C::scroll_up, "K", "Understand", "and up again", true},
    CommandFacts{C::copy_step, "Ctrl+C", "Understand", "copy this step as text"},
    CommandFacts{C::read_aloud, "W", "Understand", "read this step aloud; again: be quiet"},

    CommandFacts{C::outline, "O", "Panels", "stages of the lesson", false,
                 [](LessonSession& session) { toggle(session, Panel::outline); }},
    CommandFacts{C::body, "B", "Panels", "body and its spin", false,
                 [](LessonSession& session) { toggle(session, Panel::body); }},
    CommandFacts{C::method, "M", "Panels", "method, step and errors", false,
                 [](LessonSession& session) { toggle(session, Panel::method); }},
    CommandFacts{C::show, "S", "Panels", "what is shown", false,
                 [](LessonSession& session) { toggle(session, Panel::show); }},
    CommandFacts{C::question, "Q", "Panels", "answer the question", false,
                 [](LessonSession& session) { toggle(session, Panel::question); }},
    CommandFacts{C::save, "E", "Panels", "save and copy", false,
                 [](LessonSession& session) { toggle(session, Panel::save); }},
    CommandFacts{C::settings, "F2", "Panels", "settings", false,
                 [](LessonSession& session) { toggle(session, Panel::settings); }},
    CommandFacts{C::lessons, "Ctrl+L", "Panels", "all lessons: how far you are, what to repeat", false,
                 [](LessonSession& session) { toggle(session, Panel::lessons); }},
    CommandFacts{C::help, "?, F1", "Panels", "keys", false,
                 [](LessonSession& session) { toggle(session, Panel::help); }},
    CommandFacts{C::leave, "Escape", "Panels", "close, leave", false,
                 [](LessonSession& session) { leave(session); }},
    CommandFacts{C::switch_focus, "F6", "Panels", "the keys go to the panel, or to the page"},

    CommandFacts{C::larger_text, "+, =", "Window", "larger text", true,
                 [](LessonSession& session) { session.change_text_scale(1); }},
    CommandFacts{C::smaller_text, "-", "Window", "smaller text", true,
                 [](LessonSession& session) { session.change_text_scale(-1); }},
    CommandFacts{C::normal_text, "Ctrl+0", "Window", "text at 100 %", false,
                 [](LessonSession& session) { session.preferences.text_scale = 1; }},
    CommandFacts{C::theme, "T", "Window", "paper, dark", false,
                 [](LessonSession& session) { toggle_theme(session.preferences); }},
    CommandFacts{C::full_screen, "F, F11", "Window", "full screen"},
    CommandFacts{C::present, "P, F5", "Window", "present: the page alone", false,
                 [](LessonSession& session) { session.set_presenting(!session.is_presenting()); }},
    CommandFacts{C::notes, "N", "Window",
                 "present with a window of your own: what comes next, your notes, the time", false,
                 [](LessonSession& session) { session.set_speaker(!session.has_speaker()); }},
    CommandFacts{C::black, ".", "Window",
                 "while presenting, as B: a black screen; there a number and Enter lead to a stage", false,
                 [](LessonSession& session) { session.set_black(!session.is_black()); }},
    CommandFacts{C::point, "L", "Window", "while presenting: a spot that follows the mouse", false,
                 [](LessonSession& session) { session.set_pointing(!session.is_pointing()); }},
    CommandFacts{C::freeze, "H", "Window",
                 "beside your own window: the audience's page stays while you look elsewhere", false,
                 [](LessonSession& session) { session.set_frozen(!session.is_frozen()); }},
    CommandFacts{C::save_page, "Ctrl+S", "Window", "save this page"},
    CommandFacts{C::quit, "Ctrl+Q", "Window", "quit"},
};

/// What moves, turns or changes the figure.
bool is_of_figure(const CommandFacts& facts) {
  return facts.group == "Time" ||
         (facts.group == "Body" && facts.command != C::undo && facts.command != C::redo);
}

}  // namespace

std::span<const CommandFacts> all_commands() { return kCommands; }

std::optional<Command> command_of(std::string_view key) {
  if (key.empty()) return std::nullopt;
  for (const CommandFacts& facts : kCommands)
    if (has_key(facts.keys, key)) return facts.command;
  return std::nullopt;
}

bool is_character(std::string_view key) { return key.size() == 1; }

const CommandFacts& facts_of(Command command) {
  return *std::find_if(kCommands.begin(), kCommands.end(),
                       [&](const CommandFacts& facts) { return facts.command == command; });
}

bool do_command(LessonSession& session, Command command) {
  const auto act = facts_of(command).act;
  if (act && why_idle(session, command).empty()) act(session);
  return act != nullptr;
}

std::string why_idle(const LessonSession& session, Command command) {
  const Language language = session.lesson().about.language;
  const auto said = [language](const Phrase& phrase) { return std::string(phrase.in(language)); };
  const std::string none;
  if (is_of_figure(facts_of(command)) && !session.has_scene()) return said(words::kStepHasNoFigure);
  switch (command) {
    case C::next_step:
      return session.next_place() || leads_to_lessons(session) ? none : said(words::kIsTheEnd);
    case C::next_stage:
      return session.stage_beside(1) ? none : said(words::kIsLastStage);
    case C::previous_step:
      return session.previous_place() ? none : said(words::kIsTheBeginning);
    case C::previous_stage:
      return session.place().step > 0 || session.stage_beside(-1) ? none : said(words::kIsTheBeginning);
    case C::replay:
      return session.preferences.reduced_motion ? said(words::kNothingMoves)
             : session.place().step > 0         ? none
                                                : said(words::kIsFirstStep);
    case C::next_flip:
      return session.flip_beside(1) ? none : said(words::kNoFlipBehind);
    case C::previous_flip:
      return session.flip_beside(-1) ? none : said(words::kNoFlipBefore);
    case C::start_of_time:
      return session.t_s() != 0 ? none : said(words::kIsAtZero);
    case C::faster:
      return session.speed() < kFastest ? none : said(words::kIsFastest);
    case C::slower:
      return session.speed() > kSlowest ? none : said(words::kIsSlowest);
    case C::larger_number:
    case C::smaller_number:
      return !session.variations().empty() ? none : said(words::kNoNumberToVary);
    case C::larger_second_number:
    case C::smaller_second_number:
      return session.variations().size() > 1 ? none : said(words::kNoSecondNumber);
    case C::ghost:
      return why_no_ghost(session.model()->scene, language);
    case C::reset_scene:
      return !session.edits().empty() || session.is_following() ? none : said(words::kIsLessonsScene);
    case C::undo:
      return session.can_undo() ? none : said(words::kNothingToUndo);
    case C::redo:
      return session.can_redo() ? none : said(words::kNothingToRedo);
    case C::larger_text:
      return session.preferences.text_scale < kMostTextScale ? none : said(words::kTextIsLargest);
    case C::smaller_text:
      return session.preferences.text_scale > kLeastTextScale ? none : said(words::kTextIsSmallest);
    case C::normal_text:
      return session.preferences.text_scale != 1 ? none : said(words::kTextIsNormal);
    case C::black:
      return session.is_presenting() ? none : said(words::kBlackIsForAudience);
    case C::point:
      return session.is_presenting() ? none : said(words::kSpotIsForAudience);
    case C::freeze:
      return session.has_speaker() ? none : said(words::kFreezeNeedsWindow);
    default:
      return "";
  }
}

}  // namespace polhode
