// SPDX-License-Identifier: MIT
#include "lessons/reader/markdown/inline_marks.h"

#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::TextReport;

struct Found {
  std::vector<std::string> formulas, notes, citations, complaints;
};
Found find(const std::string& text) {
  TextReport at(text);
  const LocatedText located(at.source, at.source.text());
  Found found;
  for (const InlineMark& mark : find_inline_marks(located, at.report)) {
    const std::string inside = text.substr(mark.inside.begin, mark.inside.end - mark.inside.begin);
    if (mark.kind == InlineMark::Kind::formula) found.formulas.push_back(inside);
    if (mark.kind == InlineMark::Kind::note) found.notes.push_back(inside);
    if (mark.kind == InlineMark::Kind::citation) found.citations.push_back(inside);
  }
  found.complaints = at.lines();
  return found;
}

TEST(InlineMath, StandsBetweenDollars) {
  EXPECT_THAT(find("$x$ and $\\{$ and $a\n+b$.").formulas, ElementsAre("x", "\\{", "a\n+b"));
  EXPECT_THAT(find("no mathematics").formulas, IsEmpty());
  EXPECT_THAT(find("$\\$$").formulas, ElementsAre("\\$"));
}

TEST(InlineMath, IsNoneInCodeAndAfterABackslash) {
  for (const char* text : {"`$a$` code", "\\$5 and \\$6", "``$a$ ` $b$``"}) {
    EXPECT_THAT(find(text).formulas, IsEmpty()) << text;
    EXPECT_THAT(find(text).complaints, IsEmpty()) << text;
  }
}

TEST(InlineMath, IsThereAfterABacktickThatOpensNothing) {
  EXPECT_THAT(find("a ` $x$").formulas, ElementsAre("x"));
  EXPECT_THAT(find("`` $x$ `").formulas, ElementsAre("x"));
  EXPECT_THAT(find("`a\n\n$x$ `").formulas, ElementsAre("x")) << "code ends with its paragraph";
}

TEST(InlineMath, WarnsOfDollarsThatWereNotMeant) {
  EXPECT_THAT(
      find("cost $5 and $6").complaints,
      ElementsAre(
          "1:6: warning: is this a formula? It begins or ends with a space (write \\$ for a dollar sign)"));
}

TEST(InlineMath, KeepsToTheParagraph) {
  const Found found = find("one $\n\ntwo $x$");
  EXPECT_THAT(found.complaints, ElementsAre("1:5: warning: this $ has no partner in its paragraph "
                                            "(write \\$ for a dollar sign)"));
  EXPECT_THAT(found.formulas, ElementsAre("x"));
}

TEST(InlineMath, ReportsDisplayMathematicsOnce) {
  EXPECT_THAT(
      find("a\n$$\nx\n$$\nb $y$").complaints,
      ElementsAre("2:1: error: display mathematics stands in a fence (write ```math ID, the formula, ```)"));
}

TEST(InlineMarks, AreFootnotesAndCitations) {
  const Found found = find("a[^1] [cite: LL, §35]. \\[^2] `[^3]` [x](#y) [^4\n\n5] [cite:\nA b]");
  EXPECT_THAT(found.notes, ElementsAre("1"));
  EXPECT_THAT(found.citations, ElementsAre(" LL, §35", "\nA b"));
  EXPECT_THAT(found.complaints, IsEmpty());
  EXPECT_THAT(find("$[^1]$").notes, IsEmpty());
}

TEST(InlineMarks, EndAnywhere) {
  const std::string text = "a `$x$` \\$ $\\{x$ $$ y $$\n\n`` $z$ [^1] [cite: A] ` $\\";
  for (std::size_t size = 0; size <= text.size(); ++size) find(text.substr(0, size));
}

}  // namespace
}  // namespace polhode
