// SPDX-License-Identifier: MIT
// Every key that `?` tells of, with each panel open and before an audience: it does what it does on the page,
// or moves in the panel, or says why it has nothing to do. None is dead, none does another's work.
#include "tests/app/window/screen_harness.h"
#include "tests/support/paths.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <map>
#include <set>

namespace polhode {
namespace {

std::vector<std::string> keys_of(const CommandFacts& facts) {
  std::vector<std::string> keys;
  for (std::string_view rest = facts.keys; !rest.empty();) {
    const std::size_t end = std::min(rest.find(", "), rest.size());
    keys.emplace_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 2, rest.size()));
  }
  return keys;
}

std::shared_ptr<const LoadedLesson> lesson_of_keys() {
  std::ifstream file(test::source_dir() / "tests/data/window/keys.md");
  return test::loaded_text(std::string(std::istreambuf_iterator<char>(file), {}));
}

class PanelKeys : public ScreenTest {
 protected:
  static constexpr Size kSmall{640, 480};

  PanelKeys() {
    session.replace_lesson(lesson_of_keys());
    session.preferences.reduced_motion = true;
  }

  void show(int count) {
    for (int i = 0; i < count; ++i)
      ASSERT_TRUE(screen->draw(session, {.size = kSmall, .scale = 1, .seconds = 0.02}));
  }

  /// In the middle of the lesson, of the time and of all that has two ends, with something changed by hand.
  /// Nothing is drawn: whatever has the keyboard keeps it.
  void restore(Panel panel, bool presents) {
    session.set_presenting(false);
    session.preferences = {};
    session.preferences.reduced_motion = true;
    session.preferences.text_scale = 1.1;
    session.set_speed(1);
    session.go_to({0, 0});
    session.go_to({1, 2});
    session.forget_answer(*session.questions().front());
    session.set_playing(false);
    session.reset_edits();
    session.begin_change();
    ASSERT_TRUE(session.vary(0, 0.05));
    session.scrub_to(22);
    session.set_presenting(presents);
    session.panel = panel;
    screen->requests() = {};
    screen->tell("");
  }

  /// The panel is opened by its key.
  void begin(const std::string& opened_by, bool presents) {
    restore(Panel::none, presents);
    show(1);
    if (!opened_by.empty()) screen->press(session, opened_by);
    show(3);
    screen->tell("");
  }

  /// What a key may change, but for the panel.
  std::string seen() {
    const CameraSpec camera = session.camera();
    const Scene* scene = session.model() ? &session.model()->scene : nullptr;
    std::string numbers;
    for (const Variation& number : session.variations()) numbers += fmt::format("{} ", number.value);
    const WindowRequests& asked = screen->requests();
    return fmt::format(
        "place {}.{} t {} playing {} speed {} text {} theme {} presenting {} speaker {} black {} spot {} "
        "frozen {} "
        "following {} camera {} {} {} numbers {} views {} ghost {} asked {} {} {} {} said {}",
        session.place().stage, session.place().step, session.t_s(), session.is_playing(), session.speed(),
        session.preferences.text_scale, static_cast<int>(session.preferences.theme), session.is_presenting(),
        session.has_speaker(), session.is_black(), session.is_pointing(), session.is_frozen(),
        session.is_following(), camera.azimuth_rad, camera.elevation_rad, camera.zoom, numbers,
        scene ? scene->views.size() * 10 + (scene->views.front() == View::body ? 1 : 0) : 0,
        scene && scene->motion.ghost, asked.full_screen, asked.quit, asked.save_as.has_value(),
        asked.clipboard.size() + asked.read_aloud.size(), screen->notice());
  }
};

struct OpenPanel {
  const char* key;
  Panel panel;
};
constexpr OpenPanel kOpen[] = {{"O", Panel::outline},   {"B", Panel::body},         {"M", Panel::method},
                               {"S", Panel::show},      {"Q", Panel::question},     {"E", Panel::save},
                               {"F2", Panel::settings}, {"Ctrl+L", Panel::lessons}, {"?", Panel::help}};

TEST_F(PanelKeys, DoInEveryPanelWhatTheyDoOnThePage) {
  using C = Command;
  const std::set<std::string> moving = {"Left", "Right",     "Up",     "Down",     "Space", "Enter",
                                        "Tab",  "Shift+Tab", "PageUp", "PageDown", "Home",  "End"};
  const std::set<std::string> scrolling = {"Up", "Down", "PageUp", "PageDown", "Home", "End"};
  const std::set<Command> of_panels = {C::outline, C::body,     C::method, C::show,  C::question,
                                       C::save,    C::settings, C::help,   C::leave, C::switch_focus,
                                       C::explain, C::find,     C::lessons};
  int pressed = 0;
  for (const bool presents : {false, true}) {
    std::map<std::string, std::string> on_page;
    const auto press = [&](const std::string& key) {
      const bool is_done = screen->press(session, key);
      ++pressed;
      return is_done;
    };
    begin("", presents);
    for (const CommandFacts& facts : all_commands())
      for (const std::string& key : keys_of(facts)) {
        if (of_panels.contains(facts.command) || key.ends_with("Tab"))
          begin("", presents);
        else
          restore(Panel::none, presents);
        EXPECT_TRUE(press(key)) << key << " is dead on the page";
        on_page[key] = seen();
        if (of_panels.contains(facts.command) || key.ends_with("Tab")) begin("", presents);
      }
    for (const OpenPanel& open : kOpen) {
      // Some of them are enough there, where B is a black screen.
      const bool is_tried =
          open.panel == Panel::outline || open.panel == Panel::question || open.panel == Panel::help;
      if (presents && !is_tried) continue;
      bool is_open = false;
      for (const CommandFacts& facts : all_commands())
        for (const std::string& key : keys_of(facts)) {
          const std::string where =
              fmt::format("{} beside {}{}", key, open.key, presents ? ", presented" : "");
          if (is_open)
            restore(open.panel, presents);
          else
            begin(open.key, presents);
          is_open = !of_panels.contains(facts.command) && !key.ends_with("Tab");
          ASSERT_EQ(session.panel, open.panel) << where;
          const std::string before = seen();
          const bool is_done = press(key);
          const bool is_of_clicker = presents && (key == "PageUp" || key == "PageDown");
          const std::set<std::string>& own = open.panel == Panel::help ? scrolling : moving;
          if (open.panel != Panel::question && own.contains(key) && !is_of_clicker) {
            EXPECT_TRUE(!is_done || key.ends_with("Tab")) << where << ": it moves in the panel";
            EXPECT_EQ(seen(), before) << where;
          } else if (of_panels.contains(facts.command)) {
            EXPECT_TRUE(is_done) << where << " is dead";
          } else if (open.panel == Panel::question && key == "B") {
            EXPECT_NE(session.record(*session.questions().front()), nullptr) << where << ": a choice";
          } else {
            EXPECT_TRUE(is_done) << where << " is dead";
            EXPECT_EQ(seen(), on_page[key]) << where;
          }
          if (HasFatalFailure()) return;
        }
    }
  }
  EXPECT_GT(pressed, 800);
}

}  // namespace
}  // namespace polhode
