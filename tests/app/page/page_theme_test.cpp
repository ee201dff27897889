// SPDX-License-Identifier: MIT
#include "app/page/page_theme.h"

#include "lessons/reader/front_matter/front_matter.h"
#include "lessons/reader/reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

/// Relative luminance and contrast of WCAG 2.1.
double luminance(const Color& c) {
  const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
}
double contrast(const Color& a, const Color& b) {
  const double la = luminance(a), lb = luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

Color over(const Color& top, const Color& under) {
  const auto mixed = [&](float a, float b) { return std::lerp(b, a, top.a); };
  return {mixed(top.r, under.r), mixed(top.g, under.g), mixed(top.b, under.b), 1.0F};
}

class PageTheme : public testing::TestWithParam<Theme> {
 protected:
  const PageColors& colors() const { return colors_of(GetParam()); }

  /// What formulas are set in, with names for messages.
  std::vector<std::pair<std::string, Color>> colors_of_formulas() const {
    std::vector<std::pair<std::string, Color>> all = {{"ink", colors().ink}};
    // The roles that lessons may name: the reader of lessons, which knows no colours, has the list.
    for (const std::string& role : color_roles())
      all.emplace_back(role, on_paper(role_from(role).value().ink, GetParam()));
    return all;
  }
};

TEST_P(PageTheme, TextIsReadableOnThePaper) {
  auto texts = colors_of_formulas();
  texts.insert(texts.end(), {{"quiet", colors().quiet},
                             {"said", colors().said},
                             {"meant", colors().meant},
                             {"question", colors().question}});
  for (const auto& [name, color] : texts) EXPECT_GE(contrast(color, colors().paper), 5.2) << name;
}

TEST_P(PageTheme, FormulasAreReadableOnThePanel) {
  auto texts = colors_of_formulas();
  texts.emplace_back("quiet", colors().quiet);
  for (const auto& [name, color] : texts) EXPECT_GE(contrast(color, colors().panel), 4.5) << name;
}

TEST_P(PageTheme, MarkedTermsAreReadable) {
  for (const Color& under : {colors().paper, colors().panel})
    for (const auto& [name, color] : colors_of_formulas())
      EXPECT_GE(contrast(color, over(colors().marked, under)), 3.0) << name;
}

TEST_P(PageTheme, BarsStandOutFromWhatTheyStandOn) {
  for (const Color& bar : {colors().accent, colors().said, colors().meant, colors().question})
    EXPECT_GE(contrast(bar, colors().paper), 3.0);
  EXPECT_GE(contrast(colors().accent, colors().panel), 3.0);
}

TEST_P(PageTheme, PanelsMarksAndLinesAreSeen) {
  // Without a meaning of their own; what a step of lightness of 4 in CIE L* gives at these papers.
  for (const Color& faint : {colors().panel, colors().line, over(colors().marked, colors().paper),
                             over(colors().marked, colors().panel)})
    EXPECT_GE(contrast(faint, colors().paper), 1.1);
  EXPECT_GE(contrast(over(colors().marked, colors().panel), colors().panel), 1.1);
}

TEST_P(PageTheme, WhatDiffersInMeaningDiffersInColor) {
  EXPECT_NE(colors().said, colors().meant);
  EXPECT_NE(colors().said, colors().question);
  EXPECT_NE(colors().meant, colors().question);
  EXPECT_LT(colors().marked.a, 1.0F);  // what it lies on shows through
}

TEST_P(PageTheme, SymbolsHaveTheColorOfTheirRoleAndThoseOfAxesTheInk) {
  const LessonReading reading = read_lesson(
      "+++\nformat = 1\nid = \"s\"\ntitle = \"S\"\n[symbols]\n"
      "omega = { tex = '\\vec\\omega', role = \"omega\" }\nT = { tex = 'T', role = \"axes\" }\n+++\n"
      "# A {a}\nText.\n",
      "s.md");
  ASSERT_TRUE(reading.lesson) << to_string(reading.diagnostics.front());
  const std::vector<MathSymbol> symbols = symbols_of(*reading.lesson, GetParam());
  ASSERT_EQ(symbols.size(), 2u);
  for (const MathSymbol& symbol : symbols)
    EXPECT_EQ(symbol.color, symbol.name == "T" ? colors().ink : on_paper(kOmegaRole.ink, GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Both, PageTheme, testing::Values(Theme::paper, Theme::dark),
                         [](const auto& row) { return row.param == Theme::paper ? "Paper" : "Dark"; });

TEST(PageThemes, TheOneIsLightAndTheOtherDark) {
  EXPECT_FALSE(is_dark(colors_of(Theme::paper).paper));
  EXPECT_TRUE(is_dark(colors_of(Theme::dark).paper));
  EXPECT_EQ(on_paper(kOmegaRole.ink, Theme::paper), kOmegaRole.ink);
}

}  // namespace
}  // namespace polhode
