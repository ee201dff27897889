// SPDX-License-Identifier: MIT
// Draws placed type: glyphs from an atlas of masks, rules, and the halos around them. Internal to render/gl/.
#pragma once

#include "render/drawing/sheet.h"
#include "render/gl/passes/geometry.h"
#include "render/gl/passes/glyph_atlas.h"
#include "render/gl/shader.h"
#include "render/gl/stream.h"
#include "render/image/image.h"

#include <functional>
#include <memory>
#include <span>

namespace polhode {

class GlyphPass {
 public:
  /// `gl` and `fonts` must outlive the pass.
  static Result<std::unique_ptr<GlyphPass>> create(const Gl& gl, const Fonts& fonts);

  /// Into the bound framebuffer of this size, with premultiplied blending on: first all halos, then all
  /// glyphs, then all rules. What is drawn depends on the arguments alone, not on what the atlas holds.
  void draw(std::span<const PlacedType> texts, Size size);

 private:
  struct GlyphVertex {
    std::array<float, 2> position;  ///< px from the upper left corner
    std::array<float, 2> texel;
    std::array<float, 4> color;  ///< premultiplied
    float gain;
  };
  struct RuleVertex {
    std::array<float, 2> position;
    std::array<float, 2> local;  ///< px from the middle, along and across
    std::array<float, 2> half;   ///< length and thickness, px
    std::array<float, 4> color;  ///< premultiplied
  };
  GlyphPass(const Gl& gl, const Fonts& fonts, Program glyph, Program rule);

  void add_halo(const PlacedType& type);
  void add_glyphs(const PlacedType& type);
  void add_rules(const PlacedType& type);
  using MakeMask = std::function<GlyphMask()>;
  void add_mask(const MaskName& name, const MakeMask& make, int x, int y, const Color& color, float gain);
  void add_in_strips(const GlyphMask& mask, int x, int y, const Color& color, float gain);
  void add_tile(const AtlasTile& tile, int x, int y, const Color& color, float gain);
  void draw_glyphs();
  void draw_rules();

  const Fonts& fonts_;
  Program glyph_, rule_;
  VertexStream glyph_stream_, rule_stream_;
  GlyphAtlas atlas_;
  Size size_;  ///< of the picture being drawn
  Geometry<GlyphVertex> glyphs_;
  Geometry<RuleVertex> rules_;
};

}  // namespace polhode
