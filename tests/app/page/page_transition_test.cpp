// SPDX-License-Identifier: MIT
#include "app/page/page_transition.h"

#include "lessons/reader/checks/lesson_check.h"
#include "tests/app/page/sheet_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace polhode {
namespace {

Lesson lesson_of(const std::string& body) {
  LessonReading reading =
      check_lesson("+++\nformat = 1\nid = \"page\"\ntitle = \"Pages\"\n+++\n" + body, "page.md");
  if (!reading.lesson) throw std::runtime_error(to_string(reading.diagnostics.front()));
  return std::move(*reading.lesson);
}

constexpr const char* kDerivation = R"(# A stage {one}
First some words before the line.

```math sum
a = b + c + x
```
Words after it.

---
Put one thing for another.

```math product
a = b\,d + x
```
---
Only words on this step, which is one between two lines.

---
And once more.

```math quotient
a - x = \frac{b}{e}
```
)";

/// Two pages, one after the other, and the way between them.
class Pages {
 public:
  explicit Pages(const Lesson& lesson, int step = 2, Size size = {800, 600})
      : lesson_(lesson),
        step_(step),
        size_(size),
        from_(text_of_page(request(step - 1), test_fonts()).value()) {}

  PageRequest request(int step) const {
    return {.lesson = lesson_, .stage = lesson_.stages[0], .step = step, .size = size_};
  }
  Sheet before() const { return compose_page(request(step_ - 1), test_fonts()).value().sheet; }
  Sheet after() const { return compose_page(request(step_), test_fonts()).value().sheet; }
  Sheet at(double progress) const {
    PageRequest moving = request(step_);
    moving.entrance = TurningInto{&from_, progress};
    return compose_page(moving, test_fonts()).value().sheet;
  }
  Sheet fading_at(double progress) const {
    PageRequest fading = request(step_);
    fading.entrance = TurningInto{nullptr, progress};
    return compose_page(fading, test_fonts()).value().sheet;
  }

 private:
  const Lesson& lesson_;
  int step_;
  Size size_;
  FittedText from_;
};

/// Of what can be seen: face, glyph and size, and where it stands, to a hundredth of a pixel.
using Seen = std::set<std::tuple<Face, std::uint32_t, long, long, long>>;
Seen seen_on(const Sheet& sheet) {
  Seen seen;
  const auto hundredths = [](double x) { return std::lround(100 * x); };
  for (const PlacedType& text : sheet.texts)
    for (const Glyph& g : text.list.glyphs)
      if (g.color.a > 0)
        seen.emplace(g.face, g.id, hundredths(g.size), hundredths(text.at.x() + g.x),
                     hundredths(text.at.y() + g.y));
  return seen;
}

TEST(PageTravel, EndsOnThePageItself) {
  const Lesson lesson = lesson_of(kDerivation);
  for (int step = 2; step <= 4; ++step) {
    const Pages pages(lesson, step);
    for (const double progress : {1.0, 1.5}) EXPECT_TRUE(same(pages.at(progress), pages.after())) << step;
    EXPECT_TRUE(same(pages.fading_at(1.0), pages.after()));
    EXPECT_EQ(seen_on(pages.at(0.999999)), seen_on(pages.after())) << "nor is there a jump just before";
  }
}

TEST(PageTravel, BeginsAsThePageBefore) {
  const Lesson lesson = lesson_of(kDerivation);
  for (int step = 2; step <= 4; ++step) {
    const Pages pages(lesson, step);
    EXPECT_EQ(seen_on(pages.at(0.0)), seen_on(pages.before())) << step;
    EXPECT_TRUE(same(pages.at(-1.0), pages.at(0.0)));
    const auto panels = [](const Sheet& sheet) { return areas_of(sheet, colors_of(Theme::paper).panel); };
    const auto before = panels(pages.before()), first = panels(pages.at(0.0));
    ASSERT_GE(first.size(), before.size());
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(first[i].y0, before[i].y0);
  }
}

/// y of the first glyph of the last text with so many letters: of the equation in focus.
double y_of(const Sheet& sheet, std::size_t index_from_end) {
  const PlacedType& text = sheet.texts.at(sheet.texts.size() - index_from_end);
  return text.at.y() + text.list.glyphs.at(0).y;
}

TEST(PageTravel, TakesTheEquationInFocusFromOneToTheNext) {
  const Lesson lesson = lesson_of(kDerivation);
  const Pages pages(lesson);
  const double first = y_of(pages.before(), 2), last = y_of(pages.after(), 1);
  ASSERT_LT(first + 20, last);
  double y = first;
  for (const double progress : {0.2, 0.4, 0.6, 0.8}) {
    const Sheet sheet = pages.at(progress);
    const double now = y_of(sheet, 1);
    EXPECT_GT(now, y) << "always on";
    EXPECT_LT(now, last);
    EXPECT_TRUE(sheet.texts.back().moving);
    y = now;
  }
  EXPECT_NEAR(y_of(pages.at(0.5), 1), 0.5 * (first + last), 1e-9 * last) << "half way at half time";
}

TEST(PageTravel, GoesOnFromTheLastEquationOverAStepOfWords) {
  const Lesson lesson = lesson_of(kDerivation);
  const Pages pages(lesson, 4);
  const Sheet half = pages.at(0.5), after = pages.after();
  EXPECT_LT(y_of(half, 1), y_of(after, 1) - 20) << "on its way from the equation two steps before";
}

TEST(PageTravel, BringsWhatIsNewOnlyWhenThereIsRoom) {
  const Lesson lesson = lesson_of(kDerivation);
  const Pages pages(lesson);
  const auto least_alpha = [](const Sheet& sheet) {
    float least = 1;
    for (const PlacedType& text : sheet.texts)
      for (const Glyph& glyph : text.list.glyphs) least = std::min(least, glyph.color.a);
    return least;
  };
  EXPECT_EQ(appeared(0.0), 0.0);
  EXPECT_EQ(appeared(0.4), 0.0);
  EXPECT_EQ(appeared(1.0), 1.0);
  EXPECT_LT(appeared(0.6), appeared(0.8));
  EXPECT_NEAR(least_alpha(pages.fading_at(0.8)), appeared(0.8), 1e-6);
  EXPECT_EQ(pages.fading_at(0.8).texts.size(), pages.after().texts.size());
}

/// So many lines on the second step that all is there, in smaller type than on the first.
Lesson lesson_with_smaller_type() {
  for (int lines = 1; lines < 30; ++lines) {
    std::string text = "# A stage {one}\n";
    for (int i = 0; i < 4; ++i)
      text +=
          "Some words that fill a line of the column and then some more of the line below it, all in "
          "all.\n\n";
    text += "---\n";
    for (int i = 0; i < lines; ++i) text += "Other words.\n\n";
    Lesson lesson = lesson_of(text);
    const FittedText fitted =
        text_of_page({.lesson = lesson, .stage = lesson.stages[0], .step = 2, .size = {640, 480}},
                     test_fonts())
            .value();
    if (fitted.scale < 1 && fitted.whole_from == 1) return lesson;
  }
  throw std::runtime_error("there is none");
}

TEST(PageTravel, NeverCarriesAWordAcrossLines) {
  const Lesson lesson = lesson_with_smaller_type();
  const Pages pages(lesson, 2, {640, 480});
  const auto words = [](const Sheet& sheet) {
    return sheet.texts.at(2).list.glyphs;
  };                          // after header and title
  std::vector<double> lines;  // in em
  for (const Glyph& glyph : words(pages.before())) lines.push_back(glyph.y / glyph.size);
  std::size_t shown = 0, gone = 0;
  for (const Glyph& glyph : words(pages.at(0.5))) {
    EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [&](double line) {
      return std::abs(line - glyph.y / glyph.size) < 0.1;  // lines stand on whole pixels
    })) << "between lines";
    ++(glyph.color.a > 0.5F ? shown : gone);
  }
  EXPECT_GT(shown, 100u);
  EXPECT_GT(gone, 0u) << "or nothing changes lines, and this shows nothing";
}

TEST(PageTravel, KeepsNamesOfSymbols) {
  const Lesson lesson = lesson_of(
      "# A stage {one}\n```math a\n\\term{left}{b} + c = d\n```\n\n---\n```math b\nc = d - "
      "\\term{left}{b}\n```\n");
  const Sheet half = Pages(lesson).at(0.5);
  for (const PlacedType& text : half.texts)
    for (const Glyph& glyph : text.list.glyphs)
      EXPECT_LT(glyph.naming.term, static_cast<int>(text.list.names.size()));
}

// 2026-11-28: the flying line was illegible where it crossed others.
TEST(PageTravel, WhatTheEquationFliesOverStepsBack) {
  const Lesson lesson = lesson_of(kDerivation);
  const Pages pages(lesson);
  const Sheet before = pages.before();
  const auto same_letters = [](const PlacedType& a, const PlacedType& b) {
    return std::ranges::equal(a.list.glyphs, b.list.glyphs, {}, &Glyph::id, &Glyph::id);
  };
  const auto flown_over = [&](const Sheet& sheet) {  // the last text of the page before
    const auto text = std::ranges::find_if(
        sheet.texts, [&](const PlacedType& one) { return same_letters(one, before.texts.back()); });
    return text == sheet.texts.end() ? -1.0F : text->list.glyphs.front().color.a;
  };
  EXPECT_NEAR(flown_over(before), 1.0F, 1e-6);
  EXPECT_NEAR(flown_over(pages.at(0.0)), 1.0F, 1e-6);
  EXPECT_NEAR(flown_over(pages.at(0.5)), 0.15F, 0.01F);
  EXPECT_NEAR(flown_over(pages.at(1.0)), 1.0F, 1e-6);
  EXPECT_NEAR(pages.at(0.5).texts.back().list.glyphs.front().color.a, 1.0F, 1e-6) << "which itself is seen";
}

}  // namespace
}  // namespace polhode
