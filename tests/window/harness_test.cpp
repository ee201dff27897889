// SPDX-License-Identifier: MIT
// What holds the window's tests up is held to its word first.
#include "tests/window/played_lesson.h"

#include <gtest/gtest.h>
#include <signal.h>

namespace polhode::window_test {
namespace {

TEST(Harness, ATitleTellsThePlace) {
  EXPECT_EQ(place_in("No torque — stage 19 of 29, step 2 of 4 — polhode"),
            (TitlePlace{"No torque", 19, 29, 2, 4}));
  EXPECT_EQ(place_in("A — stage 1 — stage 2 of 3, step 1 of 1 — polhode"),
            (TitlePlace{"A — stage 1", 2, 3, 1, 1}));
  EXPECT_EQ(place_in("polhode"), TitlePlace{});
}

TEST(Harness, AChildIsGoneWithItsChildren) {
  const ScratchFolder scratch;
  pid_t grandchild = 0;
  {
    const Child shell({.words = {"sh", "-c", "sleep 1000 & echo $!; wait"}, .out = scratch / "out"});
    ASSERT_TRUE(eventually([&] { return text_of(scratch / "out").ends_with('\n'); }));
    grandchild = std::stoi(text_of(scratch / "out"));
    EXPECT_EQ(kill(grandchild, 0), 0);
  }
  // A zombie of init's, perhaps, but nothing that runs.
  EXPECT_TRUE(eventually([&] {
    const std::string stat = text_of("/proc/" + std::to_string(grandchild) + "/stat");
    return stat.empty() || stat.find(") Z") != std::string::npos;
  }));
}

TEST(Harness, AChildTellsItsEndAndItsTime) {
  Child child({.words = {"sh", "-c", "while :; do :; done"}});
  EXPECT_TRUE(eventually([&] { return child.cpu_s() > 0.05; }));
  EXPECT_FALSE(child.code());
  kill(child.id(), SIGTERM);
  EXPECT_EQ(child.wait(), 128 + SIGTERM);
  EXPECT_EQ(Child({.words = {"sh", "-c", "exit 3"}}).wait(), 3);
}

TEST(Harness, ADisplayIsSeen) {
  if (const std::string why = Display::why_not(); !why.empty()) GTEST_SKIP() << why;
  const Display display({320, 200});
  const Image picture = display.picture();
  EXPECT_EQ(picture.size, (Size{320, 200}));
  EXPECT_TRUE(is_blank(picture));
  EXPECT_FALSE(display.window_of(getpid()));
  EXPECT_THROW(display.act({"no-such-command"}), std::runtime_error);
}

TEST(Harness, ChangesAreCountedInTheirRectangle) {
  const Image a = Image::blank({4, 2});
  Image b = a;
  b.rgba[4 * 3] = 200;  // the last pixel of the first row
  EXPECT_EQ(changed_part(a, b, {2, 0}, {4, 2}), 0.25);
  EXPECT_EQ(changed_part(a, b, {0, 0}, {3, 2}), 0);
}

}  // namespace
}  // namespace polhode::window_test
