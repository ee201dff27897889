// SPDX-License-Identifier: MIT
#include "app/session/saved/window_size.h"

#include "tests/app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

TEST(WindowSize, IsKept) {
  const ScratchFolder scratch;
  EXPECT_EQ(*read_window_size(scratch.path()), Size{}) << "nothing is known";
  ASSERT_TRUE(write_window_size(scratch.path(), {1000, 700}));
  EXPECT_EQ(*read_window_size(scratch.path()), (Size{1000, 700}));
}

TEST(WindowSize, OfADamagedFileIsNotKnown) {
  const ScratchFolder scratch;
  for (const char* text : {"", "{", R"({"format":1,"width":"wide","height":2})", R"({"format":1})"}) {
    write_text(scratch / "window.json", text);
    EXPECT_EQ(*read_window_size(scratch.path()), Size{}) << text;
  }
  write_text(scratch / "window.json", R"({"format":1,"width":2000000000,"height":-5})");
  const Size size = *read_window_size(scratch.path());
  EXPECT_LT(size.width, 20000);
  EXPECT_GE(size.height, 0);
}

}  // namespace
}  // namespace polhode
