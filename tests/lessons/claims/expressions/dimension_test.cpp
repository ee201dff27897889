// SPDX-License-Identifier: MIT
#include "lessons/claims/expressions/dimension.h"

#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace polhode {
namespace {

using ::testing::HasSubstr;
using testing::TextReport;

std::string unit(const std::string& text) {
  const auto dimension = dimension_of_unit(text);
  return dimension ? to_string(*dimension) : "?";
}

TEST(Dimension, OfUnits) {
  EXPECT_EQ(unit("kg m²/s"), "kg m²/s");
  EXPECT_EQ(unit("J s"), "kg m²/s");
  EXPECT_EQ(unit("N m"), "kg m²/s²");
  EXPECT_EQ(unit("kg·m^2"), "kg m²");
  EXPECT_EQ(unit("rad/s"), "1/s");
  EXPECT_EQ(unit("1/s²"), "1/s²");
  EXPECT_EQ(unit("W/kg m"), "m/s³");
  EXPECT_EQ(unit("1"), "a number");
  EXPECT_EQ(unit("°"), "a number");
  for (const char* other : {"kJ", "m/s/s", "furlong", "kg m²/s per turn"})
    EXPECT_EQ(unit(other), "?") << other;
}

/// Of the constant c nothing is known, d is a mass.
std::string dimension(const std::string& text) {
  Vocabulary vocabulary;
  vocabulary.add_constant("c", 1, "");
  vocabulary.add_constant("d", 1, "");
  TextReport at(text);
  const auto expression = read_expression(at.text, {1, 1}, at.report, &vocabulary);
  EXPECT_TRUE(expression) << text;
  const DimensionReading reading = dimension_of(*expression, {{1, {1, 0, 0}}});
  if (reading.fault) return std::to_string(reading.fault->begin) + ": " + reading.fault->message;
  return reading.dimension ? to_string(*reading.dimension) : "?";
}

TEST(Dimension, OfWhatPhysicsSays) {
  const std::pair<const char*, const char*> cases[] = {
      {"2*T", "kg m²/s²"},
      {"dot(omega, inertia(omega))", "kg m²/s²"},
      {"ddt(L) - N", "kg m²/s²"},
      {"star(L) + cross(omega, L)", "kg m²/s²"},
      {"(I3 - I1)/I1*w2*w3", "1/s²"},
      {"sqrt(2*T/I1) - w1", "1/s"},
      {"norm(L)/I3", "1/s"},
      {"acos(dot(ez, e3)) + pi", "a number"},
      {"atan2(w1, w2)", "a number"},
      {"d*norm2(v)/2 + T", "kg m²/s²"},
      {"apply(J, omega)", "kg m²/s"},
      {"trace(J)", "kg m²"},
      {"I1^3", "kg³ m^6"},
      {"c*T", "?"},
      {"c*T + T", "kg m²/s²"},
      {"0 + T", "kg m²/s²"},
      {"h*w1", "?"},
  };
  for (const auto& [text, is] : cases) EXPECT_EQ(dimension(text), is) << text;
}

TEST(Dimension, WhatIsAddedHasTheSame) {
  EXPECT_EQ(dimension("T + w1"), "4: units disagree: kg m²/s² and 1/s are added");
  EXPECT_EQ(dimension("L - inertia(ddt(omega))"), "4: units disagree: kg m²/s and kg m²/s² are added");
  EXPECT_EQ(dimension("T + 5"), "4: units disagree: kg m²/s² and a number are added");
  EXPECT_THAT(dimension("sin(w1)"), HasSubstr("a function of numbers is taken of 1/s"));
  EXPECT_THAT(dimension("atan2(w1, I1)"), HasSubstr("make no angle"));
}

TEST(Dimensions, UnitsOfPlotsHaveSizes) {
  const auto size = [](const char* unit) {
    const auto read = scaled_unit(unit);
    return read ? read->size : 0.0;
  };
  constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();
  for (const auto& [unit, si] :
       std::vector<std::pair<const char*, double>>{{"J", 1},
                                                   {"mJ", 1e-3},
                                                   {"kN m", 1e3},
                                                   {"g", 1e-3},
                                                   {"mg m²/s", 1e-6},
                                                   {"mm²", 1e-6},
                                                   {"µs", 1e-6},
                                                   {"μs", 1e-6},
                                                   {"m/ms", 1e3},
                                                   {"deg", std::numbers::pi / 180},
                                                   {"deg/s", std::numbers::pi / 180}})
    EXPECT_NEAR(size(unit), si, kRounding * si) << unit;
  EXPECT_EQ(scaled_unit("mJ")->dimension, dimension_of_unit("J"));
  EXPECT_EQ(scaled_unit("kg")->size, 1) << "the gram has the prefix";
  for (const char* none : {"ells", "kkg", "mdeg", "xJ", "m/s/s", "k"})
    EXPECT_FALSE(scaled_unit(none)) << none;
  EXPECT_FALSE(dimension_of_unit("mJ")) << "units of symbols are those of SI";
}

}  // namespace
}  // namespace polhode
