// SPDX-License-Identifier: MIT
// Two windows: the audience's, and the speaker's to the right of it.
#include "tests/window/window_test.h"

namespace polhode::window_test {
namespace {

/// Of the audience's window, and of the page in the speaker's.
constexpr Point kAudienceFrom{0, 0}, kAudienceTo{1280, 800};
constexpr Point kSpeakersPageFrom{1292, 44}, kSpeakersPageTo{2024, 500};

class Audience : public testing::Test {
 protected:
  void SetUp() override {
    if (const std::string why = Display::why_not(); !why.empty()) GTEST_SKIP() << why;
    display_ = std::make_unique<Display>(Size{2600, 820});
    lesson_ =
        std::make_unique<PlayedLesson>(*display_, home_, std::vector<std::string>{kPlayed, "--speaker"});
    ASSERT_TRUE(eventually([&] { return display_->windows_of(lesson().process().id()).size() == 2; }));
    lesson().picture_at_rest();
  }
  PlayedLesson& lesson() { return *lesson_; }
  /// Waits until a part of the display differs from what it was.
  bool changes(const Image& before, Point from, Point to) {
    return eventually([&] { return changed_part(before, lesson().picture(), from, to) > 0; });
  }

 private:
  Home home_;
  std::unique_ptr<Display> display_;
  std::unique_ptr<PlayedLesson> lesson_;
};

TEST_F(Audience, SeesWhatItSawWhileTheSpeakerLooksElsewhere) {
  lesson().press({"h"});
  const Image before = lesson().picture_at_rest();
  lesson().press({"Right"});
  ASSERT_TRUE(changes(before, kSpeakersPageFrom, kSpeakersPageTo));
  EXPECT_EQ(changed_part(before, lesson().picture_at_rest(), kAudienceFrom, kAudienceTo), 0);
  EXPECT_TRUE(lesson().comes_to(1, 1)) << "its title, too";
  lesson().press({"h"});
  EXPECT_TRUE(changes(before, kAudienceFrom, kAudienceTo));
  EXPECT_TRUE(lesson().comes_to(1, 2));
}

TEST_F(Audience, SeesWhereTheSpeakerPoints) {
  const Image before = lesson().picture_at_rest();
  lesson().press({"l"});
  lesson().move_to({1280 + 300, 200});
  constexpr Point kFrom{450, 230}, kTo{545, 310};  // the same place of its page
  EXPECT_TRUE(changes(before, kFrom, kTo));
  const Image pointed = lesson().picture_at_rest();
  EXPECT_EQ(changed_part(before, pointed, {0, 0}, {kFrom.x, 800}), 0);
  lesson().press({"l"});
  EXPECT_TRUE(changes(pointed, kFrom, kTo));
  EXPECT_EQ(changed_part(before, lesson().picture_at_rest(), kAudienceFrom, kAudienceTo), 0);
}

// Of both something has to be seen, and what gave way for a talk comes back.
TEST(OneScreen, NeitherWindowHidesTheOther) {
  if (const std::string why = Display::why_not(); !why.empty()) GTEST_SKIP() << why;
  for (const Size& size : {Size{1366, 768}, Size{1920, 1080}}) {
    const Home home;
    const Display display(size);
    PlayedLesson lesson(display, home, {kPlayed});
    const Box before = display.box_of(lesson.window());
    lesson.press({"n"});
    const pid_t process = lesson.process().id();
    ASSERT_TRUE(eventually([&] { return display.windows_of(process).size() == 2; }));
    const auto is_clear = [&] {
      const std::vector<unsigned> both = display.windows_of(process);
      const Box a = display.box_of(both[0]), b = display.box_of(both[1]);
      return a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y || b.y + b.height <= a.y;
    };
    EXPECT_TRUE(eventually(is_clear)) << size.width;
    for (const unsigned window : display.windows_of(process)) {
      const Box box = display.box_of(window);
      EXPECT_TRUE(box.x >= 0 && box.y >= 0 && box.x + box.width <= size.width &&
                  box.y + box.height <= size.height)
          << size.width;
    }
    lesson.press({"n"});
    ASSERT_TRUE(eventually([&] { return display.windows_of(process).size() == 1; }));
    EXPECT_TRUE(eventually([&] { return display.box_of(lesson.window()) == before; })) << size.width;
  }
}

}  // namespace
}  // namespace polhode::window_test
