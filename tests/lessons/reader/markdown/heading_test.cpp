// SPDX-License-Identifier: MIT
#include "lessons/reader/markdown/heading.h"

#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using testing::TextReport;

TEST(Heading, HasATitleAndAnId) {
  TextReport at("# The tensor $\\mathbf{I}$ {tensor-I} ");
  const Heading heading = read_heading(1, at.texts);
  EXPECT_THAT(at.lines(), IsEmpty());
  EXPECT_EQ(heading.title, "The tensor $\\mathbf{I}$");
  EXPECT_EQ(heading.id, "tensor-I");
  EXPECT_EQ(heading.id_place, (SourcePlace{1, 28}));
}

TEST(Heading, WithoutIdGetsAProposal) {
  TextReport at("# Ω and L: what for?");
  EXPECT_EQ(read_heading(1, at.texts).id, "");
  EXPECT_THAT(at.lines(),
              ElementsAre("1:1: error: this heading has no stage id in braces at its end (end it with "
                          "{and-l-what-for})"));
}

TEST(Heading, RefusesBadIdsAndEmptyTitles) {
  for (const char* line : {"# A {b c}", "# A {}", "# {a}", "# A {a} b", "# A }", "#", "# A {a"}) {
    TextReport at(line);
    read_heading(1, at.texts);
    EXPECT_THAT(at.lines(), SizeIs(1)) << line;
  }
}

TEST(ReadWords, KeepsTheirPlaces) {
  const auto words = read_words("```claim ω  law ", 3, 7);
  ASSERT_THAT(words, SizeIs(3));
  EXPECT_EQ(words[0].text, "claim");
  EXPECT_EQ(words[2].text, "law");
  EXPECT_EQ(words[2].place, (SourcePlace{7, 13}));
  EXPECT_THAT(read_words("```", 3, 1), IsEmpty());
  EXPECT_THAT(read_words("```", std::string_view::npos, 1), IsEmpty());
}

TEST(TrimmedLines, TakesLineEndsOffToo) {
  EXPECT_EQ(trimmed_lines("\n \ta\nb\r\n"), "a\nb");
  EXPECT_EQ(trimmed_lines(" \n"), "");
}

}  // namespace
}  // namespace polhode
