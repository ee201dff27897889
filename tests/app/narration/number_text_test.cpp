// SPDX-License-Identifier: MIT
#include "app/narration/number_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace polhode {
namespace {

TEST(NumberText, HasThreeDigits) {
  EXPECT_EQ(number_tex(0), "0");
  EXPECT_EQ(number_tex(2.4725), "2.47");
  EXPECT_EQ(number_tex(-5.194), "-5.19");
  EXPECT_EQ(number_tex(0.76), "0.760");
  EXPECT_EQ(number_tex(0.01234), "0.0123");
  EXPECT_EQ(number_tex(0.001234), "1.23{\\cdot}10^{-3}");
  EXPECT_EQ(number_tex(181196.5), "1.81{\\cdot}10^{5}");
  EXPECT_EQ(number_tex(-6.62607e-34), "-6.63{\\cdot}10^{-34}");
}

// What is counted in thousands is not cut to one digit.
TEST(NumberText, ShowsWholeNumbersUpToFiveDigits) {
  EXPECT_EQ(number_tex(9999), "9999");
  EXPECT_EQ(number_tex(10000), "10000");
  EXPECT_EQ(number_tex(22500), "22500");
  EXPECT_EQ(number_tex(22500, 1), "22500");
}

TEST(NumberText, RoundsIntoTheNextDecade) {
  EXPECT_EQ(number_tex(9.999), "10.0");
  EXPECT_EQ(number_tex(999.9), "1000");
  EXPECT_EQ(number_tex(0.009999), "0.0100");
  EXPECT_EQ(number_tex(999999), "1.00{\\cdot}10^{6}");
}

TEST(NumberText, HasAsManyDigitsAsAreAskedFor) {
  EXPECT_EQ(number_tex(1.9957, 5), "1.9957");
  EXPECT_EQ(number_tex(1.9957, 1), "2");
  EXPECT_EQ(number_tex(181196.5, 6), "181196");
  EXPECT_EQ(number_tex(181196.75, 7), "181196.8");
  EXPECT_EQ(number_tex(0.1, 15), "0.100000000000000");
}

TEST(NumberText, IsSpokenInWords) {
  EXPECT_EQ(number_words(-0.75), "minus 0.750");
  EXPECT_EQ(number_words(0.001234), "1.23 times 10 to the power minus 3");
  EXPECT_EQ(number_words(-181196.5, 2), "minus 1.8 times 10 to the power 5");
}

// 29 November 2026: "1 seconds".
TEST(NumberText, OneOfAUnitIsSingular) {
  EXPECT_EQ(with_unit("1", "s", Language::en), "1 second");
  EXPECT_EQ(with_unit("1.5", "s", Language::en), "1.5 seconds");
  EXPECT_EQ(with_unit("0", "deg", Language::en), "0 degrees");
  EXPECT_EQ(with_unit("1", "s", Language::de), "1 Sekunde");
  EXPECT_EQ(with_unit("1", "Hz", Language::en), "1 Hz") << "as it is written";
  EXPECT_EQ(with_unit("1", "", Language::en), "1");
}

// 28 November 2026: alternative texts said "8.01e+37" and "-5.66".
TEST(NumberText, HeardNumbersHaveNoZerosBehindThemAndNoSigns) {
  const auto said = [](double value, Language language = Language::en) {
    return short_number_words(value, 3, language);
  };
  EXPECT_EQ(said(0.5), "0.5");
  EXPECT_EQ(said(-5.664), "minus 5.66");
  EXPECT_EQ(said(120), "120");
  EXPECT_EQ(said(0.0025), "0.0025");
  EXPECT_EQ(said(1.7e-5), "1.7 times 10 to the power minus 5");
  EXPECT_EQ(said(8e37), "8 times 10 to the power 37");
  EXPECT_EQ(said(-0.5, Language::de), "minus 0,5");
  EXPECT_EQ(said(-0.0), "0");
  EXPECT_EQ(said(std::numeric_limits<double>::infinity()), "not defined");
}

}  // namespace
}  // namespace polhode
