// SPDX-License-Identifier: MIT
#include "base/utf8.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

TEST(Utf8, CodePointsAreThoseOfTheText) {
  EXPECT_EQ(code_points(""), U"");
  EXPECT_EQ(code_points("aω−𝐈"), U"aω−𝐈");
}

// Unicode 15.0, table 3-8: a byte that cannot go on with the character before it is replaced on its own.
TEST(Utf8, EachByteThatIsNoCharactersIsReplaced) {
  EXPECT_EQ(code_points("\xC3"), U"\uFFFD");
  EXPECT_EQ(code_points("\xFFz"), U"\uFFFDz");
  EXPECT_EQ(code_points("\xED\xA0\x80"), U"\uFFFD\uFFFD\uFFFD") << "a surrogate";
  EXPECT_EQ(code_points("\xC0\xAF"), U"\uFFFD\uFFFD") << "an overlong form";
  EXPECT_EQ(code_points("\xF4\x90\x80\x80"), U"\uFFFD\uFFFD\uFFFD\uFFFD") << "beyond U+10FFFF";
}

TEST(Utf8, EveryCharacterReadsBackAsItself) {
  for (char32_t character = 0; character <= 0x10FFFF; ++character) {
    if (0xD800 <= character && character <= 0xDFFF) continue;
    std::string text;
    append_utf8(text, character);
    ASSERT_EQ(code_points(text), std::u32string(1, character));
    ASSERT_EQ(count_characters(text), 1);
  }
}

}  // namespace
}  // namespace polhode
