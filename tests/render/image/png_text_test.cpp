// SPDX-License-Identifier: MIT
#include "render/image/png_text.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

TEST(PngText, KeywordsOfTheStandardPass) {
  for (const char* keyword : {"Title", "Creation Time", "polhode:scene", "x"})
    EXPECT_FALSE(keyword_error(keyword).has_value()) << keyword;
  EXPECT_FALSE(keyword_error(std::string(79, 'k')).has_value());
}

TEST(PngText, OtherKeywordsDoNot) {
  for (const char* keyword : {"", " x", "x ", "a  b", "tab\there", "ω", "\x7f"})
    EXPECT_TRUE(keyword_error(keyword).has_value()) << keyword;
  EXPECT_TRUE(keyword_error(std::string(80, 'k')).has_value());
}

TEST(PngText, Latin1GoesThereAndBack) {
  const std::string text = "L² = 2TI₂?";  // the subscript is not Latin-1
  EXPECT_FALSE(latin1_from_utf8(text).has_value());
  const std::string western = "Coriolis à 45° ± ½ ÿ\nsecond line";
  const auto latin1 = latin1_from_utf8(western);
  ASSERT_TRUE(latin1.has_value());
  EXPECT_EQ(latin1->size(), std::string_view("Coriolis a 45d p h y\nsecond line").size());
  EXPECT_EQ(utf8_from_latin1(*latin1), western);
}

TEST(PngText, EveryLatin1ByteComesBack) {
  for (int c = 0xA0; c <= 0xFF; ++c) {
    const std::string latin1(1, static_cast<char>(c));
    EXPECT_EQ(latin1_from_utf8(utf8_from_latin1(latin1)), latin1) << c;
  }
}

TEST(PngText, ControlCharactersAreNotLatin1Text) {
  EXPECT_FALSE(latin1_from_utf8("a\tb").has_value());
  EXPECT_FALSE(latin1_from_utf8("\xC2\x85").has_value());
}

TEST(PngText, Utf8AsInRfc3629) {
  for (const char* text : {"", "plain", "é", "ω₂", "\xF0\x9F\xAA\x90", "\xED\x9F\xBF", "\xF4\x8F\xBF\xBF"})
    EXPECT_TRUE(is_png_utf8(text)) << text;
  const struct {
    const char* text;
    const char* why;
  } bad[] = {{"\x80", "continuation first"},          {"\xC3", "cut off"},
             {"\xC0\xAF", "overlong of 2"},           {"\xE0\x80\xAF", "overlong of 3"},
             {"\xF0\x80\x80\xAF", "overlong of 4"},   {"\xED\xA0\x80", "surrogate"},
             {"\xF4\x90\x80\x80", "beyond U+10FFFF"}, {"\xFF", "no such byte"},
             {"\xE2\x28\xA1", "bad second byte"}};
  for (const auto& [text, why] : bad) EXPECT_FALSE(is_png_utf8(text)) << why;
  EXPECT_FALSE(is_png_utf8(std::string_view("a\0b", 3))) << "a zero would end the chunk";
}

}  // namespace
}  // namespace polhode
