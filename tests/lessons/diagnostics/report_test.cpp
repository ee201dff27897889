// SPDX-License-Identifier: MIT
#include "lessons/diagnostics/report.h"

#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using testing::TextReport;

TEST(Report, SortsByPlaceAndKeepsTheOrderWithinOne) {
  TextReport at("abc\ndef");
  at.report.error({2, 2}, "third");
  at.report.warning({1, 3}, "second");
  at.report.error({1, 1}, "first");
  at.report.error({2, 2}, "fourth");
  EXPECT_THAT(at.lines(), ElementsAre("1:1: error: first", "1:3: warning: second", "2:2: error: third",
                                      "2:2: error: fourth"));
}

TEST(Report, MovesPlacesIntoTheText) {
  TextReport at("abc");
  at.report.error({7, 7}, "behind");
  EXPECT_THAT(at.lines(), ElementsAre("1:4: error: behind"));
}

TEST(Report, WarningsAloneAreNoErrors) {
  TextReport at("abc");
  at.report.warning({1, 1}, "odd");
  EXPECT_FALSE(at.report.has_errors());
  at.report.error({1, 1}, "wrong");
  EXPECT_TRUE(at.report.has_errors());
}

TEST(Report, KeepsAHundredErrorsAndSaysThatThereAreMore) {
  TextReport at("abc");
  for (std::size_t i = 0; i < kMaxDiagnostics; ++i) at.report.error({1, 1}, "wrong " + std::to_string(i));
  EXPECT_FALSE(at.report.is_full());
  at.report.error({1, 2}, "one more");
  at.report.error({1, 3}, "and another");
  EXPECT_TRUE(at.report.is_full());
  const auto lines = at.lines();
  ASSERT_EQ(lines.size(), kMaxDiagnostics + 1);
  EXPECT_EQ(lines.back(), "1:2: error: too many errors, the rest is left out");
}

TEST(InQuotes, ShortensLongNamesBetweenCharacters) {
  EXPECT_EQ(in_quotes("omega"), "\"omega\"");
  std::string long_name;
  for (int i = 0; i < 40; ++i) long_name += "×";
  const std::string shown = in_quotes("a" + long_name);
  EXPECT_LT(shown.size(), 60U);
  EXPECT_FALSE(why_not_text(shown)) << shown;
}

}  // namespace
}  // namespace polhode
