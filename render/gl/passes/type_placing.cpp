// SPDX-License-Identifier: MIT
#include "render/gl/passes/type_placing.h"

#include <algorithm>
#include <bit>
#include <climits>
#include <cmath>

namespace polhode {
namespace {

int whole(double value) { return static_cast<int>(std::floor(value + 0.5)); }

}  // namespace

Halo halo_of(const PlacedType& type) {
  Halo halo;
  halo.x = static_cast<int>(std::floor(type.at.x()));
  halo.y = static_cast<int>(std::floor(row_of(0.0, type)));
  for (const Glyph& glyph : type.list.glyphs) {
    GridGlyph placed = on_grid(glyph, type);
    placed.x -= halo.x;
    placed.y -= halo.y;
    halo.glyphs.push_back(placed);
  }
  for (const Rule& rule : type.list.rules) {
    RuleBox box = on_grid(rule, type);
    box.middle -= Vec2(halo.x, halo.y);
    halo.rules.push_back(box);
  }
  halo.radius = halo_radius(type.list);
  return halo;
}

std::vector<std::uint64_t> Halo::name() const {
  std::vector<std::uint64_t> name = {std::bit_cast<std::uint64_t>(radius)};
  for (const GridGlyph& g : glyphs) {
    name.push_back(g.mask_name());
    name.push_back(static_cast<std::uint64_t>(static_cast<std::uint32_t>(g.x)) << 32 |
                   static_cast<std::uint32_t>(g.y));
  }
  for (const RuleBox& r : rules)
    for (double v : {r.middle.x(), r.middle.y(), r.along.x(), r.along.y(), r.half.x(), r.half.y()})
      name.push_back(std::bit_cast<std::uint64_t>(v));
  return name;
}

namespace {

/// A mask to draw into, by pixels from that of its origin.
struct Canvas {
  GlyphMask mask;

  std::uint8_t& at(int x, int y) {
    return mask.ink[static_cast<std::size_t>(y + mask.top) * static_cast<std::size_t>(mask.width) +
                    static_cast<std::size_t>(x - mask.left)];
  }
};

struct Bounds {
  int x0 = INT_MAX, y0 = INT_MAX, x1 = INT_MIN, y1 = INT_MIN;
  bool empty() const { return x0 >= x1; }
  void take(int left, int top, int right, int bottom) {
    x0 = std::min(x0, left), y0 = std::min(y0, top);
    x1 = std::max(x1, right), y1 = std::max(y1, bottom);
  }
  Canvas canvas(int margin) const {
    GlyphMask mask{x1 - x0 + 2 * margin, y1 - y0 + 2 * margin, x0 - margin, margin - y0, {}};
    mask.ink.assign(static_cast<std::size_t>(mask.width) * static_cast<std::size_t>(mask.height), 0);
    return {std::move(mask)};
  }
};

void add_ink(const GlyphMask& glyph, int x, int y, Canvas& canvas) {
  for (int row = 0; row < glyph.height; ++row)
    for (int column = 0; column < glyph.width; ++column) {
      std::uint8_t& ink = canvas.at(x + glyph.left + column, y - glyph.top + row);
      ink = std::max(ink, glyph.ink[static_cast<std::size_t>(row) * static_cast<std::size_t>(glyph.width) +
                                    static_cast<std::size_t>(column)]);
    }
}

Bounds bounds_of(const RuleBox& rule) {
  const Vec2 reach = rule.half.x() * rule.along.cwiseAbs() +
                     rule.half.y() * Vec2(rule.along.y(), rule.along.x()).cwiseAbs() + Vec2(1, 1);
  const Vec2 low = (rule.middle - reach).array().floor(), high = (rule.middle + reach).array().ceil();
  return {static_cast<int>(low.x()), static_cast<int>(low.y()), static_cast<int>(high.x()),
          static_cast<int>(high.y())};
}

void add_ink(const RuleBox& rule, Canvas& canvas) {
  const Bounds around = bounds_of(rule);
  for (int y = around.y0; y < around.y1; ++y)
    for (int x = around.x0; x < around.x1; ++x) {
      std::uint8_t& ink = canvas.at(x, y);
      ink = std::max(ink, static_cast<std::uint8_t>(std::lround(255.0 * rule.coverage({x + 0.5, y + 0.5}))));
    }
}

/// A disc of weights in 1/256, 1 inside the radius and fading over the next pixel.
struct Brush {
  int reach;
  std::vector<int> weights;

  explicit Brush(double radius) : reach(static_cast<int>(std::ceil(radius))) {
    for (int y = -reach; y <= reach; ++y)
      for (int x = -reach; x <= reach; ++x)
        weights.push_back(whole(256.0 * std::clamp(radius + 1.0 - std::hypot(x, y), 0.0, 1.0)));
  }
};

/// Each pixel takes the strongest ink under the brush. Ink amid full ink adds nothing to that around it.
GlyphMask grown(const Canvas& ink, const Brush& brush) {
  Canvas halo = ink;
  const int width = ink.mask.width, side = 2 * brush.reach + 1;
  const std::uint8_t* from = ink.mask.ink.data();
  for (int y = brush.reach; y < ink.mask.height - brush.reach; ++y)
    for (int x = brush.reach; x < width - brush.reach; ++x) {
      const std::uint8_t* p = from + static_cast<std::ptrdiff_t>(y) * width + x;
      if (*p == 0 || (*p & p[-1] & p[1] & p[-width] & p[width]) == 255) continue;
      for (int dy = -brush.reach; dy <= brush.reach; ++dy) {
        std::uint8_t* to =
            halo.mask.ink.data() + static_cast<std::ptrdiff_t>(y + dy) * width + x - brush.reach;
        const int row = (dy + brush.reach) * side;
        const int* weight = &brush.weights[static_cast<std::size_t>(row)];
        for (int k = 0; k < side; ++k)
          to[k] = std::max(to[k], static_cast<std::uint8_t>((*p * weight[k]) >> 8));
      }
    }
  return std::move(halo.mask);
}

}  // namespace

GlyphMask Halo::mask(const Fonts& fonts) const {
  std::vector<GlyphMask> masks;
  Bounds all;
  for (const GridGlyph& g : glyphs) {
    const GlyphMask& m = masks.emplace_back(mask_of(g, fonts));
    if (m.width > 0) all.take(g.x + m.left, g.y - m.top, g.x + m.left + m.width, g.y - m.top + m.height);
  }
  for (const RuleBox& rule : rules) {
    const Bounds b = bounds_of(rule);
    all.take(b.x0, b.y0, b.x1, b.y1);
  }
  if (all.empty()) return {};
  const Brush brush(radius);
  Canvas canvas = all.canvas(brush.reach + 1);
  for (std::size_t i = 0; i < glyphs.size(); ++i) add_ink(masks[i], glyphs[i].x, glyphs[i].y, canvas);
  for (const RuleBox& rule : rules) add_ink(rule, canvas);
  return grown(canvas, brush);
}

GlyphMask mask_of(const GridGlyph& g, const Fonts& fonts) {
  return fonts.mask(g.face, g.id, g.size_64 / 64.0, g.quarter_x / 4.0, g.quarter_y / 4.0);
}

}  // namespace polhode
