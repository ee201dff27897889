// SPDX-License-Identifier: MIT
#include "lessons/reader/markdown/located_text.h"

#include "lessons/reader/front_matter/toml_tree.h"
#include "tests/lessons/support.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

using testing::TextReport;

TEST(LocatedText, KnowsWhereItsPiecesCameFrom) {
  LocatedText text;
  text.append("abc", 10);
  text.append_as("é", 20);
  text.append("d", 30);
  EXPECT_EQ(text.text(), "abcéd");
  EXPECT_EQ(text.offset_of(2), 12U);
  EXPECT_EQ(text.offset_of(3), 20U);
  EXPECT_EQ(text.offset_of(4), 20U) << "inside what the file spells otherwise";
  EXPECT_EQ(text.offset_of(5), 30U);
  EXPECT_EQ(text.offset_of(6), 31U) << "the end";
  EXPECT_EQ(text.span_of(1, 3), (SourceSpan{11, 13}));
  EXPECT_EQ(LocatedText().offset_of(0), 0U);
}

/// Each character of the value, where it is found in the source.
std::string places(const std::string& toml_text) {
  TextReport at(toml_text);
  const TomlTable table = testing::toml(toml_text);
  const auto* value = table.entries.at(0).value.as<std::string>();
  EXPECT_NE(value, nullptr);
  const LocatedText located = located_string(at.source, table.entries[0].value.place, *value);
  EXPECT_EQ(located.text(), *value);
  std::string found;
  for (std::size_t i = 0; i < value->size(); ++i) found += toml_text[located.offset_of(i)];
  return found;
}

TEST(LocatedString, FindsLiteralAndQuotedStrings) {
  EXPECT_EQ(places("x = 'a \\vec L'"), "a \\vec L");
  EXPECT_EQ(places("x = \"a b\""), "a b");
}

TEST(LocatedString, FindsEscapesAtTheirBackslash) {
  EXPECT_EQ(places(R"(x = "a\\b\"c\u0041d")"), "a\\b\\c\\d");
  EXPECT_EQ(places(R"(x = "\\vec L")"), "\\vec L");
}

TEST(LocatedString, FindsTheLinesOfLongStrings) {
  EXPECT_EQ(places("x = '''\na\n\\b'''"), "a\n\\b");
  EXPECT_EQ(places("x = \"\"\"a\\\n   b\"\"\""), "ab");
}

TEST(LocatedString, CountsCharactersNotBytes) { EXPECT_EQ(places("x = 'ωb'").back(), 'b'); }

TEST(LocatedString, TakesAnyPlaceForAStringThatIsNotThere) {
  TextReport at("x = 1");
  EXPECT_EQ(located_string(at.source, {1, 5}, "abc").offset_of(2), 4U);
  EXPECT_EQ(located_string(at.source, {9, 9}, "abc").text(), "abc");
  EXPECT_EQ(located_string(at.source, {1, 1}, "").text(), "");
}

}  // namespace
}  // namespace polhode
