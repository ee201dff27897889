// SPDX-License-Identifier: MIT
// Texts on a sheet, found by what they were set from.
#pragma once

#include "render/drawing/label_layout.h"
#include "render/drawing/sheet.h"
#include "render/typeset/fonts.h"

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

inline const Fonts& fonts() {
  static const Fonts kFonts = Fonts::open().value();
  return kFonts;
}

inline PixelBox box_of(const PlacedType& type) {
  const TypeBox ink = ink_box(type.list, fonts());
  return {type.at.x() + ink.x0, type.at.y() + ink.y0, type.at.x() + ink.x1, type.at.y() + ink.y1};
}

inline std::vector<const PlacedType*> texts_of(const Sheet& sheet, std::string_view text) {
  std::vector<const PlacedType*> found;
  for (const PlacedType& type : sheet.texts)
    if (type.text == text) found.push_back(&type);
  return found;
}

inline const PlacedType& only_text(const Sheet& sheet, std::string_view text) {
  const auto found = texts_of(sheet, text);
  if (found.size() != 1)
    throw std::runtime_error(std::string(text) + " stands there " + std::to_string(found.size()) + " times");
  return *found.front();
}

}  // namespace polhode
