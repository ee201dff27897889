// SPDX-License-Identifier: MIT
#include "lessons/claims/answers/number_answer.h"

#include "base/numbers.h"
#include "lessons/claims/answers/answers.h"
#include "lessons/claims/expressions/dimension.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace polhode {
namespace {

using ::testing::HasSubstr;
using Mark = AnswerJudgement::Mark;

NumberAnswer number(double value, const std::string& unit, double within = 0.02) {
  NumberAnswer answer;
  answer.value = value;
  answer.unit = unit;
  answer.unit_si = scaled_unit(unit).value().size;
  answer.within = within;
  return answer;
}

struct Typed {
  double right;
  const char *unit, *typed;
};
void PrintTo(const Typed& one, std::ostream* out) { *out << one.typed << " for " << one.right << one.unit; }

class RightNumbers : public ::testing::TestWithParam<Typed> {};
TEST_P(RightNumbers, AreRightInEveryForm) {
  const auto& [right, unit, typed] = GetParam();
  const AnswerJudgement judgement = judge_number(number(right, unit), typed);
  EXPECT_EQ(judgement.mark, Mark::right) << judgement.reason;
}
INSTANTIATE_TEST_SUITE_P(
    All, RightNumbers,
    ::testing::Values(
        Typed{4.2, "J", "4.2"}, Typed{4.2, "J", " 4.2 J "}, Typed{4.2, "J", "4200 mJ"},
        Typed{4.2, "J", "4.2 N m"}, Typed{4.2, "J", "4.2kg m^2/s^2"}, Typed{1200, "m", "1.2e3"},
        Typed{1200, "m", "1.2·10^3 m"}, Typed{1200, "m", "1.2 x 10^3"}, Typed{1200, "m", "1.2*10^{3} m"},
        Typed{0.0012, "s", "1.2×10^-3"}, Typed{0.0012, "s", "1.2 ms"}, Typed{90, "s", "1.5 min"},
        Typed{-3, "rad/s", "-3"}, Typed{-3, "rad/s", "−3.0 rad/s"}, Typed{std::numbers::pi, "rad", "180 deg"},
        Typed{90, "deg", "1.57 rad"}, Typed{90, "deg", "90°"},
        Typed{10 * std::numbers::pi, "rad/s", "300 rpm"}, Typed{5, "Hz", "300 rpm"}, Typed{5, "Hz", "5 1/s"},
        Typed{0.25, "1", "25 %"}, Typed{0.25, "1", ".25"}, Typed{2, "1", "+2."}, Typed{4.2, "J", "4.2 Nm"},
        Typed{4.2, "J", "4.2 J."}, Typed{4.2, "J", "4.2 Ws"}, Typed{4.2, "J", "4.2 kg m2/s2"},
        Typed{4.2, "J", "4.2 kg m2 s-2"}, Typed{4.2, "J", "4.2 kgm² s⁻²"}, Typed{4.2, "J", "4.2 kg m²s⁻²"},
        Typed{4.2, "J", "4.2 kgm2s-2"}, Typed{4.2, "J", "4200000 uJ"}, Typed{7.2e6, "J", "2 kWh"},
        Typed{4.2, "J", "4.2 N*m"}, Typed{42000, "J", "4.2 × 10⁴ J"}, Typed{4200, "J", "4.2·10^3"},
        Typed{4200, "J", "4.2⋅10³J"}, Typed{0.0042, "J", "4.2×10⁻³"}, Typed{4200, "J", "4.2*10**3"},
        Typed{3, "rad/s", "3 s^-1"}, Typed{3, "rad/s", "3 s⁻¹"}, Typed{3, "rad/s", "3 s^(-1)"},
        Typed{3, "rad/s", "180 1/min"}, Typed{3, "rad/s", "180 rad/min"}, Typed{5, "Hz", "300 /min"},
        Typed{5, "Hz", "300 rev/min"}, Typed{90, "deg", "0.25 rev"}, Typed{0.1, "1/s", "0.1 rad/s"},
        Typed{2, "1", "2 m/m"}));

struct Slipped {
  double right;
  const char *unit, *typed, *reason;
};
void PrintTo(const Slipped& one, std::ostream* out) { *out << one.typed << " for " << one.right << one.unit; }

class NumberSlips : public ::testing::TestWithParam<Slipped> {};
TEST_P(NumberSlips, AreNamed) {
  const auto& [right, unit, typed, reason] = GetParam();
  const AnswerJudgement judgement = judge_number(number(right, unit), typed);
  EXPECT_EQ(judgement.mark, Mark::wrong);
  EXPECT_THAT(judgement.reason, HasSubstr(reason));
}
INSTANTIATE_TEST_SUITE_P(
    All, NumberSlips,
    ::testing::Values(
        Slipped{4.2, "J", "4.2 kg m²/s",
                "of another kind: an answer in J is asked for, and this is in kg m²/s"},
        Slipped{4.2, "J", "4.2 W", "of another kind"},
        Slipped{0.3, "1", "0.3 s", "a number without a unit is asked for"},
        Slipped{4.2, "J", "-4.2", "wrong sign"}, Slipped{4.2, "J", "4200", "factor of 1000"},
        Slipped{4.2, "J", "4.2 kJ", "too large by a factor of 1000"},
        Slipped{4.2, "J", "0.42", "too small by a factor of 10"},
        Slipped{4.2, "J", "42000000", "too large by a factor of 10^7"},
        Slipped{0.7, "rad", "40.1", "these are degrees"}, Slipped{40.1, "deg", "0.7", "these are radians"},
        Slipped{12.566, "rad/s", "2", "too small by 2π"}, Slipped{2, "Hz", "12.57", "too large by 2π"},
        Slipped{12.566, "rad/s", "2 Hz", "Hz counts turns"},
        Slipped{2, "Hz", "12.57 rad/s", "rad/s counts angles"},
        Slipped{4.2, "J", "8.4", "twice what is right"}, Slipped{4.2, "J", "2.1", "half of what is right"},
        Slipped{4.2, "J", "4", "rounded too coarsely: it has to be right to 2 %"},
        Slipped{0.7, "1", "0.7 rad", "a number without a unit is asked for, and this is in rad"},
        Slipped{0.7, "1", "40.1 deg", "of another kind"}, Slipped{0.7, "", "40.1°", "of another kind"},
        Slipped{0.5, "1", "0.0796 rev", "of another kind"}, Slipped{4.2, "J", "4.2 J rad", "of another kind"},
        Slipped{4.2, "kg", "4.2 kg/rad", "of another kind"},
        Slipped{3, "rad/s", "3 rad^2/s", "of another kind"}, Slipped{22, "deg", "38.4 %", "of another kind"},
        Slipped{0.7, "1", "40.1", "too large"}, Slipped{4.2, "J", "26.389", "too large"},
        Slipped{4.2, "J", "0.66845", "too small"}, Slipped{2, "s", "12.566", "too large by 2π"},
        Slipped{4.2, "J", "7", "too large"}, Slipped{4.2, "J", "3.3", "too small"},
        Slipped{4.2, "J", "-7", "neither the sign nor the size"}, Slipped{4.2, "J", "0", "it is not 0"}));

struct Unread {
  const char *typed, *reason;
  int column;
};
void PrintTo(const Unread& one, std::ostream* out) { *out << one.typed; }

class UnreadNumbers : public ::testing::TestWithParam<Unread> {};
TEST_P(UnreadNumbers, SayWhyAndWhere) {
  const auto& [typed, reason, column] = GetParam();
  const AnswerJudgement judgement = judge_number(number(4.2, "J"), typed);
  EXPECT_EQ(judgement.mark, Mark::unreadable);
  EXPECT_THAT(judgement.reason, HasSubstr(reason));
  EXPECT_EQ(judgement.column, column);
}
INSTANTIATE_TEST_SUITE_P(
    All, UnreadNumbers,
    ::testing::Values(Unread{"", "a number is asked for", 0}, Unread{"  ", "a number is asked for", 0},
                      Unread{"4,2", "a comma is not read", 2}, Unread{"1,000 J", "a comma is not read", 2},
                      Unread{"four", "no number", 1}, Unread{"nan", "no number", 1},
                      Unread{"inf", "no number", 1}, Unread{"x.xx", "no number", 1},
                      Unread{"4.2 furlong", "unknown unit \"furlong\"", 5},
                      Unread{"4.2 + 1", "nothing is computed here", 5},
                      Unread{"4.2/2", "nothing is computed here", 4},
                      Unread{"4.2 4", "nothing is computed here", 5}, Unread{"1e999", "too large", 0},
                      Unread{"1e-999", "too small", 0}, Unread{"4.2 J/", "unknown unit \"J/\"", 5},
                      Unread{"4.2 J//s", "unknown unit", 5}, Unread{"4.2 m/s/s", "unknown unit", 5},
                      Unread{"4.2 hJ", "unknown unit", 5}, Unread{"4.2 Grad", "unknown unit", 5},
                      Unread{"4.2 krad/s", "unknown unit", 5}, Unread{"4.2 J^0", "unknown unit", 5},
                      Unread{"4.2 1", "nothing is computed here", 5}, Unread{"e3", "no number", 1},
                      Unread{"−−4", "no number", 2}));

TEST(NumberAnswer, IsRightWithinItsToleranceAndNotBeyond) {
  for (const double value : {4.2, -0.003, 7e9}) {
    const NumberAnswer answer = number(value, "J", 0.01);
    for (const double off : {0.0, 0.5, -0.99})
      EXPECT_EQ(judge_number(answer, digits17(value * (1 + 0.01 * off))).mark, Mark::right);
    for (const double off : {1.01, -1.5})
      EXPECT_EQ(judge_number(answer, digits17(value * (1 + 0.01 * off))).mark, Mark::wrong);
  }
  NumberAnswer absolute = number(40, "deg", 0.5);
  absolute.is_relative = false;
  EXPECT_EQ(judge_number(absolute, "40.5").mark, Mark::right) << "the edge belongs to it";
  EXPECT_EQ(judge_number(absolute, "40.51").mark, Mark::wrong);
}

TEST(NumberAnswer, WithoutAValueIsNotJudged) {
  EXPECT_EQ(judge_number(NumberAnswer(), "4.2").mark, Mark::unreadable);
  EXPECT_EQ(words_of(NumberAnswer()), "");
}

TEST(NumberAnswer, IsSaidWithTheDigitsItsToleranceLeaves) {
  EXPECT_EQ(words_of(number(4.18879, "rad/s")), "4.19 rad/s");
  EXPECT_EQ(words_of(number(4.18879, "rad/s", 0.0001)), "4.18879 rad/s");
  EXPECT_EQ(words_of(number(4188.79, "1")), "4189 1");
  EXPECT_EQ(words_of(number(35.57, "deg")), "35.6°");
  NumberAnswer alone;
  alone.value = -0.51234;
  EXPECT_EQ(words_of(alone), "-0.512");
}

TEST(NumberAnswer, OfAnyBytesIsReadOrRefusedAtOnce) {
  std::mt19937 random(7);
  const std::string letters = "0123456789+-.,eE x·×*^10{}()radsJmHz°% µ\xff";
  int read = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string typed;
    for (std::size_t n = random() % 12; n > 0; --n) typed += letters[random() % letters.size()];
    const AnswerJudgement judgement = judge_number(number(4.2, "J"), typed);
    if (judgement.mark != Mark::unreadable) ++read;
    EXPECT_EQ(judgement.reason.empty(), judgement.mark == Mark::right) << typed;
  }
  EXPECT_GT(read, 100) << "numbers are among them";
  EXPECT_EQ(judge_number(number(4.2, "J"), std::string(100000, '4')).mark, Mark::unreadable);
}

}  // namespace
}  // namespace polhode
