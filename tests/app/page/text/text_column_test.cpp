// SPDX-License-Identifier: MIT
#include "app/page/text/text_column.h"

#include "lessons/reader/checks/lesson_check.h"
#include "tests/app/page/sheet_checks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace polhode {
namespace {

constexpr const char* kLesson = R"(+++
format = 1
id = "column"
title = "Columns"
[symbols]
omega = { tex = '\vec\omega', role = "omega" }
+++
# A title with $\vec\omega$ {one}
Prose of some words with $\vec\omega$ in a line, and then enough of others that the line is broken into two or three.

```math tagged
\frac{d\vec L}{dt} = \term{turning}{\vec\omega\times\vec L} + \term{drawn}{\sqrt{\frac{a}{b}}} \tag{12}
```

```math long
a_1 + a_2 + a_3 + a_4 + a_5 + a_6 + a_7 + a_8 + a_9 + a_{10} + a_{11} + a_{12} + a_{13} + a_{14} = b_1 + b_2 + b_3 \tag{13}
```

```math unbroken
\begin{pmatrix} a+b+c+d+e+f & a+b+c+d+e+f & a+b+c+d+e+f & a+b+c+d+e+f & a+b+c+d+e+f \end{pmatrix}
```

> [!said] It turns, and it turns, and it turns, as it was said by those who saw it turn on and on.
> [!meant] It spins.

```ask q
type = "choice"
prompt = "Which one?"
choices = ["the first", "the second, of which there is more to say than there is room on a single line of it", "none"]
answer = 2
hints = ["a hint"]
```
)";

const Lesson& lesson() {
  static const Lesson kRead = [] {
    LessonReading reading = check_lesson(kLesson, "column.md");
    if (!reading.lesson) throw std::runtime_error(to_string(reading.diagnostics.front()));
    return std::move(*reading.lesson);
  }();
  return kRead;
}

template <class T>
std::vector<T> blocks_of() {
  std::vector<T> found;
  for (const Block& block : lesson().stages[0].steps[0].blocks)
    if (const auto* part = std::get_if<T>(&block)) found.push_back(*part);
  return found;
}

struct Sizes {
  double width, em;
};
constexpr Sizes kSizes[] = {{651, 23.25}, {360, 12.857}, {117.3, 4.19}, {1400, 50}, {300, 23.25}};

class Column : public testing::TestWithParam<Sizes> {
 protected:
  double width() const { return GetParam().width; }
  double em() const { return GetParam().em; }
  TextColumn column() const {
    return {width(), em(), Theme::paper, Profile::page, symbols, numbers, test_fonts()};
  }
  const PageColors& colors() const { return colors_of(Theme::paper); }

  std::vector<ColumnPiece> all() const {
    const TextColumn c = column();
    std::vector<ColumnPiece> pieces = {c.title(lesson().stages[0].title_text).value()};
    for (const Prose& prose : blocks_of<Prose>()) pieces.push_back(c.prose(prose.text).value());
    for (const Equation& equation : blocks_of<Equation>()) {
      pieces.push_back(c.equation(equation, Focus::none, {}).value());
      pieces.push_back(c.equation(equation, Focus::now, {"turning"}).value());
      pieces.push_back(c.earlier_equation(equation).value());
    }
    for (const Callout& callout : blocks_of<Callout>())
      pieces.push_back(
          c.callout(callout, std::string(names_of(callout.kind).label.in(Language::en))).value());
    for (const Ask& ask : blocks_of<Ask>()) pieces.push_back(c.question(ask).value());
    return pieces;
  }

  std::vector<MathSymbol> symbols = symbols_of(lesson(), Theme::paper);
  PageNumbers numbers{lesson(), test_fonts()};
};

TEST_P(Column, PiecesKeepToTheirHeightAndTheColumn) {
  // Heights are rounded to whole pixels: ink may stand out by less than one. The tail of an italic f that
  // begins a line stands out by 0.18 em.
  constexpr double kRounding = 1.0, kOverhang = 0.2;
  const std::vector<ColumnPiece> pieces = all();
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    SCOPED_TRACE(i);
    const ColumnPiece& piece = pieces[i];
    EXPECT_EQ(piece.height, std::round(piece.height));
    EXPECT_GT(piece.gap, 0.0);
    const PixelBox room = {-kOverhang * em(), -kRounding, width() + kOverhang * em(),
                           piece.height + kRounding};
    for (const PlacedType& text : piece.sheet.texts) {
      const PixelBox box = box_of(text);
      EXPECT_TRUE(is_within(box, room)) << box.x0 << ' ' << box.y0 << ' ' << box.x1 << ' ' << box.y1 << " in "
                                        << width() << " x " << piece.height;
    }
    for (const FlatShape& shape : piece.sheet.shapes) {
      const PixelBox box = box_of(shape);
      const double out = kRounding + 0.05 * em();  // round ends of bars
      EXPECT_TRUE(is_within(box, {-em(), -out, width() + em(), piece.height + out}));
    }
    for (std::size_t a = 0; a < piece.sheet.texts.size(); ++a)
      for (std::size_t b = a + 1; b < piece.sheet.texts.size(); ++b)
        EXPECT_EQ(box_of(piece.sheet.texts[a]).overlap(box_of(piece.sheet.texts[b])), 0.0);
  }
}

// A formula that is a little too long is set smaller on one line; a longer one is broken at full size.
TEST_P(Column, AFormulaIsBrokenOnlyWhereItWouldBecomeSmall) {
  const TextColumn wide{1e4, em(), Theme::paper, Profile::page, symbols, numbers, test_fonts()};
  Equation equation = blocks_of<Equation>()[0];
  equation.tag.clear();
  const double whole = wide.equation(equation, Focus::none, {}).value().sheet.texts.front().list.width;
  const auto in = [&](double part) {
    const TextColumn column{part * whole, em(), Theme::paper, Profile::page, symbols, numbers, test_fonts()};
    return column.equation(equation, Focus::none, {}).value();
  };
  EXPECT_EQ(in(1.01).formula_scale, 1.0);
  const ColumnPiece smaller = in(0.92), broken = in(0.8);
  constexpr double kHinting = 0.02;  // of widths that are not quite in proportion to the size
  EXPECT_NEAR(smaller.formula_scale, 0.92, kHinting);
  EXPECT_LT(smaller.height, 1.1 * in(1.01).height) << "one line";
  EXPECT_EQ(broken.formula_scale, 1.0);
  EXPECT_GT(broken.height, 1.3 * in(1.01).height) << "two lines";
}

TEST_P(Column, StackedPiecesDoNotOverlap) {
  const std::vector<ColumnPiece> pieces = all();
  std::vector<const ColumnPiece*> refs;
  for (const ColumnPiece& piece : pieces) refs.push_back(&piece);
  const Stack stacked = stack(refs);
  EXPECT_EQ(stacked.height, height_of(refs));
  double least = 0;
  ASSERT_EQ(stacked.pieces.size(), pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    ASSERT_EQ(stacked.pieces[i].sheet.texts.size(), pieces[i].sheet.texts.size());
    double top = 1e9, bottom = -1e9;
    for (std::size_t k = 0; k < pieces[i].sheet.texts.size(); ++k) {
      const PixelBox box = box_of(stacked.pieces[i].sheet.texts[k]);
      top = std::min(top, box.y0);
      bottom = std::max(bottom, box.y1);
    }
    EXPECT_TRUE(i == 0 || top > least) << i;
    least = bottom;
  }
  EXPECT_LE(least, stacked.height + 1.0);
}

TEST_P(Column, ATagStandsAtTheRightEdgeOnTheBaselineOfItsEquation) {
  const auto equations = blocks_of<Equation>();
  const ColumnPiece piece = column().equation(equations[0], Focus::none, {}).value();
  ASSERT_EQ(piece.sheet.texts.size(), 2u);
  EXPECT_EQ(piece.sheet.texts[0].at.y(), piece.sheet.texts[1].at.y());
  EXPECT_NEAR(piece.sheet.texts[0].at.x() + piece.sheet.texts[0].list.width, width(), 0.5);  // whole pixels
  EXPECT_EQ(column().equation(equations[2], Focus::none, {}).value().sheet.texts.size(), 1u);
}

TEST_P(Column, AnEarlierEquationSaysWhatItIsHoweverWideItIs) {
  const EarlierLabel labels[] = {
      {"", "MEASURED", "", "MEASURED"},
      {"The rate of $\\vec L$", "", "", ""},
      {"The title of a step that is long enough for two lines", "always true",
       "given $I_2 = I_1$, $I_3 > I_1$, $\\omega_3 > 0$", "always true, under an assumption"}};
  int in_lines = 0;
  for (const EarlierLabel& label : labels)
    for (const Equation& equation : blocks_of<Equation>()) {
      const ColumnPiece plain = column().earlier_equation(equation).value(),
                        labelled = column().earlier_equation(equation, label).value();
      const std::size_t titles = label.title.empty() ? 0 : 1, kinds = label.word.empty() ? 0 : 1;
      ASSERT_EQ(labelled.sheet.texts.size(), plain.sheet.texts.size() + titles + kinds);
      ASSERT_EQ(*labelled.formula, *plain.formula + titles);
      const PlacedType& formula = labelled.sheet.texts[*labelled.formula];
      EXPECT_GE(labelled.formula_scale, 0.85 * plain.formula_scale) << "kLeastScaleBeside";
      EXPECT_LE(formula.at.y() + formula.list.depth, labelled.height + 1.0) << "heights are whole pixels";
      if (kinds > 0) {
        const PlacedType& kind = labelled.sheet.texts.back();
        EXPECT_GE(kind.at.y() - kind.list.ascent, formula.at.y() + formula.list.depth - 1.0) << "below it";
        EXPECT_LE(kind.at.x() + kind.list.width, width() + 1.0);
        EXPECT_LE(kind.at.y() + kind.list.depth, labelled.height + 1.0);
      }
      if (titles == 0) continue;
      const PlacedType& title = labelled.sheet.texts.front();
      const bool is_beside = title.at.x() + title.list.width < formula.at.x(),
                 is_above = title.at.y() + title.list.depth <= formula.at.y() - formula.list.ascent;
      EXPECT_TRUE(is_beside || is_above);
      EXPECT_LE(title.list.width, width());
      EXPECT_LE(title.at.y() + title.list.depth, labelled.height + 1.0);
      if (!is_beside || title.list.depth < 0.5 * em()) continue;
      ++in_lines;  // the middles of both at one height, to whole pixels
      const auto middle = [](const PlacedType& text) {
        return text.at.y() + 0.5 * (text.list.depth - text.list.ascent);
      };
      EXPECT_NEAR(middle(title), middle(formula), 2.0);
    }
  EXPECT_EQ(in_lines > 0, em() < 0.05 * width()) << "a narrow column has no room for it";
}

TEST_P(Column, FootnotesCountFromThatWhichThePageBeginsWith) {
  const auto text = [](const std::string& mark) {
    TextSpan words, raised;
    words.text = "A word";
    raised.text = mark;
    return RichText{TextBlock{.indent = 0, .marker = {}, .spans = {words, raised}}};
  };
  const TextColumn later = column().with_notes_after(2);
  EXPECT_EQ(later.prose(text("³")).value().sheet.texts[0].list.glyphs,
            column().prose(text("¹")).value().sheet.texts[0].list.glyphs);
  EXPECT_EQ(later.prose(text("m³")).value().sheet.texts[0].list.glyphs,
            column().prose(text("m³")).value().sheet.texts[0].list.glyphs);
  const auto note = [&](int number) { return Footnote{.number = number, .text = text(""), .place = {}}; };
  EXPECT_EQ(later.footnote(note(4)).value().sheet.texts[0].list.glyphs,
            column().footnote(note(2)).value().sheet.texts[0].list.glyphs);
}

TEST_P(Column, OnlyAnEquationInFocusHasPanelAndBar) {
  for (const Equation& equation : blocks_of<Equation>()) {
    const ColumnPiece plain = column().equation(equation, Focus::none, {}).value(),
                      focus = column().equation(equation, Focus::now, {}).value();
    EXPECT_TRUE(plain.sheet.shapes.empty());
    EXPECT_TRUE(column().earlier_equation(equation).value().sheet.shapes.empty());
    const auto panels = areas_of(focus.sheet, colors().panel), bars = areas_of(focus.sheet, colors().accent);
    ASSERT_EQ(panels.size(), 1u);
    ASSERT_EQ(bars.size(), 1u);
    EXPECT_TRUE(is_within(bars[0], panels[0]));
    for (const PlacedType& text : focus.sheet.texts) {
      EXPECT_TRUE(is_within(box_of(text), panels[0]));
      EXPECT_EQ(box_of(text).overlap(bars[0]), 0.0);
    }
    EXPECT_EQ(letters_of(plain.sheet.texts.back().list), letters_of(focus.sheet.texts.back().list));
  }
}

TEST_P(Column, MarksLieBehindTheTermsOfTheirNamesAlone) {
  const Equation equation = blocks_of<Equation>()[0];
  for (const Focus focus : {Focus::none, Focus::now}) {
    EXPECT_TRUE(
        areas_of(column().equation(equation, focus, {"other"}).value().sheet, colors().marked).empty());
    for (const std::string name : {"turning", "drawn"}) {
      const ColumnPiece piece = column().equation(equation, focus, {name}).value();
      const auto marks = areas_of(piece.sheet, colors().marked);
      ASSERT_EQ(marks.size(), 1u);
      const PlacedType& text = piece.sheet.texts.back();
      const auto is_of_term = [&](const Naming& naming) {
        return naming.term >= 0 && text.list.names[static_cast<std::size_t>(naming.term)] == name;
      };
      for (const Glyph& glyph : text.list.glyphs) {
        DisplayList one;
        one.glyphs = {glyph};
        EXPECT_EQ(is_within(box_of(PlacedType{.list = one, .at = text.at}), marks[0]),
                  is_of_term(glyph.naming));
      }
      for (const Rule& rule : text.list.rules) {
        DisplayList one;
        one.rules = {rule};
        EXPECT_TRUE(!is_of_term(rule.naming) ||
                    is_within(box_of(PlacedType{.list = one, .at = text.at}), marks[0]));
      }
    }
    EXPECT_EQ(
        areas_of(column().equation(equation, focus, {"turning", "drawn"}).value().sheet, colors().marked)
            .size(),
        2u);
  }
}

TEST_P(Column, CalloutsAndQuestionsHaveTheirNameAndABarBesideTheirWholeText) {
  std::vector<std::pair<ColumnPiece, Color>> labelled;
  for (const Callout& callout : blocks_of<Callout>())
    labelled.emplace_back(
        column().callout(callout, std::string(names_of(callout.kind).label.in(Language::en))).value(),
        callout.kind == Callout::Kind::said ? colors().said : colors().meant);
  labelled.emplace_back(column().question(blocks_of<Ask>()[0]).value(), colors().question);
  ASSERT_EQ(labelled.size(), 3u);
  for (const auto& [piece, color] : labelled) {
    ASSERT_EQ(piece.sheet.shapes.size(), 1u);
    ASSERT_EQ(piece.sheet.texts.size(), 2u);
    EXPECT_EQ(color_of(piece.sheet.shapes[0]), color);
    const PixelBox bar = box_of(piece.sheet.shapes[0]), name = box_of(piece.sheet.texts[0]),
                   text = box_of(piece.sheet.texts[1]);
    EXPECT_EQ(piece.sheet.texts[0].list.glyphs[0].color, color);
    EXPECT_EQ(piece.sheet.texts[0].at.y(), piece.sheet.texts[1].at.y());
    EXPECT_LT(name.x1, bar.x0);
    EXPECT_LT(bar.x1, text.x0);
    EXPECT_GE(bar.y1 - bar.y0, piece.height - 2.0);
  }
}

TEST_P(Column, ChoicesHaveTheirLetters) {
  const DisplayList list = column().question(blocks_of<Ask>()[0]).value().sheet.texts[1].list;
  for (const char letter : {'A', 'B', 'C'}) {
    const auto glyph = test_fonts().glyph(Face::serif, static_cast<char32_t>(letter));
    EXPECT_TRUE(std::any_of(list.glyphs.begin(), list.glyphs.end(), [&](const Glyph& g) {
      return g.id == glyph;
    })) << letter;
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, Column, testing::ValuesIn(kSizes));

TEST_P(Column, WhatIsClaimedIsBrokenAtItsSignsAndNotSetSmaller) {
  const auto claimed = [&](const std::string& tex) {
    return column().verdict({.claim = nullptr,
                             .certainty = Certainty::proved,
                             .word = "always true",
                             .note = "",
                             .claimed = {tex}},
                            false);
  };
  const std::string term = R"(\left(\hat e_1\cdot \vec A\right)\,\hat e_1 )";
  const ColumnPiece one = claimed(R"(\vec A = \vec B)");
  std::string sum = term;
  for (int i = 0; i < 9; ++i) sum += (i % 2 == 0 ? "+ " : "- ") + term;
  const ColumnPiece many = claimed(sum + R"(= \vec A \Rightarrow {a + b} \ne 0)");
  ASSERT_GT(many.sheet.texts.size(), one.sheet.texts.size());
  // Above the verdict's own word, the last.
  const double size = one.sheet.texts.front().list.glyphs.front().size;
  EXPECT_LT(one.sheet.texts.front().at.y(), one.sheet.texts.back().at.y());
  for (std::size_t i = 0; i + 1 < many.sheet.texts.size(); ++i) {
    const DisplayList& row = many.sheet.texts[i].list;
    EXPECT_LE(row.width, width());
    double largest = 0;
    for (const Glyph& glyph : row.glyphs) largest = std::max(largest, static_cast<double>(glyph.size));
    EXPECT_GE(largest, (1.0 - 1e-6) * size) << i;
  }
}

TEST(TextColumn, ALongEquationIsBrokenBeforeItIsSetSmaller) {
  const std::vector<MathSymbol> none;
  const PageNumbers numbers(lesson(), test_fonts());
  const TextColumn column(651, 23.25, Theme::paper, Profile::page, none, numbers, test_fonts());
  const auto equations = blocks_of<Equation>();
  const auto size_of = [&](const Equation& e) {
    return column.equation(e, Focus::none, {}).value().sheet.texts.back().list.glyphs[0].size;
  };
  EXPECT_EQ(size_of(equations[1]), size_of(equations[0]));
  EXPECT_GT(column.equation(equations[1], Focus::none, {}).value().height, 3 * 23.25);
  EXPECT_LT(size_of(equations[2]), size_of(equations[0]));
}

TEST(TextColumn, WhatTheFontsLackIsRefused) {
  LessonReading reading = check_lesson(
      "+++\nformat = 1\nid = \"c\"\ntitle = \"C\"\n+++\n# A {a}\nA word \xE6\xBC\xA2.\n", "c.md");
  ASSERT_TRUE(reading.lesson);
  const std::vector<MathSymbol> none;
  const PageNumbers numbers(*reading.lesson, test_fonts());
  const TextColumn column(651, 23.25, Theme::paper, Profile::page, none, numbers, test_fonts());
  const auto prose = column.prose(std::get<Prose>(reading.lesson->stages[0].steps[0].blocks[0]).text);
  ASSERT_FALSE(prose);
  EXPECT_THAT(prose.error(), testing::HasSubstr("this text cannot be set"));
}

TEST(Stack, OfNothingIsEmpty) {
  const Stack empty = stack({});
  EXPECT_EQ(empty.height, 0.0);
  EXPECT_TRUE(empty.pieces.empty());
}

TEST(Stack, KeepsTheLargerOfTwoGaps) {
  const ColumnPiece a{.sheet = {}, .height = 10, .gap = 3}, b{.sheet = {}, .height = 20, .gap = 7};
  EXPECT_EQ(stack({&a, &b}).height, 10 + 7 + 20);
  EXPECT_EQ(stack({&b, &a, &a}).height, 20 + 7 + 10 + 3 + 10);
}

TEST_P(Column, LabelsThatAreTooWideForTheirPlaceHaveSeveralLines) {
  Callout callout = blocks_of<Callout>().back();
  const ColumnPiece piece = column().callout(callout, "A label of twenty four c").value();
  const PixelBox bar = box_of(piece.sheet.shapes[0]), name = box_of(piece.sheet.texts[0]);
  EXPECT_LT(name.x1, bar.x0);
  EXPECT_LE(name.y1, piece.height);
  EXPECT_GT(name.y1 - name.y0, 1.5 * piece.sheet.texts[0].list.glyphs[0].size);
}

TEST_P(Column, DerivationsShowTheirTitleAlone) {
  Callout derivation = blocks_of<Callout>().front();
  derivation.kind = Callout::Kind::derivation;
  derivation.title = blocks_of<Callout>().back().text;
  const auto letters = [&](const RichText& text) {
    return letters_of(column().prose(text).value().sheet.texts.front().list);
  };
  const ColumnPiece piece = column().callout(derivation, "Derivation").value();
  EXPECT_EQ(letters_of(piece.sheet.texts.back().list), letters(derivation.title));
}

}  // namespace
}  // namespace polhode
