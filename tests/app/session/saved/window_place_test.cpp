// SPDX-License-Identifier: MIT
#include "app/session/saved/window_place.h"

#include "tests/app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

TEST(WindowPlace, IsKept) {
  const ScratchFolder scratch;
  EXPECT_EQ(*read_window_place(scratch.path()), WindowPlace{}) << "nothing is known";
  for (const WindowPlace& place : {WindowPlace{{1000, 700}}, WindowPlace{{1000, 700}, {{-1920, 30}}}}) {
    ASSERT_TRUE(write_window_place(scratch.path(), place));
    EXPECT_EQ(*read_window_place(scratch.path()), place);
  }
}

TEST(WindowPlace, OfADamagedFileIsNotKnown) {
  const ScratchFolder scratch;
  for (const char* text : {"", "{", R"({"format":1,"width":"wide","height":2})", R"({"format":1})",
                           R"({"format":1,"width":900,"height":700,"at":[1,"left"]})"}) {
    write_text(scratch / "window.json", text);
    EXPECT_EQ(*read_window_place(scratch.path()), WindowPlace{}) << text;
  }
  write_text(scratch / "window.json", R"({"format":1,"width":2000000000,"height":-5})");
  const Size size = read_window_place(scratch.path())->size;
  EXPECT_LT(size.width, 20000);
  EXPECT_GE(size.height, 0);
}

// 2026-11-28: one that had stood under a bar, or without a frame, came back with its title bar off the
// screen.
TEST(WindowPlace, HasItsTitleBarOnTheScreen) {
  constexpr std::array<int, 2> kCorner{0, 30}, kFrame{2, 24};
  EXPECT_EQ(with_frame_seen({100, 90}, kCorner, kFrame), (std::array{100, 90})) << "as it was";
  EXPECT_EQ(with_frame_seen({0, 30}, kCorner, kFrame), (std::array{2, 54}));
  EXPECT_EQ(with_frame_seen({-40, 0}, kCorner, kFrame), (std::array{2, 54}));
}

}  // namespace
}  // namespace polhode
