// SPDX-License-Identifier: MIT
#include "app/page/live_numbers.h"

#include "app/narration/still_numbers.h"
#include "lessons/claims/live_claims.h"
#include "lessons/reader/checks/lesson_check.h"
#include "render/typeset/paragraph.h"
#include "tests/app/page/sheet_checks.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace polhode {
namespace {

constexpr const char* kTop = R"(+++
format = 1
id = "top"
title = "Top"
[body.spun]
moments = [1.5, 1.5, 2]
[scene]
body = "spun"
omega = [0, 0, 3]
torque = "body:0,0,2"
duration = 40
+++
# A {a}
The spin is $\omega_3 = \live[unit={rad/s}]{w3}$, as it was.

| a | b |
|---|--:|
| c | $\live{w3}$ |
```scene
show = ["omega"]
caption = 'Spin $\live[digits=2, unit={rad/s}]{w3}$ now, \$'
```
)";

Lesson lesson_of(const char* text) {
  LessonReading reading = check_lesson(text, "numbers.md");
  if (!reading.lesson) throw std::runtime_error(to_string(reading.diagnostics.front()));
  return std::move(*reading.lesson);
}

const Lesson& top() {
  static const Lesson kRead = lesson_of(kTop);
  return kRead;
}

DisplayList set_alone(const std::string& tex, double size) {
  MathStyle style;
  style.size = size;
  return set_math(parse_math(tex).value(), style, test_fonts()).value();
}

TEST(PageNumbers, ThatStandStillArePutIntoTheFormula) {
  PageNumbers numbers(top(), test_fonts());
  numbers.keep(0, 3.0);
  numbers.keep(1, std::nullopt);
  const auto& prose = std::get<Prose>(top().stages[0].steps[0].blocks[0]);
  TextStyle style;
  DisplayList list = set_text(numbers.put_into(prose.text), style, test_fonts()).value();
  EXPECT_TRUE(numbers.take_rooms(list).empty());
  const Math& formula = prose.text.front().spans.at(1).math;
  MathStyle math;
  math.size = style.size;
  EXPECT_EQ(letters_of(set_math(numbers.put_into(formula), math, test_fonts()).value()),
            letters_of(set_alone("\\omega_3 = 3.00\\,\\text{rad/s}", style.size)));
}

// The room is that of the widest; the number stands at its right end, and nothing behind it moves.
TEST(PageNumbers, ThatRunHaveTheRoomOfTheWidest) {
  PageNumbers numbers(top(), test_fonts());
  numbers.run(0, {3.0, 23.0, -43.0});
  const Math& formula = std::get<Prose>(top().stages[0].steps[0].blocks[0]).text.front().spans.at(1).math;
  MathStyle math;
  math.size = 24;
  DisplayList list = set_math(numbers.put_into(formula), math, test_fonts()).value();
  const double whole = list.width;
  const std::vector<LiveRoom> rooms = numbers.take_rooms(list);
  ASSERT_EQ(rooms.size(), 1u);
  EXPECT_EQ(rooms[0].id, 0);
  EXPECT_NEAR(whole, set_alone("\\omega_3 = -43.0\\,\\text{rad/s}", 24).width, 1e-9);
  const double kGrid = 1e-3 * math.size;  // glyphs are set on their own grid
  EXPECT_NEAR(rooms[0].width, set_alone("-43.0", 24).width, kGrid);
  for (const double value : {3.0, 23.0, -43.0, 1e6, -1e9}) {
    const PlacedType number = live_number_in(rooms[0], top().numbers[0], value, Language::en, test_fonts());
    EXPECT_NEAR(number.at.x() + number.list.width, rooms[0].at.x() + rooms[0].width, kGrid) << value;
    EXPECT_LE(number.list.width, rooms[0].width + kGrid) << value;
    EXPECT_EQ(number.at.y(), rooms[0].at.y());
  }
  EXPECT_GT(live_number_in(rooms[0], top().numbers[0], std::nullopt, Language::en, test_fonts()).list.width,
            0)
      << "dots";
}

TEST(PageNumbers, TakeTheirRoomFromTheScenesInterval) {
  const SceneModel model = make_model(*top().stages[0].steps[0].scene, ModelFor::page);
  const auto values = values_over(model, top(), {0});
  // dω3/dt = 1 rad/s² from 3 rad/s on, for 40 s.
  EXPECT_NEAR(*std::min_element(values.at(0).begin(), values.at(0).end()), 3, 1e-6);
  EXPECT_NEAR(*std::max_element(values.at(0).begin(), values.at(0).end()), 43, 1e-6);
}

TEST(Captions, HaveTheirNumbers) {
  const Step& step = top().stages[0].steps[0];
  const SceneModel model = make_model(*step.scene, ModelFor::page);
  EXPECT_EQ(captions_at(top(), step, model, 0).at(0), "Spin ${3.0}\\,\\text{rad/s}$ now, \\$");
  EXPECT_EQ(captions_at(top(), step, model, 9.2).at(0), "Spin ${12}\\,\\text{rad/s}$ now, \\$");
  const LongestNumbers longest = longest_in_captions(top(), step, model);
  EXPECT_EQ(longest.at(2), "3.0");
  EXPECT_EQ(captions_at(top(), step, model, 9.2, longest).at(0),
            "Spin $\\hphantom{3}{12}\\,\\text{rad/s}$ now, \\$");
  EXPECT_EQ(captions_at(top(), step, model, 9.2, longest, CaptionBlanks::behind).at(0),
            "Spin ${12}\\,\\text{rad/s}$ now, \\$$\\hphantom{3}$")
      << "in a window, without a gap";
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
  const ComputedNumber& number = reading.lesson->numbers.at(0);
  const auto page = live_state(make_model(*step.scene, ModelFor::page), 0);
  ASSERT_TRUE(page);
  StillNumbers numbers;
  EXPECT_EQ(numbers.of(*reading.lesson, step).at(0), value_of(number, *page));
  EXPECT_DOUBLE_EQ(numbers.of(*reading.lesson, step).at(0), -5.0);
}

constexpr const char* kTable = R"(+++
format = 1
id = "table"
title = "Table"
[body.spun]
moments = [1.5, 1.5, 2]
[scene]
body = "spun"
omega = [0, 0, 3]
+++
# A {a}
```table
columns = [{ head = "a" }, { of = "w3", digits = 4 }, { of = "body_precession" }]
rows = [
  { head = "x" },
  { head = "y", omega = [0, 0, 1200] },
  { head = "z", omega = [0, 0, -1.25e7] },
  { head = "w", omega = [1, 1, 2.25], torque = "body:0,0,1" },
]
```
```scene
show = ["omega"]
```
)";

std::map<int, std::optional<double>> numbers_of_table(const Lesson& lesson) {
  StillNumbers stills;
  const StillNumbers::Values& values = stills.of(lesson, lesson.stages[0].steps[0]);
  std::map<int, std::optional<double>> all;
  for (int id = 0; id < static_cast<int>(lesson.numbers.size()); ++id) {
    const auto value = values.find(id);
    all[id] = value != values.end() ? std::optional(value->second) : std::nullopt;
  }
  return all;
}

// 3.000, 1200, −1.250·10⁷ and 2.250: what stands before the point ends at the same place.
TEST(PageNumbers, OfATableStandWithTheirPointsBelowEachOther) {
  const Lesson lesson = lesson_of(kTable);
  PageNumbers numbers(lesson, test_fonts());
  for (const auto& [id, value] : numbers_of_table(lesson)) numbers.keep(id, value);
  const auto& prose = std::get<Prose>(lesson.stages[0].steps[0].blocks[0]);
  const TextTable table = numbers.put_into(prose.text).front().table;
  const auto width = [](const Math& math) {
    MathStyle style;
    style.size = 100;
    return set_math(math, style, test_fonts()).value().width;
  };
  const auto width_of = [&](const char* tex) { return width(parse_math(tex).value()); };
  const auto behind = [&](std::size_t row, const char* before) {
    return width(table.rows[row][1].front().math) - width_of(before);
  };
  const double kOnTheGrid = 0.02;  // px: room is written with four digits of an em of 100 px
  const double widest = width_of(".250{\\cdot}10^{7}");
  EXPECT_NEAR(behind(1, "3"), widest, kOnTheGrid);
  EXPECT_NEAR(behind(2, "1200"), widest, kOnTheGrid);
  EXPECT_NEAR(behind(3, "-1"), widest, kOnTheGrid);
  EXPECT_NEAR(behind(4, "2"), widest, kOnTheGrid);
}

// Of a symmetric body under a torque there is no free precession.
TEST(PageNumbers, OfATableThatAreNotDefinedAreDashes) {
  const Lesson lesson = lesson_of(kTable);
  const auto values = numbers_of_table(lesson);
  EXPECT_TRUE(values.at(1));
  ASSERT_FALSE(values.at(7));
  PageNumbers numbers(lesson, test_fonts());
  for (const auto& [id, value] : values) numbers.keep(id, value);
  const auto& prose = std::get<Prose>(lesson.stages[0].steps[0].blocks[0]);
  const TextTable table = numbers.put_into(prose.text).front().table;
  MathStyle style;
  const auto set = [&](const Math& math) { return letters_of(set_math(math, style, test_fonts()).value()); };
  EXPECT_EQ(set(table.rows[4][2].front().math), set(parse_math("\\text{–}").value()));
}

}  // namespace
}  // namespace polhode
