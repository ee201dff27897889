// SPDX-License-Identifier: MIT
#include "physics/body/principal_moments.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace polhode {
namespace {

using testing::HasSubstr;

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kMax = std::numeric_limits<double>::max();
constexpr double kTiny = std::numeric_limits<double>::denorm_min();

struct Case {
  const char* what;
  double I1, I2, I3;
  const char* message;  // part of it; nullptr: the body is possible
};

class Validation : public testing::TestWithParam<Case> {};

TEST_P(Validation, OfMoments) {
  const Case& c = GetParam();
  const auto why = why_impossible(c.I1, c.I2, c.I3);
  if (c.message == nullptr) {
    EXPECT_EQ(why, std::nullopt) << *why;
    EXPECT_NO_THROW(PrincipalMoments(c.I1, c.I2, c.I3));
    return;
  }
  ASSERT_TRUE(why.has_value());
  EXPECT_THAT(*why, HasSubstr(c.message));
  EXPECT_THROW(PrincipalMoments(c.I1, c.I2, c.I3), std::domain_error);
}

// ε = 2⁻⁵³; one step of a double in [1, 2) is 2ε, so 4ε over a sum of 1 is two steps.
INSTANTIATE_TEST_SUITE_P(
    Table, Validation,
    testing::Values(
        Case{"ordinary", 1.0, 1.75, 2.5, nullptr}, Case{"sphere", 2, 2, 2, nullptr},
        Case{"flat, exact", 1, 2, 3, nullptr},
        Case{"flat in decimal, sum rounds down", 0.1, 0.7, 0.8, nullptr},
        Case{"flat in decimal", 0.1, 0.2, 0.3, nullptr}, Case{"needle", 1, 1, 1e-300, nullptr},
        Case{"needle, smallest number", 1, kTiny, 1, nullptr},
        Case{"largest numbers", kMax, kMax, kMax, nullptr},
        Case{"smallest numbers", kTiny, kTiny, kTiny, nullptr},
        Case{"flat, smallest numbers", kTiny, kTiny, 2 * kTiny, nullptr},
        Case{"largest over smallest sum", 3 * kTiny, kTiny, kTiny, "I1 = 1.5e-323 exceeds I2 + I3 = 1e-323"},
        Case{"4ε over", 0.5, 0.5, 1 + 0x1p-51, nullptr},
        Case{"6ε over", 0.5, 0.5, 1 + 0x1.8p-51, "I3 = 1.0000000000000007 exceeds I1 + I2 = 1"},
        Case{"4ε over, huge", 0x1p1022, 0x1p1022, 0x1p1023 * (1 + 0x1p-51), nullptr},
        Case{"6ε over, huge", 0x1p1022, 0x1p1022, 0x1p1023 * (1 + 0x1.8p-51), "exceeds"},
        Case{"impossible", 1, 1.75, 3.1,
             "I3 = 3.1 exceeds I1 + I2 = 2.75: no rigid body has these moments (each must"},
        Case{"a sum of many digits", 1, 3, 0.0077533333333333334, "I2 = 3 exceeds I1 + I3 = 1.00775:"},
        Case{"impossible first", 9, 1, 2, "I1 = 9 exceeds I2 + I3 = 3"},
        Case{"impossible middle", 1, 9, 2, "I2 = 9 exceeds I1 + I3 = 3"},
        Case{"zero", 0, 1, 1, "I1 = 0 is not positive"},
        Case{"minus zero", 1, -0.0, 1, "I2 = -0 is not positive"},
        Case{"negative", 1, 1, -2, "I3 = -2 is not positive"},
        Case{"nan", 1, kNaN, 1, "I2 = nan is not finite"},
        Case{"infinite", kInf, kInf, 1, "I1 = inf is not finite"}),
    [](const auto& named) { return "Case" + std::to_string(named.index); });

TEST(PrincipalMoments, AreKeptAsGivenInAnyOrder) {
  const PrincipalMoments I(2.5, 1.0, 1.75);
  EXPECT_EQ(I[0], 2.5);
  EXPECT_EQ(I[1], 1.0);
  EXPECT_EQ(I[2], 1.75);
  EXPECT_EQ(I.vector(), Vec3(2.5, 1.0, 1.75));
  EXPECT_TRUE(I == PrincipalMoments(2.5, 1.0, 1.75));
  EXPECT_FALSE(I == PrincipalMoments(1.0, 2.5, 1.75));
}

TEST(PrincipalMoments, ExceptionCarriesTheInequality) {
  try {
    PrincipalMoments(1, 1, 5);
    FAIL();
  } catch (const std::domain_error& e) {
    EXPECT_THAT(e.what(), HasSubstr("I3 = 5 exceeds I1 + I2 = 2"));
  }
}

}  // namespace
}  // namespace polhode
