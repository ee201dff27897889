// SPDX-License-Identifier: MIT
#include "app/page/live_numbers.h"

#include "app/page/loaded_lesson.h"
#include "app/page/still_numbers.h"
#include "lessons/claims/live_claims.h"
#include "render/typeset/paragraph.h"
#include "tests/app/page/sheet_checks.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

TEST(LiveNumber, HasThreeDigits) {
  EXPECT_EQ(live_number_text(0), "0");
  EXPECT_EQ(live_number_text(2.4725), "2.47");
  EXPECT_EQ(live_number_text(-5.194), "−5.19");
  EXPECT_EQ(live_number_text(0.76), "0.760");
  EXPECT_EQ(live_number_text(0.01234), "0.0123");
  EXPECT_EQ(live_number_text(0.001234), "1.23${\\cdot}10^{-3}$");
  EXPECT_EQ(live_number_text(181196.5), "1.81${\\cdot}10^{5}$");
  EXPECT_EQ(live_number_text(-6.62607e-34), "−6.63${\\cdot}10^{-34}$");
}

// What is counted in thousands is not cut to one digit.
TEST(LiveNumber, ShowsWholeNumbersUpToFiveDigits) {
  EXPECT_EQ(live_number_text(9999), "9999");
  EXPECT_EQ(live_number_text(10000), "10000");
  EXPECT_EQ(live_number_text(22500), "22500");
}

TEST(LiveNumber, RoundsIntoTheNextDecade) {
  EXPECT_EQ(live_number_text(9.999), "10.0");
  EXPECT_EQ(live_number_text(999.9), "1000");
  EXPECT_EQ(live_number_text(0.009999), "0.0100");
  EXPECT_EQ(live_number_text(999999), "1.00${\\cdot}10^{6}$");
}

TEST(LiveNumber, StaysInItsRoom) {
  const LiveRoom room{.index = 0, .at = {10, 20}, .size = 24, .color = {}};
  TextStyle style;
  style.size = room.size;
  const double width = set_line(std::string(kLiveRoom), style, test_fonts()).width;
  for (const double value : {2.5, -2.5, 0.0123, 22500.0, -22500.0, 181196.5, -6.6e-34}) {
    const PlacedType number = live_number_in(room, value, test_fonts());
    EXPECT_LE(number.list.width, width * (1 + 1e-3)) << value << ": glyphs are set on their own grid";
    EXPECT_EQ(number.at, room.at);
  }
  EXPECT_GT(live_number_in(room, std::nullopt, test_fonts()).list.width, 0) << "dots";
}

// Of the step's own scene as it is: the plane has L point down, against v.
TEST(StillNumbers, AreThoseOfTheStepsOwnPage) {
  const LessonReading reading = check_lesson(R"(+++
format = 1
id = "still"
title = "Still"
+++
# A {a}
```math eq
\live{dot(v, L)}
```
```scene
omega = [0, 0, 2]
velocity = [0, 0, 1]
show = ["plane", "omega"]
```
)",
                                             "still.md");
  ASSERT_TRUE(reading.lesson) << to_string(reading.diagnostics.front());
  const Step& step = reading.lesson->stages[0].steps[0];
  const Expression& number = blocks_of<Equation>(step).front()->live.front();
  const auto page = live_state(make_model(*step.scene, Product::page), 0);
  ASSERT_TRUE(page);
  StillNumbers numbers;
  EXPECT_EQ(numbers.of(step).at(&number), live_number(number, *page));
  EXPECT_DOUBLE_EQ(numbers.of(step).at(&number), -5.0);
}

}  // namespace
}  // namespace polhode
