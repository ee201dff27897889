// SPDX-License-Identifier: MIT
#include "render/typeset/display_list.h"

#include <algorithm>

namespace polhode {

std::int16_t index_of(DisplayList& list, std::string_view name) {
  const auto found = std::find(list.names.begin(), list.names.end(), name);
  if (found == list.names.end()) {
    list.names.emplace_back(name);
    return static_cast<std::int16_t>(list.names.size() - 1);
  }
  return static_cast<std::int16_t>(found - list.names.begin());
}

void append(DisplayList& list, const DisplayList& part, double x, double y) {
  std::vector<std::int16_t> place;
  for (const std::string& name : part.names) place.push_back(index_of(list, name));
  const auto renamed = [&](Naming naming) {
    const auto moved = [&](std::int16_t i) { return i < 0 ? i : place[static_cast<std::size_t>(i)]; };
    return Naming{moved(naming.term), moved(naming.symbol)};
  };
  for (Glyph glyph : part.glyphs) {
    glyph.x += x;
    glyph.y += y;
    glyph.naming = renamed(glyph.naming);
    list.glyphs.push_back(glyph);
  }
  for (Rule rule : part.rules) {
    rule.x0 += x;
    rule.x1 += x;
    rule.y0 += y;
    rule.y1 += y;
    rule.naming = renamed(rule.naming);
    list.rules.push_back(rule);
  }
}

}  // namespace polhode
