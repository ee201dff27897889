// SPDX-License-Identifier: MIT
#include "render/typeset/line_formulas.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> formulas(std::string_view text) {
  std::vector<std::string> found;
  for (const SourceSpan& span : formulas_of_line(text))
    found.emplace_back(text.substr(span.begin, span.end - span.begin));
  return found;
}

TEST(FormulasOfLine, StandBetweenDollars) {
  EXPECT_THAT(formulas("$L$ in $S^*$, not $\\$$"), ElementsAre("L", "S^*", "\\$"));
  EXPECT_THAT(formulas(""), IsEmpty());
}

TEST(FormulasOfLine, AreNotAmountsOfMoney) {
  EXPECT_THAT(formulas("$5 and $6"), IsEmpty());
  EXPECT_THAT(formulas("\\$a\\$ $$ $"), IsEmpty());
  EXPECT_THAT(formulas("cost $5, $x$"), ElementsAre("x"));
  EXPECT_THAT(formulas("$x\\"), IsEmpty());
}

}  // namespace
}  // namespace polhode
