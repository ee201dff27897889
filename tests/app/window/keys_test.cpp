// SPDX-License-Identifier: MIT
// Every key of the help, in every panel and before an audience: it does its own work and no other's. What of
// a session a command may change is a row of a table; all of it is looked at after each key.
#include "app/session/command.h"
#include "tests/app/window/screen_harness.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

namespace polhode {
namespace {

/// What there is to be changed, each part as a text.
using Parts = std::map<std::string, std::string>;

class KeysTest : public ScreenTest {
 protected:
  /// As small as a page may be: what is looked at are sessions.
  void frame(int count = 1) {
    for (int i = 0; i < count; ++i) {
      ImGui::GetIO().MousePos = {x, y};
      ASSERT_TRUE(screen->draw(session, {.size = {720, 480}, .scale = 1, .seconds = 0.02}));
    }
  }
  Parts parts() {
    Parts all;
    const Place place = session.place();
    all["stage"] = fmt::format("{}", place.stage);
    all["step"] = fmt::format("{}", place.step);
    all["time"] = fmt::format("{:.17g}", session.t_s());
    all["playing"] = fmt::format("{}", session.is_playing());
    all["speed"] = fmt::format("{}", session.speed());
    const CameraSpec camera = session.camera();
    all["camera"] =
        fmt::format("{} {} {} {}", camera.azimuth_rad, camera.elevation_rad, camera.distance, camera.zoom);
    const SceneEdits& edits = session.edits();
    all["views"] = fmt::format("{}", edits.views ? static_cast<int>(edits.views->size()) * 10 +
                                                       static_cast<int>(edits.views->front())
                                                 : -1);
    all["motion"] = fmt::format("{}", edits.motion ? static_cast<int>(edits.motion->ghost) : -1);
    all["numbers"] = fmt::format("{}", fmt::join(edits.numbers, " "));
    all["body"] = fmt::format("{} {}", edits.body.has_value(), edits.w0_B.has_value());
    all["undo"] = fmt::format("{}", session.can_undo());
    all["following"] = fmt::format("{}", session.is_following());
    all["lit"] = session.lit();
    all["panel"] = fmt::format("{}", static_cast<int>(session.panel));
    all["theme"] = fmt::format("{}", static_cast<int>(session.preferences.theme));
    all["text"] = fmt::format("{}", session.preferences.text_scale);
    all["other preferences"] =
        fmt::format("{} {}", session.preferences.reduced_motion, session.preferences.letter_keys);
    all["presenting"] = fmt::format("{}", session.is_presenting());
    all["speaker"] = fmt::format("{}", session.has_speaker());
    all["black"] = fmt::format("{}", session.is_black());
    all["scrolled"] = fmt::format("{}", screen->page().page().hidden);
    all["answers"] = fmt::format("{}", session.answers().size());
    const WindowRequests& asked = screen->requests();
    all["full screen"] = fmt::format("{}", asked.full_screen);
    all["saved"] = fmt::format("{}", asked.save_as.has_value());
    all["copied"] = asked.clipboard;
    all["quit"] = fmt::format("{}", asked.quit);
    all["keyboard"] = fmt::format("{}", ImGui::GetIO().WantTextInput || ImGui::GetIO().NavVisible);
    return all;
  }

  static std::set<std::string> changed(const Parts& before, const Parts& after) {
    std::set<std::string> names;
    for (const auto& [name, value] : before)
      if (after.at(name) != value) names.insert(name);
    return names;
  }

  /// A step in the middle of its stage and lesson, with a scene that varies two numbers, a flip before and
  /// one behind the present time, and a text that is scrolled.
  void begin() {
    session.replace_lesson(lesson());
    session.set_presenting(false);
    session.panel = Panel::none;
    session.preferences = Preferences{.reduced_motion = true};
    session.light("");
    session.set_playing(false);
    session.set_following(false);
    session.go_to({0, 0});
    session.go_to({1, 1});
    session.reset_edits();
    session.set_speed(1);
    session.set_camera({.azimuth_rad = 0.5, .elevation_rad = 0.3, .distance = 4, .zoom = 1});
    screen->requests() = {};
    x = y = -1;
    frame(3);
    ImGui::SetWindowFocus(nullptr);
    frame(2);
    session.begin_change();
    ASSERT_TRUE(session.vary(0, 4));
    session.begin_change();
    ASSERT_TRUE(session.vary(1, 0.2));
    const std::vector<double> flips = session.flips();
    ASSERT_GE(flips.size(), 2U);
    session.scrub_to(0.5 * (flips[0] + flips[1]));
    frame(3);
    ASSERT_GT(screen->page().page().overflow, 0);
    screen->press(session, "K");
    frame(3);
    ASSERT_GT(screen->page().page().hidden, 0);
    ASSERT_LT(screen->page().page().hidden, screen->page().page().overflow);
    screen->requests() = {};
  }

  static std::shared_ptr<const LoadedLesson> lesson() {
    static const auto kLesson = [] {
      std::string words;
      for (int i = 0; i < 40; ++i) words += "Words that fill the page, and a few more of them. ";
      return test::loaded_text(
          "+++\nformat = 1\nid = \"keys\"\ntitle = \"Keys\"\n+++\n# One {one}\nText.\n\n# Two {two}\nOf "
          "$\\vec\\omega$.\n\n```scene\nomega = [0.02, 3, 0.05]\nbody = \"book\"\nduration = 20\n"
          "show = [\"shape\", \"omega\"]\n"
          "vary = { omega2 = { from = 1, to = 9 }, omega3 = { from = 0.01, to = 1 } }\n```\n\n---\n" +
          words +
          "\n\n```ask a\ntype = \"expression\"\nprompt = \"What?\"\nanswer = \"w1*w2*(I2 - I1)\"\n```\n\n"
          "---\nMore.\n\n# Three {three}\nText.\n");
    }();
    return kLesson;
  }
};

/// What a command changes: of these at least one part, and no other.
struct Effect {
  Command command;
  std::set<std::string> parts;
};

const std::vector<Effect>& effects() {
  using C = Command;
  static const std::set<std::string> kOfPlace = {"stage", "step",     "time",     "playing", "camera",
                                                 "views", "motion",   "numbers",  "body",    "undo",
                                                 "lit",   "scrolled", "following"};
  static const std::vector<Effect> kEffects = {
      {C::next_step, kOfPlace},
      {C::previous_step, kOfPlace},
      {C::next_stage, kOfPlace},
      {C::previous_stage, kOfPlace},
      {C::first_stage, kOfPlace},
      {C::last_stage, kOfPlace},
      {C::play_pause, {"playing"}},
      {C::frame_forward, {"time", "playing"}},
      {C::frame_back, {"time", "playing"}},
      {C::faster, {"speed"}},
      {C::slower, {"speed"}},
      {C::reset_time, {"time"}},
      {C::next_flip, {"time", "playing"}},
      {C::previous_flip, {"time", "playing"}},
      {C::next_view, {"views", "undo"}},
      {C::turn_left, {"camera"}},
      {C::turn_right, {"camera"}},
      {C::turn_up, {"camera"}},
      {C::turn_down, {"camera"}},
      {C::nearer, {"camera"}},
      {C::farther, {"camera"}},
      {C::follow, {"following", "camera"}},
      {C::ghost, {"motion", "undo"}},
      {C::larger_number, {"numbers", "undo"}},
      {C::smaller_number, {"numbers", "undo"}},
      {C::larger_second_number, {"numbers", "undo"}},
      {C::smaller_second_number, {"numbers", "undo"}},
      {C::reset_scene, {"numbers", "camera", "views", "motion", "body", "following", "time", "undo"}},
      {C::undo, {"numbers", "undo"}},
      {C::next_symbol, {"lit", "scrolled"}},
      {C::previous_symbol, {"lit", "scrolled"}},
      {C::scroll_down, {"scrolled"}},
      {C::scroll_up, {"scrolled"}},
      {C::copy_step, {"copied"}},
      {C::outline, {"panel", "keyboard"}},
      {C::body, {"panel", "keyboard"}},
      {C::method, {"panel", "keyboard"}},
      {C::show, {"panel", "keyboard"}},
      {C::question, {"panel", "keyboard"}},
      {C::save, {"panel", "keyboard"}},
      {C::settings, {"panel", "keyboard"}},
      {C::help, {"panel", "keyboard"}},
      {C::larger_text, {"text", "scrolled"}},
      {C::smaller_text, {"text", "scrolled"}},
      {C::theme, {"theme"}},
      {C::full_screen, {"full screen"}},
      {C::present, {"presenting", "panel", "scrolled", "speaker", "black"}},
      {C::notes, {"speaker", "presenting", "panel", "scrolled"}},
      {C::save_page, {"saved"}},
      {C::quit, {"quit"}},
  };
  return kEffects;
}

/// Where a key does nothing unless there is something for it: looked at by tests of their own.
bool needs_more(Command command) {
  return command == Command::explain || command == Command::leave || command == Command::switch_focus ||
         command == Command::normal_text || command == Command::black;
}

std::vector<std::string> keys_of(const CommandFacts& facts) {
  std::vector<std::string> keys;
  std::string_view rest = facts.keys;
  while (true) {
    const std::size_t end = rest.find(", ");
    keys.emplace_back(rest.substr(0, end));
    if (end == rest.npos) return keys;
    rest.remove_prefix(end + 2);
  }
}

bool is_of_focused_panel(std::string_view key) {
  static const std::set<std::string_view> kKeys = {"Left",  "Right", "Up",        "Down",   "Space",
                                                   "Enter", "Tab",   "Shift+Tab", "PageUp", "PageDown",
                                                   "Home",  "End",   "Backspace"};
  return kKeys.contains(key);
}

TEST(Keys, HaveARowForEachCommand) {
  for (const CommandFacts& facts : all_commands()) {
    const auto count = std::ranges::count(effects(), facts.command, &Effect::command);
    EXPECT_EQ(count, needs_more(facts.command) ? 0 : 1) << facts.does;
  }
}

TEST_F(KeysTest, DoTheirOwnWorkOnThePage) {
  for (const auto& [command, allowed] : effects())
    for (const std::string& key : keys_of(facts_of(command))) {
      begin();
      const Parts before = parts();
      EXPECT_TRUE(screen->press(session, key)) << key;
      const Parts at_once = parts();
      frame(3);
      std::set<std::string> all = changed(before, parts());
      all.merge(changed(before, at_once));
      EXPECT_FALSE(all.empty()) << key << " is dead";
      for (const std::string& part : all)
        EXPECT_TRUE(allowed.contains(part)) << key << " changes the part " << part;
    }
}

// While a panel is open that a click has left, and before an audience, they do the same: but for those that
// the panel of questions takes for a text, and the one that blacks the screen.
TEST_F(KeysTest, DoTheSameBesideEveryPanelAndBeforeAnAudience) {
  struct Where {
    const char* name;
    Panel panel;
    bool presenting;
  };
  std::vector<Where> places = {{"presenting", Panel::none, true}};
  for (int panel = 1; panel <= static_cast<int>(Panel::help); ++panel)
    places.push_back({"beside a panel", static_cast<Panel>(panel), false});
  for (const Where& where : places)
    for (const auto& [command, allowed] : effects()) {
      const std::string key = keys_of(facts_of(command)).front();
      if (where.presenting && key == "B") continue;  // black
      begin();
      session.set_presenting(where.presenting);
      session.panel = where.panel;
      frame(4);
      screen->requests() = {};
      const Parts before = parts();
      const std::string at = fmt::format("{} {}, {}", where.name, static_cast<int>(where.panel), key);
      EXPECT_TRUE(screen->press(session, key)) << at;
      const Parts at_once = parts();
      frame(3);
      std::set<std::string> all = changed(before, parts());
      all.merge(changed(before, at_once));
      EXPECT_FALSE(all.empty()) << at << " is dead";
      for (const std::string& part : all)
        EXPECT_TRUE(allowed.contains(part)) << at << " changes the part " << part;
    }
}

// A panel that a key has opened has the keys that move in it; all others are the page's.
TEST_F(KeysTest, OfAPanelThatAKeyHasOpenedAreItsOwnOrThePages) {
  for (const char* opening : {"O", "B", "M", "S", "F2", "F1"})
    for (const auto& [command, allowed] : effects()) {
      const std::string key = keys_of(facts_of(command)).front();
      begin();
      screen->press(session, opening);
      frame(4);
      screen->requests() = {};
      const Parts before = parts();
      const std::string at = fmt::format("{} in {}", key, opening);
      if (is_of_focused_panel(key)) {
        EXPECT_FALSE(screen->press(session, key)) << at << " is the panel's";
        EXPECT_TRUE(changed(before, parts()).empty()) << at;
        continue;
      }
      EXPECT_TRUE(screen->press(session, key)) << at;
      const Parts at_once = parts();
      frame(3);
      std::set<std::string> all = changed(before, parts());
      all.merge(changed(before, at_once));
      EXPECT_FALSE(all.empty()) << at << " is dead";
      for (const std::string& part : all)
        EXPECT_TRUE(allowed.contains(part) || part == "keyboard") << at << " changes the part " << part;
    }
}

// What is typed into an answer is typed; what leaves it, saves or opens by an F key is still done.
TEST_F(KeysTest, OfAFieldAreTyped) {
  for (const auto& [command, allowed] : effects())
    for (const std::string& key : keys_of(facts_of(command))) {
      begin();
      screen->press(session, "Q");
      frame(5);
      ASSERT_TRUE(ImGui::GetIO().WantTextInput);
      screen->requests() = {};
      const Parts before = parts();
      const bool is_done = screen->press(session, key);
      const bool is_function_key = key.size() > 1 && key[0] == 'F';
      EXPECT_EQ(is_done, is_function_key || key == "Ctrl+S") << key;
      EXPECT_TRUE(is_done || changed(before, parts()).empty()) << key;
    }
}

// The speaker's keys are the page's, whatever has the focus before the audience.
TEST_F(KeysTest, FromTheSpeakersWindowDoTheirOwnWork) {
  for (const bool panel_has_focus : {false, true})
    for (const auto& [command, allowed] : effects()) {
      const std::string key = keys_of(facts_of(command)).front();
      if (key == "B") continue;  // black
      begin();
      session.set_speaker(true);
      frame(3);
      if (panel_has_focus) {
        screen->press(session, "M");
        frame(4);
      }
      screen->requests() = {};
      const Parts before = parts();
      EXPECT_TRUE(screen->press_from_afar(session, key, false)) << key;
      const Parts at_once = parts();
      frame(3);
      std::set<std::string> all = changed(before, parts());
      all.merge(changed(before, at_once));
      all.erase("keyboard");
      EXPECT_FALSE(all.empty()) << key << " is dead";
      for (const std::string& part : all)
        EXPECT_TRUE(allowed.contains(part)) << key << " changes the part " << part;
    }
}

TEST_F(KeysTest, ThatNeedMoreDoItWhereThereIsSomething) {
  begin();
  session.change_text_scale(2);
  EXPECT_TRUE(screen->press(session, "Ctrl+0"));
  EXPECT_EQ(session.preferences.text_scale, 1);
  session.light("omega");
  EXPECT_TRUE(screen->press(session, "Escape"));
  EXPECT_EQ(session.lit(), "");
  EXPECT_TRUE(screen->press(session, "."));
  EXPECT_FALSE(session.is_black()) << "nobody presents";
  session.set_presenting(true);
  frame(3);
  EXPECT_TRUE(screen->press(session, "."));
  EXPECT_TRUE(session.is_black());
}

}  // namespace
}  // namespace polhode
