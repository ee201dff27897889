// SPDX-License-Identifier: MIT
#include "base/printable.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

TEST(Printable, LeavesWhatShowsAsItIs) {
  for (const char* text : {"", "plain", "ω·L = 2T", "é ñ 漢字 😀", "two\nlines", "a\\b \"c\""})
    EXPECT_EQ(printable(text), text);
}

TEST(Printable, WritesOutWhatSteersATerminal) {
  EXPECT_EQ(printable("\x1b[31mRED\x07"), "\\u001b[31mRED\\u0007");
  EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a\\u0000b");
  EXPECT_EQ(printable("\r\t\x7f"), "\\u000d\\u0009\\u007f");
  EXPECT_EQ(printable("\xc2\x9b"
                      "31m"),
            "\\u009b31m");
  EXPECT_EQ(printable("\xe2\x80\xae"
                      "evil"),
            "\\u202eevil");
  for (const char* text : {"\xe2\x80\x8e", "\xe2\x80\x8f", "\xe2\x80\xaa", "\xe2\x81\xa6", "\xe2\x81\xa9",
                           "\xe2\x80\xa8", "\xd8\x9c", "\xef\xbb\xbf"})
    EXPECT_EQ(printable(text).substr(0, 2), "\\u") << text;
}

TEST(Printable, WritesOutBytesThatAreNoUtf8) {
  EXPECT_EQ(printable("a\xff"
                      "b"),
            "a\\xffb");
  EXPECT_EQ(printable("\x9b"), "\\x9b");                           // 8-bit CSI
  EXPECT_EQ(printable("\xc2"), "\\xc2");                           // cut off
  EXPECT_EQ(printable("\xc0\x9b"), "\\xc0\\x9b");                  // overlong
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");         // a surrogate
  EXPECT_EQ(printable("\xf4\x90\x80\x80").substr(0, 4), "\\xf4");  // past the last character
}

TEST(Printable, OfALineHasNoSecond) {
  EXPECT_EQ(printable_line("a\nb"), "a\\u000ab");
  EXPECT_EQ(printable_line("ω"), "ω");
}

TEST(Printable, IsTheTextItselfWhereItCanBeCopied) {
  for (const char* text : {"", "a b", "ω", "\\u001b"}) EXPECT_TRUE(shows_as_it_is(text)) << text;
  for (const char* text : {"a\nb", "\x1b[31m", "\xff", "\u202e"})
    EXPECT_FALSE(shows_as_it_is(text)) << printable(text);
}

}  // namespace
}  // namespace polhode
