// SPDX-License-Identifier: MIT
#include "render/gl/passes/glyph_pass.h"

#include "render/gl/passes/floats.h"
#include "render/gl/passes/type_placing.h"
#include "render/gl/shader_sources.h"

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

std::array<float, 4> premultiplied(const Color& c) { return {c.r * c.a, c.g * c.a, c.b * c.a, c.a}; }

/// How much ink is strengthened where it covers a part of a pixel: none that is dark enough for paper; light
/// ink, which stands on dark, by up to an eighth.
float gain_of(const Color& ink) {
  constexpr float kDark = 0.45F, kLight = 0.95F, kMost = 0.5F;
  const float brightness = 0.3F * ink.r + 0.6F * ink.g + 0.1F * ink.b;
  return kMost * std::clamp((brightness - kDark) / (kLight - kDark), 0.0F, 1.0F);
}

constexpr std::array<std::uint32_t, 6> kTwoTriangles = {0, 1, 2, 2, 1, 3};

template <class Vertex>
void add_quad(const std::array<Vertex, 4>& corners, Geometry<Vertex>& geometry) {
  const auto first = static_cast<std::uint32_t>(geometry.vertices.size());
  geometry.vertices.insert(geometry.vertices.end(), corners.begin(), corners.end());
  for (std::uint32_t k : kTwoTriangles) geometry.indices.push_back(first + k);
}

/// Rows [from, from + rows) of a mask.
GlyphMask strip_of(const GlyphMask& mask, int from, int rows) {
  const auto first = mask.ink.begin() + static_cast<std::ptrdiff_t>(from) * mask.width;
  return {mask.width,
          rows,
          mask.left,
          mask.top - from,
          {first, first + static_cast<std::ptrdiff_t>(rows) * mask.width}};
}

}  // namespace

Result<std::unique_ptr<GlyphPass>> GlyphPass::create(const Gl& gl, const Fonts& fonts) {
  auto glyph = Program::create(gl, "glyph", {shaders::kGlyphVert}, {shaders::kGlyphFrag});
  if (!glyph) return failure(glyph.error());
  auto rule = Program::create(gl, "rule", {shaders::kRuleVert}, {shaders::kRuleFrag});
  if (!rule) return failure(rule.error());
  return std::unique_ptr<GlyphPass>(
      new GlyphPass(gl, fonts, std::move(glyph).value(), std::move(rule).value()));
}

GlyphPass::GlyphPass(const Gl& gl, const Fonts& fonts, Program glyph, Program rule)
    : fonts_(fonts),
      glyph_(std::move(glyph)),
      rule_(std::move(rule)),
      glyph_stream_(gl, {2, 2, 4, 1}),
      rule_stream_(gl, {2, 2, 2, 4}),
      atlas_(gl) {}

void GlyphPass::draw(std::span<const PlacedType> texts, Size size) {
  size_ = size;
  for (const PlacedType& type : texts)
    if (type.halo.a > 0.0F) add_halo(type);
  for (const PlacedType& type : texts) add_glyphs(type);
  draw_glyphs();
  for (const PlacedType& type : texts) add_rules(type);
  draw_rules();
}

void GlyphPass::add_halo(const PlacedType& type) {
  const Halo halo = halo_of(type);
  add_mask(
      halo.name(), [&] { return halo.mask(fonts_); }, halo.x, halo.y, type.halo, 0.0F);
}

void GlyphPass::add_glyphs(const PlacedType& type) {
  for (const Glyph& glyph : type.list.glyphs) {
    const GridGlyph placed = on_grid(glyph, type);
    add_mask(
        {placed.mask_name()}, [&] { return mask_of(placed, fonts_); }, placed.x, placed.y, glyph.color,
        gain_of(glyph.color));
  }
}

void GlyphPass::add_mask(const MaskName& name, const MakeMask& make, int x, int y, const Color& color,
                         float gain) {
  const std::vector<AtlasTile>* tiles = atlas_.find(name);
  if (tiles == nullptr) {
    const GlyphMask mask = make();
    tiles = atlas_.add(name, mask);
    if (tiles == nullptr) {
      draw_glyphs();
      atlas_.clear();
      tiles = atlas_.add(name, mask);
    }
    if (tiles == nullptr) return add_in_strips(mask, x, y, color, gain);
  }
  for (const AtlasTile& tile : *tiles) add_tile(tile, x, y, color, gain);
}

/// A mask larger than the atlas.
void GlyphPass::add_in_strips(const GlyphMask& mask, int x, int y, const Color& color, float gain) {
  constexpr int kRows = 256;
  for (int from = 0; from < mask.height; from += kRows) {
    draw_glyphs();
    atlas_.clear();
    const auto* tiles = atlas_.add({}, strip_of(mask, from, std::min(kRows, mask.height - from)));
    if (tiles == nullptr) return;  // wider than any picture by far
    for (const AtlasTile& tile : *tiles) add_tile(tile, x, y, color, gain);
  }
  draw_glyphs();
  atlas_.clear();
}

void GlyphPass::add_tile(const AtlasTile& tile, int x, int y, const Color& color, float gain) {
  const int x0 = x + tile.x, y0 = y + tile.y;
  if (x0 >= size_.width || y0 >= size_.height || x0 + tile.width <= 0 || y0 + tile.height <= 0) return;
  const auto corner = [&](int dx, int dy) {
    return GlyphVertex{{static_cast<float>(x0 + dx), static_cast<float>(y0 + dy)},
                       {static_cast<float>(tile.column + dx), static_cast<float>(tile.row + dy)},
                       premultiplied(color),
                       gain};
  };
  add_quad<GlyphVertex>(
      {corner(0, 0), corner(tile.width, 0), corner(0, tile.height), corner(tile.width, tile.height)},
      glyphs_);
}

void GlyphPass::add_rules(const PlacedType& type) {
  for (const Rule& rule : type.list.rules) {
    const RuleBox box = on_grid(rule, type);
    const Vec2 across(-box.along.y(), box.along.x());
    const auto corner = [&](double u, double v) {
      const Vec2 local(u * (box.half.x() + 1.0), v * (box.half.y() + 1.0));
      return RuleVertex{floats(Vec2(box.middle + local.x() * box.along + local.y() * across)), floats(local),
                        floats(box.half), premultiplied(rule.color)};
    };
    add_quad<RuleVertex>({corner(-1, -1), corner(1, -1), corner(-1, 1), corner(1, 1)}, rules_);
  }
}

void GlyphPass::draw_glyphs() {
  glyph_.use();
  glyph_.set("u_size", static_cast<float>(size_.width), static_cast<float>(size_.height));
  glyph_.set("u_atlas", 0);
  atlas_.bind();
  glyph_stream_.draw(glyphs_);
  glyphs_.vertices.clear();
  glyphs_.indices.clear();
}

void GlyphPass::draw_rules() {
  rule_.use();
  rule_.set("u_size", static_cast<float>(size_.width), static_cast<float>(size_.height));
  rule_stream_.draw(rules_);
  rules_.vertices.clear();
  rules_.indices.clear();
}

}  // namespace polhode
