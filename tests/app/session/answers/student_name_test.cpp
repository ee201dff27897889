// SPDX-License-Identifier: MIT
#include "app/session/answers/student_name.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::HasSubstr;

TEST(StudentName, IsALineThatIsSeen) {
  for (const char* name : {"", "Anna", "Zoë O'Neill", "Zoe\u0308", "王小明", "Anna\u00A0Bell", "=1+1"})
    EXPECT_EQ(fault_of_name(name), "") << name;
  for (const char* name : {"two\nlines", "a\tb", "\x1b[1m", "\u202Ex", "\u2028x", "\xff"})
    EXPECT_THAT(fault_of_name(name), HasSubstr("one line")) << name;
  EXPECT_EQ(fault_of_name("Ann\u200Ba"),
            "the name has a character that cannot be seen, U+200B behind \"Ann\"");
  for (const char* name : {"\u00ADx", "x\u2060", "x\u3164", "x\uFE0F", "x\U000E0041"})
    EXPECT_THAT(fault_of_name(name), HasSubstr("cannot be seen")) << name;
  EXPECT_EQ(fault_of_name(std::string(100, 'x')), "");
  EXPECT_THAT(fault_of_name(std::string(101, 'x')), HasSubstr("at most 100"));
}

TEST(StudentName, HasNoBlanksAroundIt) {
  EXPECT_EQ(trimmed_name("  Anna\u3000"), "Anna");
  EXPECT_EQ(trimmed_name("\u00A0 \t"), "");
  EXPECT_EQ(trimmed_name("A B"), "A B");
}

TEST(StudentName, IsComparedAsItLooks) {
  EXPECT_EQ(comparable_name("Zo\u00EB  B"), comparable_name("Zoe\u0308\u00A0B "));
  EXPECT_NE(comparable_name("Zoe"), comparable_name("Zo\u00EB"));
  EXPECT_NE(comparable_name("A B"), comparable_name("AB"));
}

}  // namespace
}  // namespace polhode
