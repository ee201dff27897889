// SPDX-License-Identifier: MIT
// What tests of pages ask of a sheet.
#pragma once

#include "render/drawing/label_layout.h"
#include "render/drawing/sheet.h"
#include "render/typeset/fonts.h"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace polhode {

inline const Fonts& test_fonts() {
  static const Fonts kFonts = Fonts::open().value();
  return kFonts;
}

/// Of the ink on the sheet.
inline PixelBox box_of(const PlacedType& text) {
  const TypeBox ink = ink_box(text.list, test_fonts());
  return {text.at.x() + ink.x0, text.at.y() + ink.y0, text.at.x() + ink.x1, text.at.y() + ink.y1};
}

inline PixelBox box_of(const FlatShape& shape) {
  const auto& points = std::visit([](const auto& s) -> const std::vector<Vec2>& { return s.points; }, shape);
  PixelBox box{1e9, 1e9, -1e9, -1e9};
  for (const Vec2& p : points)
    box = {std::min(box.x0, p.x()), std::min(box.y0, p.y()), std::max(box.x1, p.x()),
           std::max(box.y1, p.y())};
  const auto* stroke = std::get_if<Stroke>(&shape);
  return stroke ? box.grown(0.5 * stroke->width) : box;
}

inline bool is_within(const PixelBox& box, const PixelBox& room) {
  return box.x0 >= room.x0 && box.y0 >= room.y0 && box.x1 <= room.x1 && box.y1 <= room.y1;
}

inline Color color_of(const FlatShape& shape) {
  return std::visit([](const auto& s) { return s.color; }, shape);
}

/// Boxes of the areas of a colour.
inline std::vector<PixelBox> areas_of(const Sheet& sheet, const Color& color) {
  std::vector<PixelBox> boxes;
  for (const FlatShape& shape : sheet.shapes)
    if (std::holds_alternative<Area>(shape) && color_of(shape) == color) boxes.push_back(box_of(shape));
  return boxes;
}

/// What is set, wherever it stands.
using Letters = std::vector<std::pair<Face, std::uint32_t>>;
inline Letters letters_of(const DisplayList& list) {
  Letters letters;
  for (const Glyph& glyph : list.glyphs) letters.emplace_back(glyph.face, glyph.id);
  return letters;
}

inline bool same(const FlatShape& a, const FlatShape& b) {
  if (a.index() != b.index()) return false;
  if (const auto* area = std::get_if<Area>(&a))
    return area->points == std::get<Area>(b).points && area->color == std::get<Area>(b).color;
  const Stroke &s = std::get<Stroke>(a), &t = std::get<Stroke>(b);
  return s.points == t.points && s.width == t.width && s.color == t.color && s.dash == t.dash;
}
inline bool same(const std::vector<FlatShape>& a, const std::vector<FlatShape>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const FlatShape& x, const FlatShape& y) { return same(x, y); });
}
inline bool same(const Sheet& a, const Sheet& b) {
  return same(a.shapes, b.shapes) && same(a.over_insets, b.over_insets) &&
         std::equal(a.texts.begin(), a.texts.end(), b.texts.begin(), b.texts.end(),
                    [](const PlacedType& x, const PlacedType& y) {
                      return x.list == y.list && x.at == y.at && x.halo == y.halo && x.moving == y.moving;
                    });
}

}  // namespace polhode
