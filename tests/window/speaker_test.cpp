// SPDX-License-Identifier: MIT
// Two windows, as a speaker has them: notes in one, the page alone in the other. And each key of the help,
// pressed on a real keyboard: on the page and before an audience something is seen to happen.
#include "tests/window/controls.h"
#include "tests/window/window_test.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

namespace polhode::window_test {
namespace {

constexpr Size kWindow{1280, 800};

class Speaker : public testing::Test {
 protected:
  void SetUp() override {
    if (const std::string why = Display::why_not(); !why.empty()) GTEST_SKIP() << why;
    display = std::make_unique<Display>(Size{2 * kWindow.width, kWindow.height});
  }
  std::string lesson_with(const std::string& notes) {
    const std::filesystem::path file = home.folder / "talk.md";
    std::ofstream(file)
        << "+++\nformat = 1\nid = \"talk\"\ntitle = \"Talk\"\n+++\n# One {one}\nText of one.\n"
        << notes << "\n\n---\nMore of it.\n\n# Two {two}\nText of two.\n\n"
        << "```scene\nomega = [0, 1, 0.1]\nshow = [\"shape\", \"omega\"]\n```\n";
    return file.string();
  }
  unsigned window_of_speaker(const PlayedLesson& lesson, pid_t process) {
    unsigned found = 0;
    EXPECT_TRUE(eventually([&] {
      for (const unsigned window : display->windows_of(process))
        if (display->title_of(window) == "polhode — speaker") found = window;
      return found != 0;
    })) << lesson.said();
    return found;
  }

  std::unique_ptr<Display> display;
  Home home;
};

/// The left half is the audience's.
int differing(const Image& a, const Image& b, int from, int to) {
  int count = 0;
  for (int y = 0; y < kWindow.height; ++y)
    for (int x = from; x < to; ++x) {
      const std::uint8_t *p = a.pixel(x, y), *q = b.pixel(x, y);
      count += p[0] != q[0] || p[1] != q[1] || p[2] != q[2];
    }
  return count;
}

TEST_F(Speaker, NotesAreInHisWindowAlone) {
  Image seen[2];
  for (const bool has_notes : {false, true}) {
    PlayedLesson lesson(
        *display, home,
        {lesson_with(has_notes ? "\n> [!notes] Ask them what they expect." : ""), "--speaker"});
    window_of_speaker(lesson, lesson.process().id());
    std::this_thread::sleep_for(std::chrono::seconds(1));  // its clock draws it whenever it likes
    seen[has_notes] = lesson.picture();
    lesson.press({"ctrl+q"});
    EXPECT_EQ(lesson.process().wait(), 0) << lesson.said();
  }
  EXPECT_EQ(differing(seen[0], seen[1], 0, kWindow.width), 0);
  EXPECT_GT(differing(seen[0], seen[1], kWindow.width + 760, 2 * kWindow.width), 200);
}

TEST_F(Speaker, WalksForBothByKeys) {
  PlayedLesson lesson(*display, home, {lesson_with("")});
  lesson.press({"n"});
  const unsigned window = window_of_speaker(lesson, lesson.process().id());
  display->act({"windowfocus", std::to_string(window)});
  lesson.press({"Next"});
  EXPECT_TRUE(lesson.comes_to(1, 2));
  lesson.press({"2", "Return"});
  EXPECT_TRUE(lesson.comes_to(2, 1));
  lesson.press({"period"});
  const auto is_black = [&] {
    const std::uint8_t* pixel = lesson.picture().pixel(kWindow.width / 2, kWindow.height / 2);
    return pixel[0] + pixel[1] + pixel[2] == 0;
  };
  EXPECT_TRUE(eventually(is_black));
  lesson.press({"period"});
  EXPECT_TRUE(eventually([&] { return !is_black(); }));
  lesson.press({"Escape"});
  EXPECT_TRUE(eventually([&] { return display->windows_of(lesson.process().id()).size() == 1; }));
  EXPECT_FALSE(lesson.process().code());
  display->act({"windowfocus", std::to_string(lesson.window())});
  lesson.press({"n"});
  display->ask_to_close(window_of_speaker(lesson, lesson.process().id()));
  EXPECT_TRUE(eventually([&] { return display->windows_of(lesson.process().id()).size() == 1; }));
  EXPECT_FALSE(lesson.process().code()) << "the lesson goes on";
  EXPECT_EQ(lesson.said(), "");
}

struct Pressed {
  const char* key;   ///< as xdotool has it
  const char* back;  ///< what takes it back
};

class PressedKeys : public WindowTest {};

TEST_F(PressedKeys, AreSeenToDoSomething) {
  // Walking, time, body, panels, window: what is seen of each. Copying, saving and quitting have tests of
  // their own.
  const std::vector<Pressed> keys = {{"Right", "Left"},
                                     {"Next", "Prior"},
                                     {"Down", "Up"},
                                     {"ctrl+Next", "ctrl+Prior"},
                                     {"shift+Next", "Up"},
                                     {"End", "Home"},
                                     {"shift+Right", "0"},
                                     {"shift+Left", "0"},
                                     {"shift+Up", "shift+Down"},
                                     {"v", "r"},
                                     {"ctrl+Left", "ctrl+Right"},
                                     {"ctrl+Up", "ctrl+Down"},
                                     {"z", "x"},
                                     {"Tab", "Escape"},
                                     {"shift+Tab", "Escape"},
                                     {"o", "o"},
                                     {"b", "b"},
                                     {"m", "m"},
                                     {"s", "s"},
                                     {"e", "e"},
                                     {"F2", "F2"},
                                     {"F1", "F1"},
                                     {"question", "Escape"},
                                     {"plus", "ctrl+0"},
                                     {"minus", "ctrl+0"},
                                     {"t", "t"},
                                     {"p", "p"},
                                     {"F5", "Escape"}};
  PlayedLesson lesson(display(), home(), {kPlayed});
  for (const bool presenting : {false, true}) {
    if (presenting) lesson.press({"p"});
    for (const Pressed& pressed : keys) {
      const std::string key = pressed.key;
      // Before an audience B is a black screen, the speed is not told, and what ends it is looked at without.
      if (presenting && (key == "b" || key == "shift+Up" || key == "p" || key == "F5")) continue;
      const Image before = lesson.picture_at_rest();
      const TitlePlace was = lesson.place();
      lesson.press({key});
      EXPECT_TRUE(eventually([&] { return lesson.place() != was || lesson.picture().rgba != before.rgba; },
                             std::chrono::seconds(8)))
          << key << (presenting ? " while presenting" : "") << " is dead";
      lesson.picture_at_rest();
      lesson.press({pressed.back});
      ASSERT_TRUE(eventually([&] { return lesson.place().stage == was.stage; })) << key;
    }
  }
  EXPECT_EQ(lesson.said(), "");
}

}  // namespace
}  // namespace polhode::window_test
