// SPDX-License-Identifier: MIT
#include "render/drawing/type_grid.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace polhode {
namespace {

constexpr double kHalo = 0.11;  // em

int whole(double value) { return static_cast<int>(std::floor(value + 0.5)); }

/// Middle and half of the thickness of a rule that covers whole pixels.
std::pair<double, double> snapped(double middle, double thickness) {
  const int pixels = std::max(1, whole(thickness));
  return {whole(middle - 0.5 * pixels) + 0.5 * pixels, 0.5 * pixels};
}

}  // namespace

double row_of(double y, const PlacedType& type) {
  return type.moving ? type.at.y() + y : whole(type.at.y()) + whole(y);
}

GridGlyph on_grid(const Glyph& glyph, const PlacedType& type) {
  const int across = whole(4.0 * (type.at.x() + glyph.x)), down = whole(4.0 * row_of(glyph.y, type));
  return {across >> 2, down >> 2, across & 3, down & 3, whole(64.0 * glyph.size), glyph.face, glyph.id};
}

double RuleBox::coverage(const Vec2& p) const {
  const Vec2 d = p - middle;
  const Vec2 local(d.dot(along), along.x() * d.y() - along.y() * d.x());
  const auto overlap = [](double at, double half_width) {
    return std::clamp(std::min(at + 0.5, half_width) - std::max(at - 0.5, -half_width), 0.0, 1.0);
  };
  return overlap(local.x(), half.x()) * overlap(local.y(), half.y());
}

RuleBox on_grid(const Rule& rule, const PlacedType& type) {
  const Vec2 from(type.at.x() + rule.x0, row_of(0.0, type) + rule.y0),
      to(type.at.x() + rule.x1, row_of(0.0, type) + rule.y1);
  const double length = (to - from).norm();
  RuleBox box{0.5 * (from + to),
              length > 0.0 ? Vec2((to - from) / length) : Vec2(1, 0),
              {0.5 * length, 0.5 * rule.thickness}};
  if (type.moving || (rule.x0 != rule.x1 && rule.y0 != rule.y1)) return box;
  const int across = rule.y0 == rule.y1 ? 1 : 0;  // the axis along which it is thin
  std::tie(box.middle[across], box.half.y()) = snapped(box.middle[across], rule.thickness);
  const int lengthwise = 1 - across;
  const double begin = std::floor(std::min(from[lengthwise], to[lengthwise])),
               end = std::ceil(std::max(from[lengthwise], to[lengthwise]));
  box.middle[lengthwise] = 0.5 * (begin + end);
  box.half.x() = 0.5 * (end - begin);
  return box;
}

double halo_radius(const DisplayList& list) {
  double em = 0.0;
  for (const Glyph& glyph : list.glyphs) em = std::max(em, glyph.size);
  return kHalo * em;
}

}  // namespace polhode
