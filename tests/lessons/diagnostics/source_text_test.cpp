// SPDX-License-Identifier: MIT
#include "lessons/diagnostics/source_text.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

TEST(SourceText, KnowsItsLinesWithoutTheirEnds) {
  const SourceText source("one\ntwo\r\n\nfour");
  ASSERT_EQ(source.line_count(), 4);
  EXPECT_EQ(source.line(1), "one");
  EXPECT_EQ(source.line(2), "two");
  EXPECT_EQ(source.line(3), "");
  EXPECT_EQ(source.line(4), "four");
  EXPECT_EQ(source.lines(1, 2), "one\ntwo");
  EXPECT_EQ(source.lines(3, 2), "");
}

TEST(SourceText, HasAnEmptyLineAfterAFinalLineFeed) {
  EXPECT_EQ(SourceText("a\n").line_count(), 2);
  EXPECT_EQ(SourceText("").line_count(), 1);
  EXPECT_EQ(SourceText("").line(1), "");
}

TEST(SourceText, CountsColumnsInCharacters) {
  const SourceText source("ab\nω×L 😀x");
  EXPECT_EQ(source.place_of(std::size_t{0}), (SourcePlace{1, 1}));
  EXPECT_EQ(source.place_of(std::size_t{2}), (SourcePlace{1, 3}));  // the line feed ends its line
  EXPECT_EQ(source.place_of(source.text().find('L')), (SourcePlace{2, 3}));
  EXPECT_EQ(source.place_of(source.text().find('x')), (SourcePlace{2, 6}));
  EXPECT_EQ(source.place_of(source.text().substr(3)), (SourcePlace{2, 1}));
}

TEST(SourceText, MovesPlacesIntoTheText) {
  const SourceText source("abc\nω");
  EXPECT_EQ(source.clamp({2, 2}), (SourcePlace{2, 2}));
  EXPECT_EQ(source.clamp({2, 9}), (SourcePlace{2, 2}));
  EXPECT_EQ(source.clamp({9, 1}), (SourcePlace{2, 2}));
  EXPECT_EQ(source.clamp({0, 5}), (SourcePlace{1, 1}));
  EXPECT_EQ(source.clamp({1, 0}), (SourcePlace{1, 1}));
}

TEST(Trimmed, TakesBlanksOffBothEnds) {
  EXPECT_EQ(trimmed(" \t a b\r"), "a b");
  EXPECT_EQ(trimmed("  "), "");
  EXPECT_TRUE(is_blank(" \t\r"));
  EXPECT_FALSE(is_blank(" . "));
}

TEST(WhyNotText, TakesEveryLengthOfCharacter) {
  EXPECT_FALSE(why_not_text("a\tω×⃗😀\r\n"));
  EXPECT_FALSE(why_not_text("\u00A0\u07FF\u0800\uFFFD\U00010000\U0010FFFF"));
}

struct BadBytes {
  std::string bytes;
  std::size_t offset;
};
class WhyNotTextRefuses : public ::testing::TestWithParam<BadBytes> {};
TEST_P(WhyNotTextRefuses, AndSaysWhere) {
  const auto wrong = why_not_text(GetParam().bytes);
  ASSERT_TRUE(wrong);
  EXPECT_EQ(wrong->offset, GetParam().offset);
}
INSTANTIATE_TEST_SUITE_P(All, WhyNotTextRefuses,
                         ::testing::Values(BadBytes{"ab\xFF", 2}, BadBytes{"a\x80", 1},
                                           BadBytes{"\xC0\xAF", 0}, BadBytes{"\xC1\xBF", 0},
                                           BadBytes{"\xE0\x80\x80", 0}, BadBytes{"\xED\xA0\x80", 0},
                                           BadBytes{"a\xC2\x9B", 1}, BadBytes{"\xF0\x80\x80\x80", 0},
                                           BadBytes{"\xF4\x90\x80\x80", 0}, BadBytes{"\xF5\x80\x80\x80", 0},
                                           BadBytes{"ω\xCF", 2}, BadBytes{"\xE2\x82", 0},
                                           BadBytes{"\xE2\x41\x41", 0}, BadBytes{std::string("a\0b", 3), 1},
                                           BadBytes{"a\x1B[0m", 1}, BadBytes{"a\x7F", 1}, BadBytes{"a\rb", 1},
                                           BadBytes{"a\r", 1}));

}  // namespace
}  // namespace polhode
