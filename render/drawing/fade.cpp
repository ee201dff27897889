// SPDX-License-Identifier: MIT
#include "render/drawing/fade.h"

namespace polhode {

namespace {

void fade(Color& color, double opacity) { color.a = static_cast<float>(color.a * opacity); }

void fade(std::vector<FlatShape>& shapes, double opacity) {
  for (FlatShape& shape : shapes) std::visit([&](auto& s) { fade(s.color, opacity); }, shape);
}

}  // namespace

Sheet faded(Sheet sheet, double opacity) {
  if (opacity >= 1.0) return sheet;
  if (opacity <= 0.0) return {};
  fade(sheet.shapes, opacity);
  fade(sheet.over_insets, opacity);
  for (PlacedType& text : sheet.texts) {
    fade(text.halo, opacity);
    for (Glyph& glyph : text.list.glyphs) fade(glyph.color, opacity);
    for (Rule& rule : text.list.rules) fade(rule.color, opacity);
  }
  return sheet;
}

}  // namespace polhode
