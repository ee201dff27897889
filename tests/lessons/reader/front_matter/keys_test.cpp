// SPDX-License-Identifier: MIT
#include "lessons/reader/front_matter/keys.h"

#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::TextReport;
using testing::toml;

TEST(IsId, TakesLettersDigitsAndHyphens) {
  EXPECT_TRUE(is_id("why-L-is-fixed-2"));
  EXPECT_TRUE(is_id(std::string(64, 'a')));
  for (const char* bad : {"", "a b", "a_b", "ω", "a.b"}) EXPECT_FALSE(is_id(bad)) << bad;
  EXPECT_FALSE(is_id(std::string(65, 'a')));
}

TEST(ReadNumber, TakesIntegersAndRefusesWhatIsNotFinite) {
  TextReport at("k = 3");
  EXPECT_EQ(read_number(toml("k = 3").entries[0], at.report), 3.0);
  EXPECT_EQ(read_number(toml("k = -2.5").entries[0], at.report), -2.5);
  EXPECT_EQ(read_number(toml("k = nan").entries[0], at.report), std::nullopt);
  EXPECT_EQ(read_number(toml("k = -inf").entries[0], at.report), std::nullopt);
  EXPECT_EQ(read_number(toml("k = '3'").entries[0], at.report), std::nullopt);
  EXPECT_THAT(at.lines(), ElementsAre("1:5: error: \"k\" must be finite, found nan",
                                      "1:5: error: \"k\" must be finite, found -inf",
                                      "1:5: error: \"k\" takes a number, found a string"));
}

TEST(ReadPositiveNumber, RefusesZeroAndLess) {
  TextReport at("k = 0");
  EXPECT_EQ(read_positive_number(toml("k = 1e-300").entries[0], at.report), 1e-300);
  EXPECT_EQ(read_positive_number(toml("k = 0").entries[0], at.report), std::nullopt);
  EXPECT_EQ(read_positive_number(toml("key = -0.0").entries[0], at.report), std::nullopt);
  EXPECT_EQ(at.lines().size(), 2U);
}

TEST(ReadNumbers, WantsJustSoMany) {
  TextReport at("k = [1, 2, 3, 4]");
  EXPECT_EQ(read_vector(toml("k = [1, 2.5, 3]").entries[0], at.report), Vec3(1, 2.5, 3));
  EXPECT_EQ(read_vector(toml("k = [1, 2]").entries[0], at.report), std::nullopt);
  EXPECT_EQ(read_vector(toml("k = [1, 2, 3, 4]").entries[0], at.report), std::nullopt);
  EXPECT_EQ(read_vector(toml("k = 1").entries[0], at.report), std::nullopt);
  EXPECT_EQ(read_vector(toml("k = [1, inf, true]").entries[0], at.report), std::nullopt);
  EXPECT_EQ(at.lines().size(), 5U) << "both wrong elements are reported";
}

TEST(ReadTexts, TakesOneOrAListUpToTheLimit) {
  TextReport at("k = ['a', 'b', 'c']");
  ASSERT_EQ(read_texts(toml("k = 'a'").entries[0], 2, at.report)->size(), 1U);
  const auto two = read_texts(toml("k = ['a', 'b']").entries[0], 2, at.report);
  ASSERT_EQ(two->size(), 2U);
  EXPECT_EQ((*two)[1].text, "b");
  EXPECT_EQ((*two)[1].place, (SourcePlace{1, 11}));
  EXPECT_THAT(at.report.has_errors(), false);
  EXPECT_FALSE(read_texts(toml("k = ['a', 'b', 'c']").entries[0], 2, at.report));
  EXPECT_FALSE(read_texts(toml("k = ['a', 1]").entries[0], 2, at.report));
  EXPECT_FALSE(read_texts(toml("k = true").entries[0], 2, at.report));
  EXPECT_EQ(at.lines().size(), 3U);
}

TEST(ReadTextAndFlag, WantTheirKind) {
  TextReport at("k = 1");
  EXPECT_EQ(read_text(toml("k = 'a'").entries[0], at.report), "a");
  EXPECT_EQ(read_flag(toml("k = true").entries[0], at.report), true);
  EXPECT_EQ(read_text(toml("k = 1").entries[0], at.report), std::nullopt);
  EXPECT_EQ(read_flag(toml("k = 1").entries[0], at.report), std::nullopt);
  EXPECT_THAT(at.lines(), ElementsAre("1:5: error: \"k\" takes a string, found a number",
                                      "1:5: error: \"k\" takes true or false, found a number"));
}

TEST(ReadKeys, CallsTheHandlerOfEachKeyAndReportsTheRest) {
  const TomlTable table = toml("at = 1\nrat = 2");
  TextReport at("at = 1\nrat = 2");
  std::vector<std::string> called;
  const auto call = [&called](const TomlEntry& entry) { called.push_back(entry.key); };
  read_keys(table, "the scene", {{"at", call}, {"rate", call}}, at.report);
  EXPECT_THAT(called, ElementsAre("at"));
  EXPECT_THAT(at.lines(),
              ElementsAre("2:1: error: unknown key \"rat\" in the scene (did you mean \"rate\"?)"));
}

}  // namespace
}  // namespace polhode
