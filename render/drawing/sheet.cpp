// SPDX-License-Identifier: MIT
#include "render/drawing/sheet.h"

#include <iterator>

namespace polhode {

namespace {

void append(std::vector<FlatShape>& shapes, std::vector<FlatShape>&& part, const Vec2& at) {
  for (FlatShape& shape : part)
    std::visit(
        [&](auto& s) {
          for (Vec2& p : s.points) p += at;
        },
        shape);
  shapes.insert(shapes.end(), std::move_iterator(part.begin()), std::move_iterator(part.end()));
}

}  // namespace

void append(Sheet& sheet, Sheet part, const Vec2& at) {
  append(sheet.shapes, std::move(part.shapes), at);
  append(sheet.over_insets, std::move(part.over_insets), at);
  for (PlacedType& text : part.texts) {
    text.at += at;
    sheet.texts.push_back(std::move(text));
  }
}

}  // namespace polhode
