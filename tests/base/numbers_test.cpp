// SPDX-License-Identifier: MIT
#include "base/numbers.h"

#include <gtest/gtest.h>

#include <limits>

namespace polhode {
namespace {

TEST(ParseNumber, ReadsDecimalAndHexadecimalExactly) {
  EXPECT_EQ(parse_number("0.1"), 0.1);
  EXPECT_EQ(parse_number("-1e-300"), -1e-300);
  EXPECT_EQ(parse_number("0x1.8p+1"), 3.0);
  EXPECT_EQ(parse_number("-0x1p-1074"), -std::numeric_limits<double>::denorm_min());
  // Halfway cases that a reader through long double would round twice.
  EXPECT_EQ(parse_number("9007199254740993"), 9007199254740992.0);
}

TEST(ParseNumber, RefusesWhatIsNotANumber) {
  for (const char* text : {"", " 1", "1 ", "1,5", "1.5.2", "0x", "one", "1e", "--1", "1m"})
    EXPECT_FALSE(parse_number(text)) << '"' << text << '"';
}

TEST(Digits17, ReadBackTheSameAndAreNoLocales) {
  for (const double value : {0.1, -1e-300, 1.0 / 3.0, 5e-324, 1.7976931348623157e308, 0.0, 12345678.0})
    EXPECT_EQ(parse_number(digits17(value)), value) << digits17(value);
  EXPECT_EQ(digits17(0.5), "0.5");
  EXPECT_EQ(digits17(0.1), "0.10000000000000001");
}

TEST(Shortest, ReadsBackTheSame) {
  for (const double value : {0.1, -1e-300, 1.0 / 3.0, 5e-324, 1.7976931348623157e308, 0.0, 12345678.0})
    EXPECT_EQ(parse_number(shortest(value)), value) << shortest(value);
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(shortest(1e300), "1e+300");
}

TEST(Fixed, HasSoManyDecimalsHoweverLargeTheNumber) {
  EXPECT_EQ(fixed(0.5, 2), "0.50");
  EXPECT_EQ(fixed(-0.25, 0), "-0");
  EXPECT_EQ(fixed(1.7976931348623157e308, 3).size(), 309U + 4);
}

TEST(Scientific, HasOneDigitBeforeThePoint) {
  EXPECT_EQ(scientific(2.5e-7, 2), "2.50e-07");
  EXPECT_EQ(scientific(0, 1), "0.0e+00");
}

TEST(Split, HasOnePartMoreThanSeparators) {
  EXPECT_EQ(split("a,,b", ','), (std::vector<std::string_view>{"a", "", "b"}));
  EXPECT_EQ(split("", ','), (std::vector<std::string_view>{""}));
}

}  // namespace
}  // namespace polhode
