// SPDX-License-Identifier: MIT
#include "render/drawing/fade.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

constexpr Color kInk{0.25F, 0.5F, 0.75F, 1.0F}, kGlass{0.25F, 0.5F, 0.75F, 0.5F};

Sheet of_everything() {
  Sheet sheet;
  sheet.shapes = {Stroke{.points = {{0, 0}, {9, 9}}, .width = 2, .color = kInk},
                  Area{{{0, 0}, {1, 0}, {1, 1}}, kGlass}};
  sheet.over_insets = {Area{{{0, 0}, {1, 0}, {1, 1}}, kInk}};
  PlacedType type;
  type.list.glyphs.push_back({.id = 7, .x = 3, .color = kInk, .naming = {}, .source = {}});
  type.list.rules.push_back({.x1 = 5, .color = kGlass, .naming = {}, .source = {}});
  type.at = {4, 5};
  type.halo = kGlass;
  sheet.texts = {type};
  return sheet;
}

TEST(Fade, AllAlphasAreMultipliedAndNothingElse) {
  const Sheet half = faded(of_everything(), 0.5);
  const auto& stroke = std::get<Stroke>(half.shapes.at(0));
  EXPECT_EQ(stroke.color, (Color{0.25F, 0.5F, 0.75F, 0.5F}));
  EXPECT_EQ(stroke.points.size(), 2u);
  EXPECT_EQ(std::get<Area>(half.shapes.at(1)).color.a, 0.25F);
  EXPECT_EQ(std::get<Area>(half.over_insets.at(0)).color.a, 0.5F);
  const PlacedType& type = half.texts.at(0);
  EXPECT_EQ(type.halo.a, 0.25F);
  EXPECT_EQ(type.list.glyphs.at(0).color, (Color{0.25F, 0.5F, 0.75F, 0.5F}));
  EXPECT_EQ(type.list.glyphs.at(0).x, 3);
  EXPECT_EQ(type.list.rules.at(0).color.a, 0.25F);
  EXPECT_EQ(type.at, Vec2(4, 5));
}

TEST(Fade, WholeAtOneAndEmptyAtZero) {
  const Sheet whole = faded(of_everything(), 1.0), none = faded(of_everything(), 0.0);
  EXPECT_EQ(whole.texts.at(0).list, of_everything().texts.at(0).list);
  EXPECT_EQ(std::get<Area>(whole.shapes.at(1)).color, kGlass);
  EXPECT_TRUE(none.shapes.empty() && none.over_insets.empty() && none.texts.empty());
}

}  // namespace
}  // namespace polhode
