// SPDX-License-Identifier: MIT
// A renderer of its own for a test, and type set for it without any layout.
#pragma once

#include "render/gl/renderer.h"

#include <stdexcept>

namespace polhode::test {

struct Drawn {
  std::unique_ptr<const Fonts> opened_fonts;
  std::unique_ptr<GlContext> context;
  std::unique_ptr<Renderer> renderer;

  explicit Drawn(ContextKind kind = ContextKind::any)
      : opened_fonts(std::make_unique<const Fonts>(Fonts::open().value())) {
    auto opened = open_context(kind);
    if (!opened) throw std::runtime_error(opened.error());
    context = std::move(opened).value();
    auto made = Renderer::create(*context, *opened_fonts);
    if (!made) throw std::runtime_error(made.error());
    renderer = std::move(made).value();
  }
  const Fonts& fonts() const { return *opened_fonts; }
  Image draw(const Sheet& sheet, const char* background = "white", Size size = {120, 80},
             std::span<const Inset> insets = {}) {
    auto image = renderer->draw(sheet, insets, size, background_from(background).value());
    if (!image) throw std::runtime_error(image.error());
    return std::move(image).value();
  }
};

/// A line of glyphs as the font gives them.
inline DisplayList shaped(const Fonts& fonts, std::string_view text, double size, const Color& color,
                          Face face = Face::serif) {
  DisplayList list;
  for (const ShapedGlyph& g : fonts.shape(face, text)) {
    Glyph glyph;
    glyph.face = face;
    glyph.id = g.id;
    glyph.x = g.x * size;
    glyph.size = size;
    glyph.color = color;
    list.glyphs.push_back(glyph);
    list.width = (g.x + g.advance) * size;
  }
  return list;
}

}  // namespace polhode::test
