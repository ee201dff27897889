// SPDX-License-Identifier: MIT
#include "lessons/notation/tex_numbers.h"

#include "lessons/notation/tex_sides.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::HasSubstr;

NumbersInFormula numbers_of(const std::string& tex, const char* above = nullptr) {
  const Math math = parse_math(tex).value();
  const auto before = above == nullptr ? std::nullopt : std::optional(parse_math(above).value());
  auto read = read_numbers(math, {}, before ? &*before : nullptr);
  EXPECT_TRUE(read) << tex << ": " << (read ? "" : read.error().reason);
  return read ? std::move(read).value() : NumbersInFormula();
}

std::string why_not(const std::string& tex) {
  const auto read = read_numbers(parse_math(tex).value(), {});
  return read ? "" : read.error().reason;
}

TEST(NumbersInAFormula, StandAloneOrAreComparedWithWhatIsRead) {
  const NumbersInFormula alone = numbers_of("\\Delta t = \\live{T},\\quad \\live{w1}");
  EXPECT_TRUE(alone.statements.empty()) << "nothing says what Δt is";
  EXPECT_EQ(alone.last, 1U);
  EXPECT_EQ(alone.first, std::nullopt);
  const NumbersInFormula both = numbers_of("x = I_1 = \\live{I1/I3}\\,I_3");
  ASSERT_EQ(both.statements.size(), 1U);
  EXPECT_EQ(both.statements[0].equality.left.text, "I1");
  EXPECT_EQ(both.statements[0].right, std::nullopt) << "a factor stands beside it";
  EXPECT_EQ(numbers_of("\\live{T}").first, 0U);
}

TEST(NumbersInAFormula, KeepTheirUnits) {
  const NumbersInFormula printed = numbers_of("\\live{norm2(L)}\\,\\mathrm{kg^2\\,m^4/s^2}");
  ASSERT_EQ(printed.units.size(), 1U);
  EXPECT_EQ(printed.units[0].unit, "kg^2 m^4/s^2");
  EXPECT_EQ(numbers_of("\\live{w1}\\ \\text{s}^{-1}").units.at(0).unit, "1/s");
  EXPECT_EQ(numbers_of("(\\live{w1}, \\live{w2})\\,\\text{rad/s}").units.size(), 2U) << "of each of them";
  EXPECT_TRUE(numbers_of("\\live[unit={J}]{T}").units.empty()) << "its own";
}

TEST(NumbersInAFormula, GoOnFromTheFormulaAbove) {
  EXPECT_TRUE(numbers_of("= \\live{T}\\,\\text{J}").statements.empty());
  const NumbersInFormula read = numbers_of("= \\live{T}\\,\\text{J}", "T");
  ASSERT_EQ(read.statements.size(), 1U);
  EXPECT_EQ(read.statements[0].equality.left.text, "T");
}

TEST(NumbersInAFormula, AreRefusedWhereTheirNeighboursMakeThemOthers) {
  for (const char* tex :
       {"2\\live{T}", "-\\live{T}", "\\live{T}^2", "\\sqrt{\\live{T}}", "\\live{T}!", "T_{\\live{T}}",
        "\\text{twice }\\live{T}", "T \\sim \\live{T}", "\\cancel{\\live{T}}"})
    EXPECT_NE(why_not(tex), "") << tex;
  EXPECT_THAT(why_not("2\\live{T}"), HasSubstr("a number stands behind a factor"));
}

TEST(NumbersInAFormula, AreComponentsOfAVector) {
  const NumbersInFormula read = numbers_of("\\vec\\omega = (\\live{w1}, 0, \\live{w3})");
  ASSERT_EQ(read.components.size(), 1U);
  EXPECT_EQ(read.components[0].on_body.size(), 3U);
  EXPECT_EQ(read.components[0].on_body[2].left.text, "dot(omega, e3)");
  EXPECT_EQ(read.components[0].on_space[0].left.text, "dot(omega, ex)");
}

TEST(ASideAlone, IsReadAsAnExpression) {
  EXPECT_EQ(read_side(parse_math("2T").value(), {}).value().text, "2*T");
  EXPECT_FALSE(read_side(parse_math("2T = 3").value(), {}));
  const auto in_unit = read_in_unit(parse_math("T/\\text{kJ}").value(), {});
  ASSERT_TRUE(in_unit);
  EXPECT_EQ(in_unit->second, "kJ");
  EXPECT_EQ(read_unit_formula(parse_math("\\text{kg m}^2/\\text{s}").value()), "kg m^2/s");
}

}  // namespace
}  // namespace polhode
