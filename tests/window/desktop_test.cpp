// SPDX-License-Identifier: MIT
// What the window asks of the desktop that it runs on, whose programs are a test's own.
#include "tests/window/window_test.h"

#include <fstream>

namespace polhode::window_test {
namespace {

class Desktop : public WindowTest {
 protected:
  /// A program of this name that is found before others.
  void make_program(const std::string& name, const std::string& script) {
    const std::filesystem::path folder = home().folder / "programs";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / name) << "#!/bin/sh\n" << script;
    std::filesystem::permissions(folder / name, std::filesystem::perms::owner_all);
  }
  Environment environment() const {
    const char* path = std::getenv("PATH");
    return {{"PATH", (home().folder / "programs").string() + ':' + (path ? path : "")},
            {"DBUS_SESSION_BUS_ADDRESS", "unix:path=/nowhere"}};
  }
  static bool is_dark(const Image& picture) { return picture.pixel(20, 400)[0] < 90; }
};

TEST_F(Desktop, IsDarkAndSoIsTheWindowUntilSomebodyChooses) {
  make_program("dbus-send",
               "echo '   string \"color-scheme\"'; echo '   variant    uint32 1'\n"
               "echo '   string \"enable-animations\"'; echo '   variant    boolean false'\n");
  {
    PlayedLesson lesson(display(), home(), {kPlayed}, environment());
    ASSERT_TRUE(eventually([&] { return is_dark(lesson.picture()); }));
    lesson.press({"Right"});  // nothing travels: the next step is there at once
    ASSERT_TRUE(lesson.comes_to(1, 2));
    lesson.press({"t"});
    ASSERT_TRUE(eventually([&] { return !is_dark(lesson.picture()); }));
    lesson.close();
    ASSERT_TRUE(lesson.process().wait());
  }
  const std::string kept = text_of(home().state() / "preferences.json");
  EXPECT_NE(kept.find("\"own_theme\": true"), std::string::npos) << kept;
  EXPECT_NE(kept.find("\"reduced_motion\": true"), std::string::npos) << kept;
  EXPECT_NE(kept.find("\"own_motion\": false"), std::string::npos) << kept;
  PlayedLesson again(display(), home(), {kPlayed}, environment());
  again.press({"Right"});
  again.picture_at_rest();
  EXPECT_FALSE(is_dark(again.picture()));
}

TEST_F(Desktop, HasAVoiceThatReadsTheStepAndStops) {
  const std::filesystem::path said = home().folder / "said";
  make_program("spd-say", "printf '%s\\n' \"$*\" >> '" + said.string() +
                              "'\ncase \"$*\" in *--wait*) exec sleep 60;; esac\n");
  PlayedLesson lesson(display(), home(), {kPlayed}, environment());
  const auto has = [&](const std::string& words) {
    return eventually([&] { return text_of(said).find(words) != std::string::npos; });
  };
  lesson.press({"w"});
  EXPECT_TRUE(has("--wait --application-name polhode --language en -- "));
  lesson.press({"w"});
  EXPECT_TRUE(has("--cancel"));
}

}  // namespace
}  // namespace polhode::window_test
