// SPDX-License-Identifier: MIT
#include "lessons/math_text.h"

#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using testing::TextReport;

std::vector<std::string> math_complaints(const std::string& tex) {
  TextReport at(tex);
  read_math(tex, {1, 1}, at.report);
  return at.lines();
}

std::vector<std::string> prose_complaints(const std::string& text) {
  TextReport at(text);
  check_inline_math(text, {1, 1}, at.report);
  return at.lines();
}

TEST(ReadMath, FindsTagsAndTerms) {
  TextReport at("x \\tag{5}\n\\term{turn}{\\vec a \\term{inner}{b}} \\tag{6'}");
  const MathNames names = read_math(at.text, {1, 1}, at.report);
  EXPECT_THAT(at.lines(), IsEmpty());
  ASSERT_THAT(names.tags, SizeIs(2));
  EXPECT_EQ(names.tags[0].text, "5");
  EXPECT_EQ(names.tags[0].place, (SourcePlace{1, 8}));
  EXPECT_EQ(names.tags[1].text, "6'");
  ASSERT_THAT(names.terms, SizeIs(2));
  EXPECT_EQ(names.terms[0].text, "turn");
  EXPECT_EQ(names.terms[1].place, (SourcePlace{2, 26}));
}

TEST(ReadMath, TakesWhatCloses) {
  for (const char* tex :
       {"{a}{b{c}}", "\\{ a \\}", "\\left\\{ a \\right.", "\\left( \\left[ a \\right] \\right)",
        "\\begin{aligned} {a} \\\\ b \\end{aligned}", "% {\na", "\\\\{a}", "\\frac12"}) {
    EXPECT_THAT(math_complaints(tex), IsEmpty()) << tex;
  }
}

TEST(ReadMath, ReportsWhatDoesNotCloseWhereItOpens) {
  EXPECT_THAT(math_complaints("a {b"), ElementsAre("1:3: error: { is never closed"));
  EXPECT_THAT(math_complaints("ω }"), ElementsAre("1:3: error: } closes nothing"));
  EXPECT_THAT(math_complaints("a\n\\left( b"), ElementsAre("2:1: error: \\left is never closed"));
  EXPECT_THAT(math_complaints("\\right)"), ElementsAre("1:1: error: \\right closes nothing"));
  EXPECT_THAT(math_complaints("\\end{cases}"), ElementsAre("1:1: error: \\end{cases} closes nothing"));
  EXPECT_THAT(math_complaints("{\\left( }"), SizeIs(3)) << "what crosses is wrong on both sides";
}

TEST(ReadMath, TakesBracesOfTheLimitAndNoDeeper) {
  const std::string open(kMaxMathNesting, '{');
  const std::string close(kMaxMathNesting, '}');
  EXPECT_THAT(math_complaints(open + close), IsEmpty());
  EXPECT_THAT(math_complaints(open + "{}" + close),
              ElementsAre("1:65: error: braces are nested deeper than 64"));
}

TEST(ReadMath, EndsAnywhere) {
  const std::string tex = "\\left\\{\\term{a}{b}\\begin{c}\\tag{1}%\n\\";
  for (std::size_t size = 0; size <= tex.size(); ++size) math_complaints(tex.substr(0, size));
}

TEST(InlineMath, TakesFormulasCodeAndEscapedDollars) {
  for (const char* text :
       {"$x$ and $\\{$", "`$` code", "\\$5 and \\$6", "$a\nb$", "no mathematics", "$\\vec\\omega$."}) {
    EXPECT_THAT(prose_complaints(text), IsEmpty()) << text;
  }
}

TEST(InlineMath, WarnsOfDollarsThatWereNotMeant) {
  EXPECT_THAT(
      prose_complaints("cost $5 and $6"),
      ElementsAre(
          "1:6: warning: is this a formula? It begins or ends with a space (write \\$ for a dollar sign)"));
}

TEST(InlineMath, KeepsToTheParagraph) {
  EXPECT_THAT(prose_complaints("one $\n\ntwo $x$"),
              ElementsAre("1:5: warning: this $ has no partner in its paragraph "
                          "(write \\$ for a dollar sign)"));
}

TEST(InlineMath, ReportsDisplayMathematicsOnce) {
  EXPECT_THAT(
      prose_complaints("a\n$$\nx\n$$\nb $y$"),
      ElementsAre("2:1: error: display mathematics stands in a fence (write ```math ID, the formula, ```)"));
}

TEST(InlineMath, ReportsBracesWithTheirPlace) {
  EXPECT_THAT(prose_complaints("ωω $\\vec{a$"), ElementsAre("1:9: error: { is never closed"));
}

}  // namespace
}  // namespace polhode
