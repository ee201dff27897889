// SPDX-License-Identifier: MIT
#include "render/palette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

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

/// What lines and arrows in space are painted with.
std::vector<Color> paints() {
  std::vector<Color> all = {kSeparatrixPaint};
  for (const Role& role : {kOmegaRole, kLRole, kNRole, kPolhodeRole, kHerpolhodeRole, kTRole, kAxesRole})
    all.push_back(role.paint);
  for (const Role& role : kMarkRoles) all.push_back(role.paint);
  for (const Role& role : kBodyAxisRoles) all.push_back(role.paint);
  for (const double place : {0.0, 0.25, 0.5, 0.75, 1.0}) all.push_back(family_color(place));
  return all;
}

// 26 November 2026: a black arrow had 1.4:1 on the dark theme, one of L under the plane as little.
TEST(Palette, PaintsAreSeenOnDarkGroundAndBehindGlass) {
  constexpr double kShaded = 0.9;                           // of its light, in the mean over a lit tube
  constexpr double kNearSide = 0.17;                        // opacity of the glass in front, glass.glsl
  constexpr Color kGlassOnDark = color_from_hex(0x3D4B56);  // as it is seen
  const auto mixed = [](const Color& a, const Color& b, double share) {
    const auto of = [&](float x, float y) {
      return static_cast<float>(std::lerp(double{x}, double{y}, share));
    };
    return Color{of(a.r, b.r), of(a.g, b.g), of(a.b, b.b)};
  };
  for (const Color& paint : paints()) {
    const Color shown = paint_on_dark(paint), shaded = mixed({0, 0, 0}, shown, kShaded);
    EXPECT_GE(contrast(shaded, kDarkGround), 3.0) << paint.r << ' ' << paint.g << ' ' << paint.b;
    EXPECT_GE(contrast(mixed(shaded, kGlassTint, kNearSide), kGlassOnDark), 3.0)
        << paint.r << ' ' << paint.g << ' ' << paint.b;
    EXPECT_GE(luminance(shown), luminance(paint)) << "none is made darker";
  }
}

TEST(Palette, BlackIsLightOnDarkGround) {
  EXPECT_GE(contrast(paint_on_dark(kTRole.paint), kDarkGround), contrast(kTRole.paint, kPaper));
}

TEST(Palette, PaintsAreSeenOnPaper) {
  for (const Color& paint : paints()) EXPECT_GE(contrast(paint, kPaper), 3.0);
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
