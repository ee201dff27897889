// SPDX-License-Identifier: MIT
// The fonts, and what they tell of glyphs: HarfBuzz shapes, FreeType makes pixels. Nothing is hinted, so
// measures scale with the size and the same text gives the same numbers and pixels everywhere.
#pragma once

#include "base/result.h"
#include "render/typeset/display_list.h"

#include <memory>
#include <optional>
#include <vector>

struct hb_font_t;

namespace polhode {

/// Measures of a glyph relative to the em; y up.
struct GlyphBox {
  double left = 0, bottom = 0, right = 0, top = 0;
};

/// A glyph of shaped text: x, y from the pen at the start of the text, relative to the em, y up.
struct ShapedGlyph {
  std::uint32_t id = 0;
  double x = 0, y = 0;
  double advance = 0;
  std::uint32_t cluster = 0;  ///< byte of the text where the characters it stands for begin
};

/// 8-bit coverage, rows from the top. The glyph's origin lies `left` px left of the first column and `top` px
/// below the first row's upper edge.
struct GlyphMask {
  int width = 0, height = 0;
  int left = 0, top = 0;
  std::vector<std::uint8_t> ink;
};

/// For one thread at a time: the const functions too share HarfBuzz's buffer, FreeType's glyph slot and the
/// boxes of glyphs met so far.
class Fonts {
 public:
  /// Looks into $POLHODE_FONTS first. The error names the font, and the package or the file. About 1 ms.
  static Result<Fonts> open();
  Fonts(Fonts&&) noexcept;
  Fonts& operator=(Fonts&&) noexcept;
  ~Fonts();

  /// The glyph of a character; nothing if the face lacks it.
  std::optional<std::uint32_t> glyph(Face face, char32_t character) const;
  /// Advance relative to the em.
  double advance(Face face, std::uint32_t glyph) const;
  GlyphBox box(Face face, std::uint32_t glyph) const;

  /// One run of valid UTF-8 from left to right, with kerning and ligatures. A character that the face lacks
  /// gives glyph 0.
  std::vector<ShapedGlyph> shape(Face face, std::string_view utf8) const;

  /// HarfBuzz's font: one em is units_per_em() units. For the MATH table.
  hb_font_t* harfbuzz(Face face) const;
  double units_per_em(Face face) const;
  /// The file a face was read from, for other libraries that draw with it.
  const std::string& path(Face face) const;

  /// Pixels of a glyph whose origin lies `shift_x`, `shift_y` (0 ≤ … < 1, x to the right, y down) from a
  /// pixel's corner. Empty for a glyph without ink. About 10 µs at 30 px.
  GlyphMask mask(Face face, std::uint32_t glyph, double size_px, double shift_x, double shift_y) const;

 private:
  struct Faces;
  explicit Fonts(std::unique_ptr<Faces> faces);
  std::unique_ptr<Faces> faces_;
};

/// The box of all ink of a list, relative to its origin.
TypeBox ink_box(const DisplayList& list, const Fonts& fonts);

}  // namespace polhode
