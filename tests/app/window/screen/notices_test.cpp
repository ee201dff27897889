// SPDX-License-Identifier: MIT
#include "app/window/screen/notices.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

/// Of letters that are all 1 wide.
std::string lines(std::string_view text, float width) {
  return on_lines(text, width, [](std::string_view words) { return static_cast<float>(words.size()); });
}

// 2026-11-28: a path was broken in the middle of a name, and in front of its ".png".
TEST(Notices, PathsAreBrokenBehindSlashes) {
  EXPECT_EQ(lines("saved: /home/a/07-poinsot.png", 40), "saved: /home/a/07-poinsot.png");
  EXPECT_EQ(lines("saved: /home/a/07-poinsot.png", 24), "saved:\n/home/a/07-poinsot.png") << "it fits alone";
  EXPECT_EQ(lines("saved: /home/a/07-poinsot.png", 16), "saved: /home/a/\n07-poinsot.png");
  EXPECT_EQ(lines("saved: /home/a/07-poinsot.png", 8), "saved:\n/home/a/\n07-poinsot.png")
      << "a name that has no room stays one";
}

// 2026-11-28: what a key told after some seconds without a frame was gone before it was seen.
TEST(Notices, AreToldFromTheFrameOnThatShowsThem) {
  Notices notices;
  EXPECT_FALSE(notices.seconds_left(0));
  notices.tell("Answer first.");
  EXPECT_TRUE(notices.is_new());
  const double after_a_rest_s = 45;
  notices.begin_frame(after_a_rest_s);
  EXPECT_FALSE(notices.is_new());
  const auto left_s = notices.seconds_left(after_a_rest_s);
  ASSERT_TRUE(left_s);
  EXPECT_GT(*left_s, 3);
  notices.begin_frame(after_a_rest_s + 1);
  EXPECT_NEAR(notices.seconds_left(after_a_rest_s + 1).value_or(0), *left_s - 1, 1e-9);
  EXPECT_FALSE(notices.seconds_left(after_a_rest_s + *left_s));
}

TEST(Notices, WordsAreBrokenAtSpaces) {
  EXPECT_EQ(lines("one two three", 7), "one two\nthree");
  EXPECT_EQ(lines("one\n\ntwo three", 20), "one\n\ntwo three") << "lines stay";
  EXPECT_EQ(lines("", 7), "");
}

}  // namespace
}  // namespace polhode
