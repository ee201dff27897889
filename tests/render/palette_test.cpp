// SPDX-License-Identifier: MIT
#include "render/palette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

/// Relative luminance and contrast of WCAG 2.1.
double luminance(const Color& c) {
  const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
}
double contrast(const Color& a, const Color& b) {
  const double la = luminance(a), lb = luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

TEST(Palette, InksAreReadableOnPaper) {
  for (const Role& role : {kOmegaRole, kLRole, kNRole, kPolhodeRole, kHerpolhodeRole, kAxesRole})
    EXPECT_GE(contrast(role.ink, kPaper), 5.2);
  for (const Role& role : kMarkRoles) EXPECT_GE(contrast(role.ink, kPaper), 5.2);
  for (const Role& role : kBodyAxisRoles) EXPECT_GE(contrast(role.ink, kPaper), 5.2);
}

TEST(Palette, FamilyColorsDifferFromOneSideToTheOther) {
  EXPECT_EQ(family_color(-1.0), family_color(0.0));
  EXPECT_EQ(family_color(2.0), family_color(1.0));
  EXPECT_NE(family_color(0.0), family_color(1.0));
  // No jump: a hundredth of the scale changes a channel by less than a tenth.
  for (int i = 0; i < 100; ++i) {
    const Color a = family_color(i / 100.0), b = family_color((i + 1) / 100.0);
    EXPECT_LT(std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b), 0.1F);
  }
}

}  // namespace
}  // namespace polhode
