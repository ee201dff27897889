// SPDX-License-Identifier: MIT
#include "lessons/claims/answers/reason_tags.h"

#include "lessons/claims/answers/told_in_language.h"
#include "lessons/derivation/derivation.h"

#include <gtest/gtest.h>

#include <string>

namespace polhode {
namespace {

TEST(ReasonTag, IsAShortWordThatNoTableAndNoTerminalMisreads) {
  for (const char* tag : {"sign", "choice-B", "place-2", "a", "abcdefghijklmnopqrstuvwx"})
    EXPECT_TRUE(is_reason_tag(tag)) << tag;
  for (const char* no : {"", "two words", "a,b", "=1", "a\n", "\x1b[1m", "é", "abcdefghijklmnopqrstuvwxy"})
    EXPECT_FALSE(is_reason_tag(no)) << no;
}

TEST(ReasonTag, OfEverySlipHasWords) {
  for (int i = static_cast<int>(Slip::kind); i <= static_cast<int>(Slip::other); ++i) {
    const std::string tag(name_of(static_cast<Slip>(i)));
    EXPECT_TRUE(is_reason_tag(tag)) << i;
    EXPECT_NE(words_of_reason(tag), tag) << "it has no words";
    EXPECT_NE(words_of_reason_in(Language::de, tag), words_of_reason(tag)) << tag;
  }
}

TEST(ReasonTag, OfChoicesAndOrdersSaysWhichWasTaken) {
  EXPECT_EQ(words_of_reason("choice-C"), "C was chosen");
  EXPECT_EQ(words_of_reason("place-3"), "the order is wrong from place 3");
  EXPECT_EQ(words_of_reason("of-another-version"), "of-another-version");
}

}  // namespace
}  // namespace polhode
