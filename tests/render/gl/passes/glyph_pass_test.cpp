// SPDX-License-Identifier: MIT
// Type as the renderer draws it, against FreeType's own masks.
#include "render/typeset/math/math.h"
#include "tests/render/gl/drawn.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

using test::Drawn;
using test::shaped;

constexpr Color kBlack{0, 0, 0, 1};

Sheet sheet_of(std::vector<PlacedType> texts) { return {{}, {}, std::move(texts)}; }

PlacedType placed(DisplayList list, const Vec2& at) {
  PlacedType type;
  type.list = std::move(list);
  type.at = at;
  return type;
}

/// 0…255 of the mask at a pixel of the picture, its origin in pixel (x, y).
int ink_at(const GlyphMask& mask, int origin_x, int origin_y, int x, int y) {
  const int column = x - origin_x - mask.left, row = y - origin_y + mask.top;
  if (column < 0 || row < 0 || column >= mask.width || row >= mask.height) return 0;
  return mask.ink[static_cast<std::size_t>(row * mask.width + column)];
}

/// Greatest difference from black ink on white where the mask says.
int worst_against(const GlyphMask& mask, int origin_x, int origin_y, const Image& image) {
  int worst = 0;
  for (int y = 0; y < image.size.height; ++y)
    for (int x = 0; x < image.size.width; ++x)
      worst =
          std::max(worst, std::abs(image.pixel(x, y)[0] - (255 - ink_at(mask, origin_x, origin_y, x, y))));
  return worst;
}

DisplayList rule_of(double x0, double y0, double x1, double y1, double thickness) {
  DisplayList list;
  Rule rule;
  rule.x0 = x0, rule.y0 = y0, rule.x1 = x1, rule.y1 = y1;
  rule.thickness = thickness;
  rule.color = kBlack;
  list.rules.push_back(rule);
  return list;
}

double ink_of(const Image& image) {
  double sum = 0.0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) sum += (255 - image.rgba[i]) / 255.0;
  return sum;
}

double middle_row(const Image& image) {
  double sum = 0.0;
  for (int y = 0; y < image.size.height; ++y)
    for (int x = 0; x < image.size.width; ++x) sum += (y + 0.5) * (255 - image.pixel(x, y)[0]) / 255.0;
  return sum / ink_of(image);
}

TEST(GlyphPass, AGlyphIsFreeTypesMaskToTheLevel) {
  Drawn drawn;
  for (double size : {9.0, 23.0, 31.7, 55.5}) {
    const DisplayList list = shaped(drawn.fonts(), "g", size, kBlack);
    const Glyph& glyph = list.glyphs[0];
    for (int quarter = 0; quarter < 4; ++quarter) {
      const Image image = drawn.draw(sheet_of({placed(list, {30 + 0.25 * quarter, 50})}));
      const GlyphMask mask =
          drawn.fonts().mask(glyph.face, glyph.id, std::round(64.0 * size) / 64.0, 0.25 * quarter, 0.0);
      // Blending rounds once more.
      EXPECT_LE(worst_against(mask, 30, 50, image), 1) << size << " px, " << quarter << " quarters";
    }
  }
}

TEST(GlyphPass, StillBaselinesLieOnWholePixelsAndMovingOnesOnQuarters) {
  Drawn drawn;
  const DisplayList list = shaped(drawn.fonts(), "g", 30, kBlack);
  const auto at = [&](double y, bool moving) {
    PlacedType type = placed(list, {30, y});
    type.moving = moving;
    return drawn.draw(sheet_of({type}));
  };
  EXPECT_EQ(at(49.6, false).rgba, at(50.4, false).rgba);
  const Image still = at(50, false);
  EXPECT_EQ(at(50, true).rgba, still.rgba);
  for (double shift : {0.25, 0.5, 0.75})
    EXPECT_NEAR(middle_row(at(50 + shift, true)), middle_row(still) + shift, 0.02) << "8 bits a pixel";
  EXPECT_EQ(at(50.6, true).rgba, at(50.5, true).rgba);
}

TEST(GlyphPass, ALineLooksTheSameWhereverItStands) {
  Drawn drawn;
  DisplayList list = shaped(drawn.fonts(), "fi", 22, kBlack);
  list.glyphs.back().y = -7.6;
  const Image image = drawn.draw(sheet_of({placed(list, {20.25, 40.0})}));
  const Image lower = drawn.draw(sheet_of({placed(list, {20.25, 43.3})}));
  for (int y = 0; y < 70; ++y)
    for (int x = 0; x < 100; ++x) ASSERT_EQ(image.pixel(x, y)[0], lower.pixel(x, y + 3)[0]);
}

TEST(GlyphPass, LightInkOnDarkIsStrengthenedWhereItIsThin) {
  Drawn drawn;
  const DisplayList list = shaped(drawn.fonts(), "g", 23, {1, 1, 1, 1});
  const Image image = drawn.draw(sheet_of({placed(list, {30, 50})}), "#000000");
  const GlyphMask mask = drawn.fonts().mask(list.glyphs[0].face, list.glyphs[0].id, 23, 0, 0);
  for (int y = 0; y < image.size.height; ++y)
    for (int x = 0; x < image.size.width; ++x) {
      const int ink = ink_at(mask, 30, 50, x, y), shown = image.pixel(x, y)[0];
      if (ink == 0 || ink == 255) {
        EXPECT_EQ(shown, ink);
      } else if (ink > 20 && ink < 235) {
        EXPECT_GT(shown, ink);
      }
    }
}

TEST(GlyphPass, WhatWasDrawnBeforeDoesNotShow) {
  const auto words = [](const Drawn& d, const char* text, double size) {
    PlacedType type = placed(shaped(d.fonts(), text, size, {0.1F, 0.2F, 0.6F, 1}), {3.3, 60.0});
    type.halo = {1, 0.9F, 0.8F, 0.9F};
    return sheet_of({type});
  };
  Drawn one, other;
  const Image first = one.draw(words(one, "rolls", 31), "#204060");
  other.draw(words(other, "slides", 31));
  std::vector<PlacedType> many;
  for (int i = 0; i < 140; ++i)  // more than the atlas holds
    many.push_back(placed(shaped(other.fonts(), "M", 400 + i, kBlack), {0, 40}));
  other.draw(sheet_of(many), "white", {40, 40});
  EXPECT_EQ(other.draw(words(other, "rolls", 31), "#204060").rgba, first.rgba);
}

TEST(GlyphPass, APictureMayNeedMoreThanTheAtlasHolds) {
  Drawn drawn;
  std::vector<PlacedType> texts;
  for (int i = 0; i < 140; ++i)
    texts.push_back(placed(shaped(drawn.fonts(), "M", 400 + i, {0, 0, 0, 0.1F}), {-200.0 + 4 * i, 300.0}));
  const Image first = drawn.draw(sheet_of(texts), "white", {500, 300});
  EXPECT_EQ(drawn.draw(sheet_of(texts), "white", {500, 300}).rgba, first.rgba) << "full elsewhere by now";
  // The last ones were drawn.
  const std::vector<PlacedType> most(texts.begin(), texts.end() - 1);
  EXPECT_NE(drawn.draw(sheet_of(most), "white", {500, 300}).rgba, first.rgba);
}

TEST(GlyphPass, AGlyphMayBeLargerThanTheAtlas) {
  Drawn drawn;
  constexpr double kSize = 8000;
  const DisplayList list = shaped(drawn.fonts(), "M", kSize, kBlack);
  const GlyphMask mask = drawn.fonts().mask(list.glyphs[0].face, list.glyphs[0].id, kSize, 0, 0);
  ASSERT_GT(static_cast<long>(mask.width) * mask.height, 16L << 20);
  // The window looks at each of its quarters.
  for (const Vec2& at : {Vec2(-200, 300), Vec2(-4000, 900), Vec2(-6500, 5300), Vec2(-900, 5200)})
    EXPECT_LE(worst_against(mask, static_cast<int>(at.x()), static_cast<int>(at.y()),
                            drawn.draw(sheet_of({placed(list, at)}), "white", {700, 500})),
              1);
}

TEST(GlyphPass, AHaloSurroundsTheInkAndEndsSoon) {
  Drawn drawn;
  constexpr double kSize = 40;
  PlacedType type = placed(shaped(drawn.fonts(), "l", kSize, kBlack), {50, 60});
  const Image bare = drawn.draw(sheet_of({type}), "#00ff00");
  type.halo = {1, 0, 0, 1};
  const Image haloed = drawn.draw(sheet_of({type}), "#00ff00");
  const double radius = 0.11 * kSize;
  int reds = 0;
  for (int y = 0; y < 80; ++y)
    for (int x = 0; x < 120; ++x) {
      double full = 1e9, any = 1e9;  // distances from ink
      for (int v = std::max(0, y - 8); v < std::min(80, y + 9); ++v)
        for (int u = std::max(0, x - 8); u < std::min(120, x + 9); ++u) {
          const double away = std::hypot(u - x, v - y);
          if (bare.pixel(u, v)[1] < 3) full = std::min(full, away);
          if (bare.pixel(u, v)[1] < 255) any = std::min(any, away);
        }
      const std::uint8_t* p = haloed.pixel(x, y);
      if (full <= radius) {
        EXPECT_LT(p[1], 8) << "no green shines through";
      } else if (any >= radius + 1.0) {
        EXPECT_EQ(p[0], 0);
      }
      reds += p[0] > 200 ? 1 : 0;
    }
  EXPECT_GT(reds, 100);
}

TEST(GlyphPass, HalosLieUnderTheInkOfAll) {
  Drawn drawn;
  PlacedType one = placed(shaped(drawn.fonts(), "M", 40, kBlack), {20, 60});
  PlacedType other = placed(shaped(drawn.fonts(), "M", 40, kBlack), {58, 60});
  const Image bare = drawn.draw(sheet_of({one, other}));
  one.halo = other.halo = {1, 1, 1, 1};
  EXPECT_EQ(drawn.draw(sheet_of({one, other})).rgba, bare.rgba);
}

TEST(GlyphPass, AHaloIsEquallyDenseWhereGlyphsMeet) {
  Drawn drawn;
  PlacedType type = placed(shaped(drawn.fonts(), "illl", 40, {0, 0, 0, 0}), {20, 60});
  type.halo = {1, 1, 1, 0.5F};
  const Image image = drawn.draw(sheet_of({type}), "transparent");
  int most = 0;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) most = std::max<int>(most, image.rgba[i]);
  EXPECT_NEAR(most, 128, 1);
}

TEST(GlyphPass, RulesAlongTheAxesFillWholePixels) {
  Drawn drawn;
  for (double thickness : {0.3, 1.0, 1.3, 1.6, 2.4})
    for (double shift : {0.0, 0.2, 0.5, 0.9}) {
      const int rows = std::max(1, static_cast<int>(std::lround(thickness)));
      const Image flat =
          drawn.draw(sheet_of({placed(rule_of(5, -7.3 + shift, 85, -7.3 + shift, thickness), {20, 40})}));
      const Image upright =
          drawn.draw(sheet_of({placed(rule_of(9.3 + shift, -25, 9.3 + shift, 15, thickness), {20, 40})}));
      int full_rows = 0, full_columns = 0;
      for (int y = 0; y < 80; ++y) full_rows += flat.pixel(60, y)[0] == 0 ? 1 : 0;
      for (int x = 0; x < 120; ++x) full_columns += upright.pixel(x, 40)[0] == 0 ? 1 : 0;
      EXPECT_EQ(full_rows, rows) << thickness << " " << shift;
      EXPECT_EQ(full_columns, rows) << thickness << " " << shift;
      EXPECT_NEAR(ink_of(flat), 80.0 * rows, 0.01 * rows) << "and no pixel in part";
      EXPECT_NEAR(ink_of(upright), 40.0 * rows, 0.01 * rows);
    }
}

TEST(GlyphPass, AFrameIsClosedWhereverItStands) {
  Drawn drawn;
  const auto math = parse_math("\\boxed{x}").value();
  for (double size : {14.0, 21.0, 23.0, 31.0})
    for (double shift : {0.0, 0.15, 0.3, 0.45, 0.6, 0.75, 0.9}) {
      MathStyle style;
      style.size = size;
      DisplayList frame = set_math(math, style, drawn.fonts()).value();
      frame.glyphs.clear();
      const Image image = drawn.draw(sheet_of({placed(frame, {40 + shift, 50 + shift})}));
      int x0 = 120, x1 = 0, y0 = 80, y1 = 0;
      for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 120; ++x)
          if (image.pixel(x, y)[0] < 255)
            x0 = std::min(x0, x), x1 = std::max(x1, x), y0 = std::min(y0, y), y1 = std::max(y1, y);
      for (int x = x0; x <= x1; ++x) {
        ASSERT_EQ(image.pixel(x, y0)[0], 0) << size << " " << shift;
        ASSERT_EQ(image.pixel(x, y1)[0], 0);
      }
      for (int y = y0; y <= y1; ++y) {
        ASSERT_EQ(image.pixel(x0, y)[0], 0);
        ASSERT_EQ(image.pixel(x1, y)[0], 0);
      }
    }
}

TEST(GlyphPass, ObliqueAndMovingRulesCoverWhatTheyCover) {
  Drawn drawn;
  for (double thickness : {0.6, 1.3, 3.0}) {
    const Image oblique = drawn.draw(sheet_of({placed(rule_of(0, 0, 60, -40, thickness), {20, 60})}));
    // Pixels at the edges are told by their distance: a few hundredths of an area at most.
    EXPECT_NEAR(ink_of(oblique), std::hypot(60, 40) * thickness, 0.03 * std::hypot(60, 40) * thickness);
    PlacedType type = placed(rule_of(0, 0, 60, 0, thickness), {20, 30.37});
    type.moving = true;
    const Image moving = drawn.draw(sheet_of({type}));
    EXPECT_NEAR(ink_of(moving), 60 * thickness, 60 * 3 * 0.5 / 255) << "three rows of eight bits";
    for (int y = 28; y < 34; ++y) {
      const double covered =
          std::min(y + 1.0, 30.37 + 0.5 * thickness) - std::max<double>(y, 30.37 - 0.5 * thickness);
      EXPECT_NEAR(255 - moving.pixel(50, y)[0], 255 * std::clamp(covered, 0.0, 1.0), 1.5);
    }
  }
}

TEST(GlyphPass, RulesLieOverGlyphsSoThatTheyCanBeStruckOut) {
  Drawn drawn;
  PlacedType type = placed(shaped(drawn.fonts(), "M", 40, {1, 0, 0, 1}), {20, 60});
  DisplayList struck = rule_of(0, -10, 40, -10, 3);
  type.list.rules = struck.rules;
  const Image image = drawn.draw(sheet_of({type}));
  for (int x = 20; x < 60; ++x) EXPECT_EQ(image.pixel(x, 50)[0], 0);
}

TEST(GlyphPass, OnATransparentSheetAlphaIsTheMaskAndColoursAreStraight) {
  Drawn drawn;
  const DisplayList list = shaped(drawn.fonts(), "g", 40, {0.8F, 0.4F, 0.2F, 1});
  const Image image = drawn.draw(sheet_of({placed(list, {40, 50})}), "transparent");
  const GlyphMask mask = drawn.fonts().mask(list.glyphs[0].face, list.glyphs[0].id, 40, 0, 0);
  for (int y = 0; y < 80; ++y)
    for (int x = 0; x < 120; ++x) {
      const std::uint8_t* p = image.pixel(x, y);
      const int ink = ink_at(mask, 40, 50, x, y);
      // Up to an eighth more where ink is thin: 0.8 0.4 0.2 is of medium brightness.
      EXPECT_GE(p[3], ink - 1);
      EXPECT_LE(p[3], ink + 32);
      if (ink == 0) {
        EXPECT_EQ(p[3], 0);
      }
      if (p[3] == 0) continue;
      const int levels = 1 + 255 / p[3];  // premultiplied colours were rounded to eight bits
      EXPECT_NEAR(p[0], 204, levels);
      EXPECT_NEAR(p[1], 102, levels);
      EXPECT_NEAR(p[2], 51, levels);
    }
}

}  // namespace
}  // namespace polhode
