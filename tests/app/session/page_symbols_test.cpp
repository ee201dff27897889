// SPDX-License-Identifier: MIT
#include "app/session/page_symbols.h"

#include "app/cli/lesson_lookup.h"
#include "app/cli/or_fail.h"
#include "app/page/page.h"
#include "render/typeset/paragraph.h"
#include "tests/app/page/sheet_checks.h"
#include "tests/support/paths.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>

namespace polhode {
namespace {

MathSymbol symbol(const std::string& name, const std::string& tex) {
  return {name, parse_math(tex).value(), color_from_hex(0xB04A00)};
}

const std::vector<MathSymbol>& symbols() {
  static const std::vector<MathSymbol> kSymbols = {symbol("omega", "\\vec\\omega"), symbol("L", "\\vec L"),
                                                   symbol("T", "T"), symbol("bar", "\\frac{a}{b}")};
  return kSymbols;
}

PlacedType formula(const std::string& tex, const Vec2& at = {100, 200}) {
  MathStyle style;
  style.size = 30;
  style.display = true;
  style.symbols = &symbols();
  return {.list = set_math(parse_math(tex).value(), style, test_fonts()).value(), .at = at};
}

Sheet sheet_of(std::vector<PlacedType> texts) {
  Sheet sheet;
  sheet.texts = std::move(texts);
  return sheet;
}

std::vector<PageSymbol> found_in(const std::string& tex) {
  return symbols_on(sheet_of({formula(tex)}), test_fonts());
}

std::vector<std::string> names_of(const std::vector<PageSymbol>& found) {
  std::vector<std::string> names;
  for (const PageSymbol& symbol : found) names.push_back(symbol.name);
  return names;
}

TEST(PageSymbols, ComeInReadingOrderEachOccurrenceApart) {
  const auto found = found_in("2T = \\vec\\omega\\cdot\\vec L - \\frac{\\vec L}{\\vec\\omega}");
  EXPECT_THAT(names_of(found), testing::ElementsAre("T", "omega", "L", "L", "omega"));
  for (const PageSymbol& symbol : found) EXPECT_FALSE(symbol.is_term);
  EXPECT_LT(found[1].box.x1, found[2].box.x0);
  EXPECT_LT(found[3].box.y1, found[4].box.y0);
}

TEST(PageSymbols, HaveAllTheInkOfTheirParts) {
  const PlacedType text = formula("\\vec\\omega");
  const auto found = symbols_on(sheet_of({text}), test_fonts());
  ASSERT_EQ(found.size(), 1u) << "letter and arrow are one";
  const PixelBox ink = box_of(text);
  EXPECT_DOUBLE_EQ(found[0].box.x0, ink.x0);
  EXPECT_DOUBLE_EQ(found[0].box.y0, ink.y0);
  EXPECT_DOUBLE_EQ(found[0].box.x1, ink.x1);
  EXPECT_DOUBLE_EQ(found[0].box.y1, ink.y1);
}

TEST(PageSymbols, HaveTheirRules) {
  const PlacedType text = formula("\\frac{a}{b}");
  const auto found = symbols_on(sheet_of({text}), test_fonts());
  ASSERT_EQ(found.size(), 1u);
  ASSERT_EQ(text.list.rules.size(), 1u);
  EXPECT_LE(found[0].box.x0, text.at.x() + text.list.rules[0].x0);
  EXPECT_GE(found[0].box.x1, text.at.x() + text.list.rules[0].x1);
}

TEST(PageSymbols, AreInTermsThatComeBeforeThem) {
  const auto found = found_in("a + \\term{turn}{\\vec\\omega\\times\\vec L} = b");
  ASSERT_THAT(names_of(found), testing::ElementsAre("turn", "omega", "L"));
  EXPECT_TRUE(found[0].is_term);
  for (std::size_t i : {1u, 2u}) {
    EXPECT_FALSE(found[i].is_term);
    EXPECT_LE(found[0].box.x0, found[i].box.x0);
    EXPECT_GE(found[0].box.x1, found[i].box.x1);
  }
}

TEST(PageSymbols, OfSeveralTextsAreInTheOrderOfTheTexts) {
  const Sheet sheet = sheet_of({formula("T", {300, 400}), formula("\\vec L", {0, 40})});
  const auto found = symbols_on(sheet, test_fonts());
  EXPECT_THAT(names_of(found), testing::ElementsAre("T", "L"));
  EXPECT_GT(found[0].box.x0, 300);
  EXPECT_LT(found[1].box.x0, 40);
}

TEST(PageSymbols, AtAPointIsTheInnermost) {
  const auto found = found_in("\\term{turn}{\\vec\\omega\\times\\vec L}");
  const auto middle = [](const TypeBox& b) { return Vec2(0.5 * (b.x0 + b.x1), 0.5 * (b.y0 + b.y1)); };
  EXPECT_EQ(symbol_at(found, middle(found[1].box), 4), 1u);
  EXPECT_EQ(symbol_at(found, middle(found[2].box), 4), 2u);
  EXPECT_EQ(symbol_at(found, middle(found[0].box), 0), 0u) << "the cross is of the term alone";
  const Vec2 left(found[1].box.x0 - 3, found[1].box.y1);
  EXPECT_EQ(symbol_at(found, left, 2), std::nullopt);
  EXPECT_EQ(symbol_at(found, left, 4), 1u);
  EXPECT_EQ(symbol_at({}, left, 4), std::nullopt);
}

TEST(PageSymbols, UnderThePointComesBeforeASmallerOneNearIt) {
  const std::vector<PageSymbol> found = {{"a", false, {0, 0, 40, 40}}, {"b", false, {44, 0, 50, 40}}};
  EXPECT_EQ(symbol_at(found, {39, 20}, 8), 0u);
  EXPECT_EQ(symbol_at(found, {43, 20}, 8), 1u) << "the smaller of two that are near";
}

TEST(PageSymbols, MarksLieBehindAllOfTheNameAndARingRoundOne) {
  const auto found = found_in("\\vec L + T = 2\\vec L");
  const Color mark = color_from_hex(0xF0C27A), ring = color_from_hex(0x005F99);
  const auto shapes = marks_of(found, "L", 1, mark, ring, 30);
  ASSERT_EQ(shapes.size(), 3u);
  for (std::size_t i : {0u, 1u}) {
    ASSERT_TRUE(std::holds_alternative<Area>(shapes[i]));
    EXPECT_EQ(color_of(shapes[i]), mark);
    const TypeBox& ink = found[2 * i].box;
    EXPECT_TRUE(is_within({ink.x0, ink.y0, ink.x1, ink.y1}, box_of(shapes[i])));
    EXPECT_LT(box_of(shapes[i]).x1 - ink.x1, 0.5 * 30) << "no further than between letters";
  }
  ASSERT_TRUE(std::holds_alternative<Stroke>(shapes[2]));
  const Stroke& around = std::get<Stroke>(shapes[2]);
  EXPECT_EQ(around.color, ring);
  EXPECT_EQ(around.points.front(), around.points.back());
  const TypeBox& ink = found[1].box;
  EXPECT_TRUE(is_within({ink.x0, ink.y0, ink.x1, ink.y1}, box_of(shapes[2]).grown(-around.width)));

  EXPECT_TRUE(marks_of(found, "", std::nullopt, mark, ring, 30).empty());
  EXPECT_TRUE(marks_of(found, "q", 7, mark, ring, 30).empty());
}

const Lesson& lecture() {
  static const Lesson kLesson =
      or_fail(load_lesson((test::source_dir() / "lessons/euler-equations.md").string())).lesson;
  return kLesson;
}

Page page_of(const Stage& stage, std::size_t step) {
  return compose_page(
             {.lesson = lecture(), .stage = stage, .step = static_cast<int>(step), .size = {1280, 800}},
             test_fonts())
      .value();
}

/// Whether the lesson speaks of it somewhere else than where it is defined: in a mark, which is seen as an
/// arrow and may have no name, or in a claim that stands below a formula.
bool is_used(const std::string& name) {
  const std::string& source = lecture().source;
  const std::regex word("\\b" + name + "\\b");
  return std::distance(std::sregex_iterator(source.begin(), source.end(), word), std::sregex_iterator()) > 1;
}

TEST(PageSymbols, OfTheLectureAreOfItsLesson) {
  std::set<std::string> seen;
  for (const Stage& stage : lecture().stages)
    for (std::size_t step = 1; step <= stage.steps.size(); ++step)
      for (const PageSymbol& symbol : symbols_on(page_of(stage, step).sheet, test_fonts())) {
        EXPECT_FALSE(symbol.box.empty());
        EXPECT_TRUE(symbol.is_term || lecture().symbols.contains(symbol.name)) << symbol.name;
        seen.insert(symbol.name);
      }
  for (const auto& [name, symbol] : lecture().symbols)
    EXPECT_TRUE(seen.contains(name) || is_used(name)) << name << " is defined, and used on no page";
}

TEST(PageSymbols, OfALinkThatIsBrokenAreItsPartsOnEachLine) {
  TextBlock block;
  TextSpan words, link;
  words.text = "Words before ";
  link.text = "the words of a link that is longer than a line of this text";
  link.link = "#stage";
  block.spans = {words, link};
  TextStyle style;
  style.size = 20;
  style.width = 300;
  const auto found = symbols_on(
      sheet_of({{.list = set_text({block}, style, test_fonts()).value(), .at = {50, 50}}}), test_fonts());
  ASSERT_GE(found.size(), 2u);
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].name, "#stage");
    EXPECT_TRUE(found[i].is_term);
    EXPECT_LT(found[i].box.y1 - found[i].box.y0, 1.2 * style.size);
    if (i > 0) {
      EXPECT_GT(found[i].box.y0, found[i - 1].box.y1);
    }
  }
  EXPECT_GT(found[0].box.x0, found[1].box.x0) << "it begins in the middle of a line";
}

}  // namespace
}  // namespace polhode
