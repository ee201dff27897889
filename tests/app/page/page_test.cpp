// SPDX-License-Identifier: MIT
#include "app/page/page.h"

#include "app/cli/lesson_lookup.h"
#include "app/cli/or_fail.h"
#include "app/narration/still_numbers.h"
#include "app/page/text/page_text.h"
#include "app/page/text/text_column.h"
#include "lessons/reader/checks/lesson_check.h"
#include "render/scene/model/scene_problem.h"
#include "tests/app/page/sheet_checks.h"
#include "tests/support/paths.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace polhode {
namespace {

constexpr Size kSizes[] = {{1920, 1080}, {1024, 768}, {1080, 1920}, {640, 480}, {320, 240}};

const Lesson& lecture() {
  static const Lesson kLesson =
      or_fail(load_lesson((test::source_dir() / "lessons/euler-equations.md").string())).lesson;
  return kLesson;
}

Lesson lesson_of(const std::string& body) {
  const std::string text =
      "+++\nformat = 1\nid = \"page\"\ntitle = \"Pages\"\n[scene]\nbody = \"textbook\"\n"
      "omega = [0.9, 0.4, 1.0]\nviews = [\"space\"]\n+++\n" +
      body;
  LessonReading reading = check_lesson(text, "page.md");
  if (!reading.lesson) throw std::runtime_error(to_string(reading.diagnostics.front()));
  return std::move(*reading.lesson);
}

bool refutes(const Claim& claim) {
  return claim.kind == ClaimKind::is_false || claim.kind == ClaimKind::non_sequitur;
}

/// Wherever in the stage the claim stands.
bool is_refuted(const Stage& stage, const Equation& equation) {
  for (const Step& step : stage.steps)
    for (const Block& block : step.blocks)
      if (const auto* claim = std::get_if<Claim>(&block))
        if (claim->equation == equation.id && refutes(*claim)) return true;
  return false;
}

std::vector<const Equation*> equations_of(const Step& step) {
  std::vector<const Equation*> equations;
  for (const Block& block : step.blocks)
    if (const auto* equation = std::get_if<Equation>(&block)) equations.push_back(equation);
  return equations;
}

/// The texts of a page's column: what begins outside of meters and diagrams.
std::vector<const PlacedType*> column_of(const Page& page) {
  std::vector<const PlacedType*> texts;
  for (const PlacedType& text : page.sheet.texts) {
    const PixelBox begin{text.at.x(), text.at.y(), text.at.x() + 1, text.at.y() + 1};
    const bool is_in_figure =
        page.figure.width() > 0.0 && page.figure.grown(-0.5).overlap(begin) > 0.0;  // plots may stand alone
    if (!is_in_figure && page.meters.overlap(begin) == 0.0) texts.push_back(&text);
  }
  return texts;
}

/// A live number stands in the room that its formula has left for it.
bool stands_in_a_gap_of(const PlacedType& formula, const PlacedType& number) {
  const PixelBox room = box_of(number), all = box_of(formula);
  if (room.x0 < all.x0 || room.x1 > all.x1) return false;
  return std::none_of(formula.list.glyphs.begin(), formula.list.glyphs.end(), [&](const Glyph& glyph) {
    const double x = formula.at.x() + glyph.x, y = formula.at.y() + glyph.y;
    return room.overlap({x, y - 1, x + 0.4 * glyph.size, y}) > 0.0;
  });
}

/// Those of the page's step, and of the steps before: of another motion as they were at its still.
PageNumbers numbers_at(const PageRequest& request) {
  PageNumbers numbers(request.lesson, test_fonts());
  const auto live = request.model ? live_state(*request.model, request.t_s) : std::nullopt;
  const Step& present = request.stage.steps[static_cast<std::size_t>(request.step - 1)];
  StillNumbers stills;
  for (int i = 0; i < request.step; ++i) {
    const Step& step = request.stage.steps[static_cast<std::size_t>(i)];
    const bool is_of_page =
        &step == &present || !step.scene || !present.scene || same_motion(*step.scene, *present.scene);
    for (const int id : numbers_in(step)) {
      const ComputedNumber& number = request.lesson.numbers[static_cast<std::size_t>(id)];
      // Those of tables are of motions of their own.
      if (number.row || !is_of_page) {
        const auto& values = stills.of(request.lesson, step);
        if (const auto value = values.find(id); value != values.end()) numbers.keep(id, value->second);
      } else if (live) {
        numbers.keep(id, value_of(number, *live));
      }
    }
  }
  return numbers;
}

/// A page beside what it was asked for, and what it should say.
class Checked {
 public:
  explicit Checked(const PageRequest& request)
      : request_(request),
        page_(compose_page(request, test_fonts()).value()),
        symbols_(symbols_of(request.lesson, request.theme)),
        numbers_(numbers_at(request)),
        column_(page_.column.width(), page_.scale * em(), request.theme, request.profile, symbols_, numbers_,
                test_fonts()) {
    for (const PlacedType* text : column_of(page_)) said_.insert(polhode::letters_of(text->list));
  }

  const Page& page() const { return page_; }
  double em() const { return page_.column.width() / 28.0; }  // kMeasure of app/page/page.cpp
  const Step& present() const { return request_.stage.steps[static_cast<std::size_t>(request_.step - 1)]; }

  void everything_is_on_the_page() const {
    const PixelBox paper{0, 0, static_cast<double>(request_.size.width),
                         static_cast<double>(request_.size.height)};
    for (const PlacedType& text : page_.sheet.texts) EXPECT_TRUE(is_within(box_of(text), paper)) << text.text;
    for (const FlatShape& shape : page_.sheet.shapes) EXPECT_TRUE(is_within(box_of(shape), paper));
    for (const FlatShape& shape : page_.sheet.over_insets) EXPECT_TRUE(is_within(box_of(shape), paper));
    for (const Inset& inset : page_.insets) {
      EXPECT_GT(inset.place.width, 0);
      EXPECT_GT(inset.place.height, 0);
      EXPECT_TRUE(is_within(box_of(inset.place), paper));
    }
  }

  void nothing_reaches_into_another_part() const {
    // The tail of an italic f that begins a line stands out by 0.18 em; the column stands on whole pixels.
    const PixelBox column = page_.column.grown(0.2 * em() + 0.5);
    for (const PlacedType* text : column_of(page_))
      EXPECT_TRUE(is_within(box_of(*text), column)) << place_of(*text);
    if (page_.figure.width() == 0.0) return;
    const PixelBox& figure = page_.figure;
    EXPECT_EQ(figure.overlap(page_.column.grown(em())), 0.0);
    EXPECT_EQ(figure.overlap(page_.meters.grown(-0.5)), 0.0);  // of the two the figure has whole pixels
    EXPECT_EQ(page_.meters.overlap(page_.column.grown(em())), 0.0);
    for (const Inset& inset : page_.insets) EXPECT_TRUE(is_within(box_of(inset.place), figure));
    for (const PlacedType& text : page_.sheet.texts) {
      const PixelBox box = box_of(text);
      EXPECT_TRUE(is_within(box, column) || is_within(box, page_.meters) || is_within(box, figure))
          << place_of(text);
    }
    for (const FlatShape& shape : page_.sheet.shapes)
      EXPECT_TRUE(box_of(shape).overlap(figure) == 0.0 || is_within(box_of(shape), figure.grown(1.0)));
    EXPECT_TRUE(page_.sheet.over_insets.empty());
  }

  void no_two_texts_overlap() const {
    const auto texts = column_of(page_);
    for (std::size_t i = 0; i < texts.size(); ++i)
      for (std::size_t j = i + 1; j < texts.size(); ++j)
        EXPECT_TRUE(box_of(*texts[i]).overlap(box_of(*texts[j])) == 0.0 ||
                    stands_in_a_gap_of(*texts[i], *texts[j]))
            << place_of(*texts[i]) << " and " << place_of(*texts[j]);
  }

  void the_present_step_is_whole() const {
    for (const Letters& letters : letters_of_step(present())) EXPECT_TRUE(said_.contains(letters));
  }

  void accent_is_beside_what_holds() const {
    const auto bars = areas_in_column(colors_of(request_.theme).accent);
    EXPECT_EQ(areas_in_column(colors_of(request_.theme).panel).size(), bars.size());
    // The first with a number, or the first, and those that weigh as much: by a number, or by a claim.
    const auto claims = blocks_of<Claim>(present());
    const auto weight = [&](const Equation& equation) {
      const bool is_claimed = std::any_of(claims.begin(), claims.end(),
                                          [&](const Claim* claim) { return claim->equation == equation.id; });
      return !equation.tag.empty() ? 2 : is_claimed ? 1 : 0;
    };
    std::vector<int> weights;
    for (const Equation* equation : equations_of(present())) {
      if (!is_refuted(request_.stage, *equation)) weights.push_back(weight(*equation));
      if (!is_refuted(request_.stage, *equation)) continue;
      for (const PixelBox& bar : bars) EXPECT_FALSE(stands_beside(*equation, bar)) << equation->id;
    }
    const bool is_numbered = std::find(weights.begin(), weights.end(), 2) != weights.end();
    const int of_focus = is_numbered ? 2 : weights.empty() ? 0 : weights.front();
    EXPECT_EQ(bars.size(), static_cast<std::size_t>(std::count(weights.begin(), weights.end(), of_focus)));
    for (const PixelBox& bar : bars) {
      int beside = 0;
      for (const Equation* equation : equations_of(present())) beside += stands_beside(*equation, bar);
      EXPECT_EQ(beside, 1);
    }
  }

  /// Not without the words that refute it.
  void no_refuted_equation_is_recalled() const {
    for (int i = 0; i + 1 < request_.step; ++i) {
      const Step& step = request_.stage.steps[static_cast<std::size_t>(i)];
      for (const Equation* equation : equations_of(step)) {
        if (!is_refuted(request_.stage, *equation) || !said_.contains(letters_of(*equation))) continue;
        if (present_shows(letters_of(*equation))) continue;
        for (const Letters& letters : letters_of_step(step))
          EXPECT_TRUE(said_.contains(letters)) << equation->id;
      }
    }
  }

  /// Header and title stand on every page.
  bool shows_earlier_steps() const {
    std::size_t of_step = letters_of_step(present()).size();
    return column_of(page_).size() > of_step + 2;
  }

  std::vector<Letters> letters_of_step(const Step& step) const {
    std::vector<Letters> all;
    const auto add = [&](const ColumnPiece& piece) {
      for (const PlacedType& text : piece.sheet.texts) all.push_back(polhode::letters_of(text.list));
    };
    for (const Block& block : step.blocks) {
      if (const auto* e = std::get_if<Equation>(&block))
        add(column_.equation(*e, Focus::none, {}, {}).value());
      if (const auto* p = std::get_if<Prose>(&block)) add(column_.prose(p->text).value());
      if (const auto* c = std::get_if<Callout>(&block))
        add(column_.callout(*c, std::string(label_of(request_.lesson, c->kind)), true).value());
      if (const auto* q = std::get_if<Ask>(&block)) add(column_.question(*q).value());
      if (const auto* n = std::get_if<Footnote>(&block)) add(column_.footnote(*n).value());
    }
    return all;
  }

 private:
  std::vector<PixelBox> areas_in_column(const Color& color) const {
    auto areas = areas_of(page_.sheet, color);
    std::erase_if(areas, [&](const PixelBox& area) { return area.overlap(page_.column.grown(em())) == 0.0; });
    return areas;
  }

  static PixelBox box_of(const PixelRect& r) {
    return {static_cast<double>(r.x), static_cast<double>(r.y), static_cast<double>(r.x + r.width),
            static_cast<double>(r.y + r.height)};
  }
  template <class T>
  static PixelBox box_of(const T& part) {
    return polhode::box_of(part);
  }

  static std::string place_of(const PlacedType& text) {
    const PixelBox b = box_of(text);
    return fmt::format("[{:.1f}, {:.1f}] x [{:.1f}, {:.1f}], {} glyphs", b.x0, b.x1, b.y0, b.y1,
                       text.list.glyphs.size());
  }

  Letters letters_of(const Equation& equation) const {
    return polhode::letters_of(
        column_.equation(equation, Focus::none, {}, {}).value().sheet.texts.back().list);
  }

  bool present_shows(const Letters& letters) const {
    const auto equations = equations_of(present());
    return std::any_of(equations.begin(), equations.end(),
                       [&](const Equation* e) { return letters_of(*e) == letters; });
  }

  bool stands_beside(const Equation& equation, const PixelBox& bar) const {
    for (const PlacedType* text : column_of(page_)) {
      const PixelBox box = box_of(*text);
      if (box.y0 >= bar.y0 && box.y1 <= bar.y1 && polhode::letters_of(text->list) == letters_of(equation))
        return true;
    }
    return false;
  }

  PageRequest request_;
  Page page_;
  std::vector<MathSymbol> symbols_;
  PageNumbers numbers_;
  TextColumn column_;
  std::set<Letters> said_;
};

class PagesOfTheLecture : public testing::TestWithParam<std::size_t> {};

TEST_P(PagesOfTheLecture, KeepTheRules) {
  const Stage& stage = lecture().stages[GetParam()];
  for (std::size_t i = 0; i < stage.steps.size(); ++i) {
    const Step& step = stage.steps[i];
    const SceneModel model = step.scene ? make_model(*step.scene, ModelFor::page) : SceneModel();
    for (const Size& size : kSizes) {
      SCOPED_TRACE(fmt::format("step {} at {}x{}", i + 1, size.width, size.height));
      const Checked page({.lesson = lecture(),
                          .stage = stage,
                          .number = static_cast<int>(GetParam()) + 1,
                          .step = static_cast<int>(i) + 1,
                          .model = step.scene ? &model : nullptr,
                          .t_s = step.scene ? step.scene->at_s : 0.0,
                          .size = size,
                          .theme = size.width == 1024 ? Theme::dark : Theme::paper});
      page.everything_is_on_the_page();
      page.nothing_reaches_into_another_part();
      page.no_two_texts_overlap();
      page.the_present_step_is_whole();
      page.accent_is_beside_what_holds();
      page.no_refuted_equation_is_recalled();
      EXPECT_TRUE(page.page().scale >= kLeastScale || !page.shows_earlier_steps());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, PagesOfTheLecture, testing::Range(std::size_t{0}, std::size_t{29}),
                         [](const auto& row) {
                           std::string name = lecture().stages[row.param].id;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(PagesOfTheLecture, AreOfEveryStage) { EXPECT_EQ(lecture().stages.size(), 29u); }

Checked text_page(const Lesson& lesson, int step, Size size = {1024, 768}) {
  return Checked({.lesson = lesson,
                  .stage = lesson.stages[0],
                  .number = 1,
                  .step = step,
                  .model = nullptr,
                  .t_s = 0.0,
                  .size = size,
                  .theme = Theme::paper});
}

constexpr const char* kRefutedThenOther = R"(# A stage {one}
```math wrong
a = b + 1 \tag{1}
```
```claim wrong false
dot(e1, e1) = 2
```
It is wrong.

```math right
c = d
```
)";

TEST(Page, AccentPassesOverARefutedEquationWithANumber) {
  const Lesson lesson = lesson_of(kRefutedThenOther);
  text_page(lesson, 1).accent_is_beside_what_holds();
}

TEST(Page, AccentPassesOverWhatALaterStepRefutes) {
  const Lesson lesson = lesson_of(
      "# A stage {one}\n```math wrong\na = b + 1\n```\nIs it so?\n\n---\nNo.\n\n```claim wrong false\n"
      "dot(e1, e1) = 2\n```\n");
  text_page(lesson, 1).accent_is_beside_what_holds();
}

std::string paragraphs(int n, const std::string& words) {
  std::string text;
  for (int i = 0; i < n; ++i)
    text += words +
            " that fill a line of the column and then some more of the line below it, all in all two.\n\n";
  return text;
}

TEST(Page, WhatALaterStepRefutesIsNotRecalledWithoutItsWords) {
  for (int n = 1; n < 14; ++n) {  // more and more has to go
    const Lesson lesson = lesson_of(
        "# A stage {one}\n```math wrong\na = b + 1\n```\nIs it so?\n\n---\n\n" + paragraphs(3, "Some words") +
        "```claim wrong false\ndot(e1, e1) = 2\n```\n\n---\n\n" + paragraphs(n, "Other words"));
    const Checked page = text_page(lesson, 3);
    page.the_present_step_is_whole();
    page.no_refuted_equation_is_recalled();
  }
}

TEST(Page, EarlierStepsGoBeforeTypeGetsVerySmall) {
  const Lesson lesson = lesson_of("# A stage {one}\n```math first\na = b + 1\n```\n" +
                                  paragraphs(4, "Some words") + "---\n\n" + paragraphs(4, "Other words"));
  const Checked both = text_page(lesson, 2);
  EXPECT_TRUE(both.shows_earlier_steps());
  EXPECT_GE(both.page().scale, kLeastScale);
  both.the_present_step_is_whole();

  const Lesson longer = lesson_of("# A stage {one}\nA word.\n\n---\n\n" + paragraphs(18, "Other words"));
  const Checked alone = text_page(longer, 2);
  EXPECT_LT(alone.page().scale, kLeastScale);
  EXPECT_FALSE(alone.shows_earlier_steps());
  alone.the_present_step_is_whole();
  alone.everything_is_on_the_page();
}

TEST(Page, AStepThatNoPageHoldsIsRefusedWithItsStage) {
  const Lesson lesson = lesson_of("# A stage {too-long}\n" + paragraphs(140, "Some words"));
  for (const Size& size : kSizes) {
    const Result<Page> page =
        compose_page({.lesson = lesson, .stage = lesson.stages[0], .step = 1, .size = size}, test_fonts());
    ASSERT_FALSE(page);
    EXPECT_THAT(page.error(), testing::HasSubstr("\"too-long\""));
    EXPECT_THAT(page.error(), testing::HasSubstr("step 1"));
  }
}

TEST(Page, DependsOnItsRequestAlone) {
  const auto plots = [](const Step& step) { return step.scene && !step.scene->meters.empty(); };
  const auto& stages = lecture().stages;
  const auto stage =
      std::ranges::find_if(stages, [&](const Stage& s) { return std::ranges::any_of(s.steps, plots); });
  ASSERT_NE(stage, stages.end());
  const auto step = std::ranges::find_if(stage->steps, plots);
  const Scene& scene = *step->scene;
  const SceneModel model = make_model(scene, ModelFor::page);
  PageRequest request{.lesson = lecture(),
                      .stage = *stage,
                      .number = 3,
                      .step = static_cast<int>(step - stage->steps.begin()) + 1,
                      .model = &model,
                      .t_s = scene.at_s,
                      .size = {1024, 768},
                      .theme = Theme::paper};
  const Page page = compose_page(request, test_fonts()).value();
  EXPECT_TRUE(same(page.sheet, compose_page(request, test_fonts()).value().sheet));
  const Lesson copy = lecture();
  const Fonts fonts = Fonts::open().value();
  const SceneModel again = make_model(scene, ModelFor::page);
  const PageRequest other{.lesson = copy,
                          .stage = *copy.find_stage(stage->id),
                          .number = request.number,
                          .step = request.step,
                          .model = &again,
                          .t_s = request.t_s,
                          .size = request.size,
                          .theme = request.theme};
  EXPECT_TRUE(same(page.sheet, compose_page(other, fonts).value().sheet));

  const auto changes = [&](auto change) {
    PageRequest changed = request;
    change(changed);
    return !same(page.sheet, compose_page(changed, test_fonts()).value().sheet);
  };
  EXPECT_TRUE(changes([](PageRequest& r) { r.number = 4; }));
  EXPECT_TRUE(changes([](PageRequest& r) { r.counted_as = {1, 2}; }));
  EXPECT_TRUE(changes([](PageRequest& r) { r.t_s += 0.25; }));
  EXPECT_TRUE(changes([](PageRequest& r) { r.theme = Theme::dark; }));
  EXPECT_TRUE(changes([](PageRequest& r) { r.size = {1025, 768}; }));
  EXPECT_TRUE(changes([](PageRequest& r) { r.model = nullptr; }));
}

constexpr const char* kHighlighted = R"(# A stage {one}
```math named
a = \term{left}{b} + \term{right}{c}
```
```scene
highlight = "left"
```

---
More.
```scene
show = ["shape"]
```
)";

TEST(Page, WhatAStepAddsFadesWhereItWillStand) {
  const Lesson lesson = lesson_of("# A stage {one}\nFirst.\n\n---\nSecond.\n\n```math e\na = b\n```\n");
  PageRequest request{.lesson = lesson,
                      .stage = lesson.stages[0],
                      .number = 1,
                      .step = 2,
                      .model = nullptr,
                      .t_s = 0,
                      .size = {800, 600},
                      .theme = Theme::paper};
  const Sheet whole = compose_page(request, test_fonts()).value().sheet;
  const FittedText text = text_of_page(request, test_fonts()).value();
  request.entrance = FadingIn{0.25};
  const Sheet faint = compose_page(request, text, test_fonts()).sheet;
  EXPECT_TRUE(same(faint, compose_page(request, test_fonts()).value().sheet))
      << "the text that is there is another";
  ASSERT_EQ(faint.texts.size(), whole.texts.size());
  int fading = 0;
  for (std::size_t i = 0; i < whole.texts.size(); ++i) {
    EXPECT_EQ(faint.texts[i].at, whole.texts[i].at);
    const float opacity = faint.texts[i].list.glyphs.at(0).color.a / whole.texts[i].list.glyphs.at(0).color.a;
    if (opacity == 1.0F) continue;
    EXPECT_EQ(opacity, 0.25F);
    ++fading;
  }
  EXPECT_EQ(fading, 2) << "the sentence and the equation";
  for (const FlatShape& shape : faint.shapes) EXPECT_EQ(color_of(shape).a, 0.25F) << "panel and bar";
  EXPECT_EQ(faint.shapes.size(), 2u);
}

TEST(Page, InASequenceWhatStandsThereStaysInItsPlace) {
  const Lesson lesson = lesson_of(
      "# A stage {one}\nFirst.\n\n```math e\na = b\n```\nBetween.\n\n---\nThen.\n\n```math f\nc = d\n```\n");
  const auto sheet_of = [&](int step, PageEntrance entrance) {
    return compose_page({.lesson = lesson,
                         .stage = lesson.stages[0],
                         .number = 1,
                         .step = step,
                         .model = nullptr,
                         .t_s = 0,
                         .size = {800, 600},
                         .theme = Theme::paper,
                         .entrance = entrance},
                        test_fonts())
        .value()
        .sheet;
  };
  const Sheet before = sheet_of(1, FadingIn{1.0}), after = sheet_of(2, FadingIn{0.5}),
              alone = sheet_of(2, StandingStill{});
  ASSERT_GT(after.texts.size(), before.texts.size());
  for (std::size_t i = 1; i < before.texts.size(); ++i) {  // 0 tells the step
    EXPECT_EQ(before.texts[i].list, after.texts[i].list);
    EXPECT_EQ(before.texts[i].at, after.texts[i].at);
  }
  EXPECT_EQ(areas_of(after, colors_of(Theme::paper).panel).size(), 0u)
      << "the focus is not there yet, or twice";
  EXPECT_LT(alone.texts.back().at.y(), after.texts.back().at.y()) << "a page by itself needs no such room";
}

TEST(Page, NumbersOfEarlierFormulasStayLive) {
  const Lesson lesson = lesson_of(
      "# A stage {one}\n```math e\na = \\live{2*T}\n```\n\n```scene\nshow = [\"shape\"]\n```\n---\nThen.\n");
  const SceneModel model = make_model(*lesson.stages[0].steps[1].scene, ModelFor::page);
  const auto texts_at = [&](int step, bool runs) {
    const Page page = compose_page({.lesson = lesson,
                                    .stage = lesson.stages[0],
                                    .step = step,
                                    .model = &model,
                                    .size = {1024, 768},
                                    .runs = runs},
                                   test_fonts())
                          .value();
    return column_of(page).size();
  };
  EXPECT_EQ(texts_at(1, true), 4u) << "header, title, formula and its number";
  EXPECT_EQ(texts_at(2, true), 5u) << "and the words of the second step";
  EXPECT_EQ(texts_at(1, false), 3u) << "on a still the number is in the formula";
}

// "T = 2.47 J" does not become the energy of the motion that a later step follows.
TEST(Page, NumbersOfEarlierFormulasStayWhatTheyWereWhereTheMotionIsAnother) {
  const auto number_on_last_page = [](const std::string& later_keys) {
    const Lesson lesson = lesson_of(
        "# A stage {one}\n```math e\na = \\live{2*T}\n```\n\n```scene\nshow = [\"shape\"]\n```\n---\n"
        "Then.\n\n```scene\n" +
        later_keys + "\n```\n");
    const SceneModel model = make_model(*lesson.stages[0].steps[1].scene, ModelFor::page);
    const Page page = compose_page({.lesson = lesson,
                                    .stage = lesson.stages[0],
                                    .step = 2,
                                    .model = &model,
                                    .t_s = 5.0,
                                    .size = {1024, 768}},
                                   test_fonts())
                          .value();
    // Behind header and title.
    return letters_of(column_of(page)[2]->list);
  };
  const std::string two_T = fmt::format("{:.2f}", 0.81 + 1.75 * 0.16 + 2.5);
  const auto expected = letters_of(set_line("$a = " + two_T + "$", {}, test_fonts()));
  EXPECT_EQ(number_on_last_page("show = [\"omega\"]"), expected);
  EXPECT_EQ(number_on_last_page("motion = { method = \"explicit-euler\", step = 0.2 }"), expected);
  EXPECT_EQ(number_on_last_page("omega = [0, 0, 9]"), expected);
}

// Steps that stand whole with their figures have the numbers of their own motions, each at its own time, in
// formulas and beside claims.
TEST(Page, EachStepWithAFigureHasTheNumbersOfItsOwn) {
  const Lesson lesson = lesson_of(
      "# A stage {one}\n```math e free\nT = \\frac12\\vec\\omega\\cdot\\vec L\n```\nHere $T = \\live{T}$.\n\n"
      "```scene\nshow = [\"shape\"]\n```\n---\n"
      "```math f free\n2T = \\vec\\omega\\cdot\\vec L\n```\nThere $T = \\live{T}$.\n\n"
      "```scene\nomega = [0, 0, 2]\n```\n");
  const Stage& stage = lesson.stages[0];
  const SceneModel first = make_model(*stage.steps[0].scene, ModelFor::page),
                   second = make_model(*stage.steps[1].scene, ModelFor::page);
  const std::vector<FiguredStep> before{{1, &first, 0.0}};
  const auto texts = [&](int step, const SceneModel& model,
                         std::optional<std::span<const FiguredStep>> with) {
    const Page page = compose_page({.lesson = lesson,
                                    .stage = stage,
                                    .step = step,
                                    .model = &model,
                                    .before = with,
                                    .size = {1600, 900}},
                                   test_fonts())
                          .value();
    std::set<Letters> letters;
    for (const PlacedType* text : column_of(page)) letters.insert(letters_of(text->list));
    return letters;
  };
  const std::span<const FiguredStep> none;
  const auto together = texts(2, second, before);
  const auto missing = [&](const std::set<Letters>& alone) {
    return std::count_if(alone.begin(), alone.end(),
                         [&](const Letters& one) { return !together.contains(one); });
  };
  const std::set<Letters> one = texts(1, first, none), two = texts(2, second, none);
  EXPECT_EQ(one.size(), 2u + 3u)
      << "header, title, formula, verdict, words; numbers of its sides are for a window";
  EXPECT_EQ(missing(one), 1) << "the header, which tells the step";
  EXPECT_LE(missing(two), 3) << "likewise, and the formula of the step before with its kind";
}

// 2026-11-27: numbers of another identity stood below a matrix, and were read as its columns.
TEST(Page, AClaimInOtherWordsHasNoNumbers) {
  const auto texts_with = [](const std::string& words) {
    const Lesson lesson =
        lesson_of("# A stage {one}\n```math e\n2T = I_1 + I_2\n```\n```claim e identity" + words +
                  "\n2*T = dot(omega, L)\n```\n\n```scene\nshow = [\"shape\"]\n```\n");
    const SceneModel model = make_model(*lesson.stages[0].steps[0].scene, ModelFor::page);
    return column_of(compose_page({.lesson = lesson,
                                   .stage = lesson.stages[0],
                                   .step = 1,
                                   .model = &model,
                                   .size = {1024, 768}},
                                  test_fonts())
                         .value())
        .size();
  };
  EXPECT_EQ(texts_with(" in-other-words") + 1, texts_with(""));
}

TEST(Page, AHighlightedTermIsMarkedBehind) {
  const Lesson lesson = lesson_of(kHighlighted);
  const Checked page = text_page(lesson, 1);
  const auto marks = areas_of(page.page().sheet, colors_of(Theme::paper).marked);
  ASSERT_EQ(marks.size(), 1u);
  int inside = 0;
  for (const PlacedType* text : column_of(page.page()))
    for (const Glyph& glyph : text->list.glyphs) {
      const bool is_left =
          glyph.naming.term >= 0 && text->list.names[static_cast<std::size_t>(glyph.naming.term)] == "left";
      DisplayList one;
      one.glyphs = {glyph};
      const PixelBox box = box_of(PlacedType{.list = one, .at = text->at});
      EXPECT_EQ(is_within(box, marks[0]), is_left);
      inside += is_left;
    }
  EXPECT_EQ(inside, 1);
  // over the panel, or it would not be seen
  const auto& shapes = page.page().sheet.shapes;
  const auto at = [&](const Color& color) {
    return std::find_if(shapes.begin(), shapes.end(),
                        [&](const FlatShape& shape) { return color_of(shape) == color; });
  };
  EXPECT_LT(at(colors_of(Theme::paper).panel), at(colors_of(Theme::paper).marked));
}

TEST(Footnotes, StandBelowAllTextOfThePageInSmallerType) {
  const Lesson lesson =
      lesson_of("# A stage {one}\nFirst[^a].\n\n[^a]: Note a.\n\n---\nSecond[^b].\n\n[^b]: Note b.\n");
  const Checked page = text_page(lesson, 2);
  ASSERT_EQ(page.page().whole_from, 1);
  const std::vector<const PlacedType*> texts = column_of(page.page());
  ASSERT_EQ(texts.size(), 6u) << "header, title, two texts, two notes";
  for (std::size_t i = 1; i < texts.size(); ++i) EXPECT_GT(box_of(*texts[i]).y0, box_of(*texts[i - 1]).y1);
  EXPECT_LT(texts[4]->list.glyphs.back().size, 0.8 * texts[3]->list.glyphs.front().size);
  const auto rules = page.page().sheet.shapes;
  ASSERT_EQ(rules.size(), 1u) << "one line above both";
  EXPECT_GT(box_of(rules[0]).y0, box_of(*texts[3]).y1);
  EXPECT_LT(box_of(rules[0]).y1, box_of(*texts[4]).y0);
}

TEST(Footnotes, ComeAndGoWithTheStepThatTheyBelongTo) {
  const auto page_with = [](int more) {  // words in the second step
    return Lesson(
        lesson_of("# A stage {one}\nFirst[^a].\n\n[^a]: Note a.\n\n---\n" + paragraphs(more, "Some words")));
  };
  int more = 1;
  Lesson lesson = page_with(more);
  while (text_page(lesson, 2).page().whole_from == 1) lesson = page_with(++more);
  EXPECT_GT(more, 1) << "where there is room the first step stays, with its note";
  EXPECT_EQ(text_page(lesson, 2).page().whole_from, 2);
  EXPECT_TRUE(text_page(lesson, 2).page().sheet.shapes.empty());
}

// Numbers of one motion would seem to be those of the next.
TEST(EarlierEquations, WithNumbersStayOnTheirStep) {
  const auto page_with = [](int more) {
    return Lesson(
        lesson_of("# A stage {one}\n```math size\nT = \\live{T}\n```\n```math law\na = b\n```\n\n---\n" +
                  paragraphs(more, "Some words")));
  };
  const auto ids = [](const Page& page) {
    std::vector<std::string> all;
    for (const Equation* equation : page.equations) all.push_back(equation->id);
    return all;
  };
  EXPECT_THAT(ids(text_page(page_with(1), 2).page()), testing::ElementsAre("size", "law")) << "a whole step";
  int more = 1;
  while (text_page(page_with(more), 2).page().whole_from == 1) ++more;
  EXPECT_THAT(ids(text_page(page_with(more), 2).page()), testing::ElementsAre("law"));
}

// A line of a learner's stands below its question with a chip; one that is being typed has none.
TEST(PageOfADerivation, HasTheLinesBelowTheQuestion) {
  const Stage& stage = lecture().stages.at(13);
  const Ask* ask = nullptr;
  int step = 0;
  for (std::size_t i = 0; i < stage.steps.size(); ++i)
    for (const Ask* one : blocks_of<Ask>(stage.steps[i]))
      if (one->derivation) ask = one, step = static_cast<int>(i) + 1;
  ASSERT_NE(ask, nullptr) << stage.id;
  PageRequest request{.lesson = lecture(), .stage = stage, .number = 14, .step = step, .size = {2560, 9000}};
  const auto glyphs = [&] {
    const Page page = compose_page(request, test_fonts()).value();
    std::size_t count = 0;
    for (const PlacedType& text : page.sheet.texts) count += text.list.glyphs.size();
    return count;
  };
  const std::size_t alone = glyphs();
  request.derivation = {ask, {{"T = 1", "", Certainty::stated}}};
  const std::size_t typed = glyphs();
  request.derivation.lines[0] = {"T = 1", "holds", Certainty::proved};
  EXPECT_EQ(typed, alone + 3);
  EXPECT_EQ(glyphs(), typed + 5) << "and the word of the chip";
}

// For documents that have the words themselves.
TEST(PictureOfAStep, IsFigureAndPlotsWithoutWords) {
  const Lesson lesson = lesson_of(
      "# A stage {one}\nWords.\n```scene\nshow = [\"omega\"]\ncaption = \"Caption\"\nmeters = []\n```\n");
  const Lesson plotted = lesson_of(
      "# A stage {one}\nWords.\n```scene\nshow = [\"omega\"]\ncaption = \"Caption\"\nmeters = "
      "[\"energy\"]\n```\n");
  const auto picture = [](const Lesson& of, int width) {
    const Stage& stage = of.stages.front();
    const SceneModel model = make_model(*stage.steps.front().scene, ModelFor::page);
    const Size size = picture_size_of(model, width);
    const PageRequest request{.lesson = of, .stage = stage, .model = &model, .size = size};
    return std::pair(size, compose_picture(request, test_fonts()));
  };
  const auto [size, plain] = picture(lesson, 960);
  const auto [higher, with_plot] = picture(plotted, 960);
  EXPECT_EQ(size.width, 960);
  EXPECT_EQ(plain.insets.size(), 1u);
  EXPECT_GT(higher.height, size.height);
  EXPECT_NEAR(with_plot.figure.height(), size.height, 1) << "the figure is as large as without a plot";
  EXPECT_GT(with_plot.sheet.texts.size(), plain.sheet.texts.size());
  for (const auto& [of, page] : {std::pair(size, &plain), std::pair(higher, &with_plot)})
    for (const PlacedType& text : page->sheet.texts) {
      EXPECT_NE(text.text, "Caption");
      const PixelBox box = box_of(text);
      EXPECT_TRUE(box.x0 >= 0 && box.x1 <= of.width && box.y0 >= 0 && box.y1 <= of.height) << text.text;
    }
  EXPECT_EQ(picture(plotted, 480).first.height, (higher.height + 1) / 2) << "the same at any size";
}

}  // namespace
}  // namespace polhode
