// SPDX-License-Identifier: MIT
#include "app/session/command.h"

#include "tests/app/session/example_lesson.h"
#include "tests/app/session/quiz_lesson.h"
#include "tests/support/paths.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <tuple>

namespace polhode {
namespace {

using test::example;

std::vector<std::string> keys_of(const CommandFacts& facts) {
  std::vector<std::string> keys;
  std::istringstream text{std::string(facts.keys)};
  for (std::string key; std::getline(text >> std::ws, key, ',');) keys.push_back(key);
  return keys;
}

TEST(Command, EachHasAKeyAndNoKeyHasTwo) {
  std::map<std::string, Command> by_key;
  std::set<Command> commands;
  for (const CommandFacts& facts : all_commands()) {
    EXPECT_TRUE(commands.insert(facts.command).second) << facts.does;
    EXPECT_FALSE(facts.does.empty());
    const auto keys = keys_of(facts);
    EXPECT_FALSE(keys.empty()) << facts.does;
    for (const std::string& key : keys) {
      EXPECT_TRUE(by_key.emplace(key, facts.command).second) << key;
      EXPECT_EQ(command_of(key), facts.command) << key;
    }
  }
  EXPECT_EQ(commands.size(), static_cast<std::size_t>(Command::quit) + 1) << "all of them are there";
}

TEST(Command, OtherKeysHaveNone) {
  for (const char* key : {"", "Shift+Q", "right", "?, F1", ",", ", ", "U"})
    EXPECT_FALSE(command_of(key)) << key;
}

TEST(Command, HelpGoesGroupByGroup) {
  std::vector<std::string_view> groups;
  for (const CommandFacts& facts : all_commands())
    if (groups.empty() || groups.back() != facts.group) groups.push_back(facts.group);
  EXPECT_EQ(groups,
            (std::vector<std::string_view>{"Walk", "Time", "Body", "Understand", "Panels", "Window"}));
}

TEST(Command, WhatOnlyAWindowCanDoIsLeftToIt) {
  LessonSession session(example());
  const std::set<Command> of_windows = {Command::next_symbol,  Command::previous_symbol, Command::explain,
                                        Command::save_page,    Command::full_screen,     Command::quit,
                                        Command::switch_focus, Command::scroll_down,     Command::scroll_up,
                                        Command::copy_step,    Command::read_aloud,      Command::find};
  for (const CommandFacts& facts : all_commands())
    EXPECT_EQ(do_command(session, facts.command), of_windows.count(facts.command) == 0) << facts.does;
}

TEST(Command, WalksAndPlays) {
  LessonSession session(example());
  const auto press = [&](const char* key) { return do_command(session, command_of(key).value()); };
  press("Right");
  press("Right");
  press("Left");
  EXPECT_EQ(session.place(), (StepPlace{0, 1}));
  press("PageDown");
  press("PageDown");
  EXPECT_EQ(session.place(), (StepPlace{0, 3}));
  press("PageUp");
  EXPECT_EQ(session.place(), (StepPlace{0, 2}));
  for (const auto& [next, previous] : {std::pair("Down", "Up"), std::pair("Ctrl+PageDown", "Ctrl+PageUp"),
                                       std::pair("Shift+PageDown", "Shift+PageUp")}) {
    press(next);
    EXPECT_EQ(session.place(), (StepPlace{1, 0})) << next;
    press(previous);
    EXPECT_EQ(session.place(), (StepPlace{0, 0})) << previous;
    press("Right");
    press(previous);
    EXPECT_EQ(session.place(), (StepPlace{0, 0})) << "first to the beginning of this stage";
  }
  press("End");
  EXPECT_EQ(session.place(), (StepPlace{2, 0}));
  press("Up");
  press("Home");
  EXPECT_EQ(session.place(), (StepPlace{0, 0}));
  press("Space");
  EXPECT_TRUE(session.is_playing());
  press("Shift+Up");
  EXPECT_EQ(session.speed(), 2);
  press("Shift+Down");
  press("Shift+Right");
  EXPECT_FALSE(session.is_playing());
  EXPECT_GT(session.t_s(), 0.5);
  press("Shift+Left");
  EXPECT_NEAR(session.t_s(), 0.5, 1e-15);
  press("0");
  EXPECT_EQ(session.t_s(), 0.5);
}

TEST(Command, ChangesTheSceneAndGivesItBack) {
  LessonSession session(example());
  const auto press = [&](const char* key) { do_command(session, command_of(key).value()); };
  const auto views = [&] { return session.model()->scene.views; };
  press("V");
  EXPECT_EQ(views(), (std::vector<View>{View::body}));
  press("V");
  EXPECT_EQ(views(), (std::vector<View>{View::space, View::body}));
  press("V");
  EXPECT_EQ(views(), (std::vector<View>{View::space}));
  press("G");
  EXPECT_FALSE(session.edits().motion) << "that of an exact motion would not be seen";
  SceneEdits computed = session.edits();
  computed.motion = MotionSpec{.method = Method::rk4, .step_s = 0.01};
  ASSERT_TRUE(session.set_edits(computed));
  press("G");
  EXPECT_TRUE(session.model()->scene.motion.ghost);
  press("C");
  EXPECT_TRUE(session.is_following());
  for (const auto& [key, back] :
       {std::pair("Ctrl+Left", "Ctrl+Right"), std::pair("Ctrl+Up", "Ctrl+Down"), std::pair("Z", "X")}) {
    const CameraSpec before = session.camera();
    press(key);
    EXPECT_NE(session.camera(), before) << key;
    press(back);
    EXPECT_NEAR(session.camera().azimuth_rad, before.azimuth_rad, 1e-5) << key;
    EXPECT_NEAR(session.camera().elevation_rad, before.elevation_rad, 1e-5) << key;
    EXPECT_NEAR(session.camera().zoom, before.zoom, 0.02) << key;
  }
  press("R");
  EXPECT_TRUE(session.edits().empty());
  session.go_to({1, 0});
  for (const char* key : {"Ctrl+Left", "Z", "V", "G", "C", "R", "Space", "0", "Shift+Right"}) press(key);
  EXPECT_EQ(session.model(), nullptr) << "without a scene they do nothing";
}

TEST(Command, OpensOnePanelAtATimeAndLeavesWhatIsOnTop) {
  LessonSession session(example());
  const auto press = [&](const char* key) { do_command(session, command_of(key).value()); };
  for (const auto& [key, panel] : std::vector<std::pair<const char*, Panel>>{{"O", Panel::outline},
                                                                             {"B", Panel::body},
                                                                             {"M", Panel::method},
                                                                             {"S", Panel::show},
                                                                             {"Q", Panel::question},
                                                                             {"E", Panel::save},
                                                                             {"F2", Panel::settings},
                                                                             {"F1", Panel::help}}) {
    press(key);
    EXPECT_EQ(session.panel, panel) << key;
  }
  press("?");
  EXPECT_EQ(session.panel, Panel::none) << "the same key again closes it";
  press("P");
  press("B");
  session.light("omega");
  press("Escape");
  EXPECT_EQ(session.panel, Panel::none) << "it lies over the page";
  EXPECT_TRUE(session.is_presenting());
  press("Escape");
  EXPECT_FALSE(session.is_presenting());
  EXPECT_EQ(session.lit(), "omega");
  press("Escape");
  EXPECT_EQ(session.lit(), "");
}

// 2026-11-28: what the speaker had tried stood on the page as "right" when the audience came to see it.
TEST(Command, AnAudienceSeesAQuestionAsItIsAsked) {
  LessonSession session(test::quiz());
  const auto answered = [&]() -> const Ask& {
    const Ask& ask = *session.questions().front();
    session.answer(ask, "w1");
    EXPECT_NE(session.judged(ask), nullptr);
    return ask;
  };
  const Ask& before = answered();
  session.set_presenting(true);
  EXPECT_EQ(session.judged(before), nullptr);
  EXPECT_NE(session.record(before), nullptr) << "that it was tried is known all the same";
  session.set_speaker(true);
  session.set_frozen(true);
  const Ask& meanwhile = answered();
  session.set_frozen(false);
  EXPECT_EQ(session.judged(meanwhile), nullptr);
  const Ask& in_public = answered();
  session.set_speaker(false);
  EXPECT_NE(session.judged(in_public), nullptr);
}

// The speaker's window comes with presenting and goes with it, and stays where one goes on.
TEST(Command, TheSpeakerHasAWindowWhilePresenting) {
  LessonSession session(example());
  const auto press = [&](const char* key) { do_command(session, command_of(key).value()); };
  press("N");
  EXPECT_TRUE(session.is_presenting());
  EXPECT_TRUE(session.has_speaker());
  press("N");
  EXPECT_TRUE(session.is_presenting()) << "before the audience nothing changes";
  EXPECT_FALSE(session.has_speaker());
  for (const char* leaving : {"P", "F5", "Escape"}) {
    session.set_speaker(true);
    press(leaving);
    EXPECT_FALSE(session.is_presenting()) << leaving;
    EXPECT_FALSE(session.has_speaker()) << leaving;
    press("P");
    EXPECT_FALSE(session.has_speaker()) << "that of the last time";
    press("P");
  }
  press("N");
  for (const char* going : {"Right", "PageDown", "Left", "Down", "Up", "End", "Home"}) {
    press(going);
    EXPECT_TRUE(session.has_speaker()) << going;
  }
}

TEST(Command, TellsWhyItHasNothingToDo) {
  LessonSession session(example());
  const auto why = [&](const char* key) { return why_idle(session, command_of(key).value()); };
  for (const char* key : {"Left", "Up"}) EXPECT_EQ(why(key), "This is the beginning.") << key;
  for (const char* key : {"Right", "Down", "Space", "0", "V", "Ctrl+Left", "T"})
    EXPECT_EQ(why(key), "") << key;
  EXPECT_EQ(why("R"), "This is the lesson's scene.");
  EXPECT_NE(why("G"), "");
  EXPECT_EQ(why("Ctrl+Z"), "There is no change to undo.");
  EXPECT_NE(why("Ctrl+Y"), "");
  EXPECT_EQ(why("]"), "This step has no number to vary.");
  for (const char* key : {".", "L", "H"}) EXPECT_NE(why(key), "") << key;
  session.set_speed(kFastest);
  EXPECT_NE(why("Shift+Up"), "");
  EXPECT_EQ(why("Shift+Down"), "");
  session.go_to({1, 0});
  for (const char* key : {"Space", "Shift+Right", ">", "0", "V", "Ctrl+Up", "Z", "C", "G", "]", "R"})
    EXPECT_EQ(why(key), "This step has no figure.") << key;
  session.go_to({2, 0});
  EXPECT_EQ(why("Right"), "") << "behind the end is the list of lessons";
  session.panel = Panel::lessons;
  EXPECT_EQ(why("Right"), "This is the end.");
  session.panel = Panel::none;
  EXPECT_EQ(why("Down"), "This is the last stage.");
  session.set_speaker(true);
  for (const char* key : {".", "L", "H"}) EXPECT_EQ(why(key), "") << key;
}

// What has nothing to do changes nothing; what has, is not called idle.
TEST(Command, IsIdleJustWhereItChangesNothing) {
  const auto seen = [](const LessonSession& session) {
    return std::tuple(session.place(), session.t_s(), session.speed(), session.is_playing(), session.edits(),
                      session.camera(), session.is_black(), session.is_pointing(), session.is_frozen());
  };
  const auto lesson = example();
  for (std::size_t stage = 0; stage < lesson->lesson.stages.size(); ++stage)
    for (const CommandFacts& facts : all_commands()) {
      LessonSession session(lesson);
      session.go_to({stage, 0});
      const auto before = seen(session);
      if (why_idle(session, facts.command).empty() || !do_command(session, facts.command)) continue;
      EXPECT_TRUE(seen(session) == before) << facts.does << " in stage " << stage;
    }
}

TEST(Command, LeadsBehindTheEndToTheLessons) {
  LessonSession session(example());
  session.go_to({2, 0});
  do_command(session, Command::next_step);
  EXPECT_EQ(session.panel, Panel::lessons);
  EXPECT_EQ(session.place(), (StepPlace{2, 0}));
  session.panel = Panel::none;
  session.set_presenting(true);
  EXPECT_EQ(why_idle(session, Command::next_step), "This is the end.") << "an audience is shown no answers";
  do_command(session, Command::next_step);
  EXPECT_EQ(session.panel, Panel::none);
}

TEST(Command, WalksPastWhatIsNotForThisClass) {
  LessonSession session(example());
  const auto press = [&](const char* key) { do_command(session, command_of(key).value()); };
  session.leave_out("words", true);
  press("Down");
  EXPECT_EQ(session.place(), (StepPlace{1, 0})) << "who reads goes through all";
  press("Home");
  session.set_presenting(true);
  press("Down");
  EXPECT_EQ(session.place(), (StepPlace{2, 0}));
  press("Left");
  EXPECT_EQ(session.place(), (StepPlace{0, session.stage().steps.size() - 1}));
  press("Right");
  EXPECT_EQ(session.place(), (StepPlace{2, 0}));
  press("Up");
  EXPECT_EQ(session.place(), (StepPlace{0, 0}));
  session.go_to({1, 0});
  EXPECT_EQ(session.place(), (StepPlace{1, 0})) << "whoever asks for it gets it";
  session.set_left_out({"free", "top"});
  press("End");
  EXPECT_EQ(session.place(), (StepPlace{1, 0}));
  EXPECT_EQ(why_idle(session, Command::next_step), "This is the end.");
  EXPECT_EQ(session.chosen_stages(), (std::vector<std::size_t>{1}));
  session.set_left_out({"free", "words", "top", "unknown"});
  EXPECT_EQ(session.left_out().size(), 3u);
  EXPECT_EQ(session.chosen_stages().size(), 3u) << "not even one would be left";
  press("Home");
  EXPECT_EQ(session.place(), (StepPlace{0, 0}));
  session.replace_lesson(example());
  EXPECT_EQ(session.left_out().size(), 3u);
  EXPECT_EQ(session.visited().size(), 3u) << "what was seen is kept too";
}

/// What the keys of the deck do that go to a slide: "ArrowRight" → "wanted + 1", outside the overview and
/// without Shift.
std::map<std::string, std::string> moves_of_deck() {
  std::ifstream script(test::source_dir() / "assets/deck/deck.js");
  const std::regex move("case '(\\w+)': return (?:.*: )?(\\S.*);");
  std::map<std::string, std::string> moves;
  std::smatch found;
  for (std::string line; std::getline(script, line);)
    if (std::regex_search(line, found, move)) moves[found[1]] = found[2];
  return moves;
}

TEST(Command, TheSameKeysWalkThroughTheDeck) {
  const std::map<std::string, std::string> deck = moves_of_deck();
  for (const auto& [key, of_deck, of_window] :
       {std::tuple("PageDown", "wanted + 1", Command::next_step),
        std::tuple("PageUp", "wanted - 1", Command::previous_step),
        std::tuple("ArrowRight", "wanted + 1", Command::next_step),
        std::tuple("ArrowLeft", "wanted - 1", Command::previous_step),
        std::tuple("ArrowDown", "nextStage(wanted)", Command::next_stage),
        std::tuple("ArrowUp", "previousStage(wanted)", Command::previous_stage)}) {
    ASSERT_TRUE(deck.contains(key)) << key;
    EXPECT_EQ(deck.at(key), of_deck) << key;
    const std::string name = key;
    EXPECT_EQ(command_of(name.starts_with("Arrow") ? name.substr(5) : name), of_window) << key;
  }
}

TEST(Command, ChangesHowItIsShown) {
  LessonSession session(example());
  do_command(session, *command_of("T"));
  EXPECT_EQ(session.preferences.theme, Theme::dark);
  do_command(session, *command_of("T"));
  EXPECT_EQ(session.preferences.theme, Theme::paper);
  do_command(session, *command_of("+"));
  EXPECT_GT(session.preferences.text_scale, 1);
  do_command(session, *command_of("-"));
  EXPECT_NEAR(session.preferences.text_scale, 1, 1e-15);
}

TEST(WhyIdle, IsSaidInTheLanguageOfTheLesson) {
  const LessonSession session(test::loaded_lesson("intermediate-axis.de"));
  EXPECT_EQ(why_idle(session, Command::previous_step), "Das ist der Anfang.");
  EXPECT_EQ(why_idle(session, Command::undo), "Es gibt keine Änderung, die rückgängig zu machen wäre.");
}

}  // namespace
}  // namespace polhode
