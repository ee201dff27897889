// SPDX-License-Identifier: MIT
// Masks of glyphs and halos in one texture, kept from picture to picture. Its texels are fetched and never
// filtered, so that where a mask lies cannot be seen. Internal to render/gl/.
#pragma once

#include "render/gl/context/functions.h"
#include "render/typeset/fonts.h"

#include <cstdint>
#include <map>
#include <vector>

namespace polhode {

/// A mask or a part of it, and where it lies in the texture.
struct AtlasTile {
  int x = 0, y = 0;  ///< px of its upper left corner from the pixel in which the mask's origin lies, y down
  int width = 0, height = 0;
  int column = 0, row = 0;  ///< in the texture
};

/// Whatever tells one mask from another.
using MaskName = std::vector<std::uint64_t>;

/// Grows with what is put into it, up to 16 MiB.
class GlyphAtlas {
 public:
  static constexpr int kWidth = 2048;
  static constexpr int kMostRows = 8192;

  /// `gl` must outlive it.
  explicit GlyphAtlas(const Gl& gl);
  ~GlyphAtlas();
  GlyphAtlas(const GlyphAtlas&) = delete;
  GlyphAtlas& operator=(const GlyphAtlas&) = delete;

  /// The tiles of a mask that was added; null if it is not here.
  const std::vector<AtlasTile>* find(const MaskName& name) const;
  /// Null if there is no room: draw what needs the present masks, clear(), and add again.
  const std::vector<AtlasTile>* add(const MaskName& name, const GlyphMask& mask);
  void clear();

  /// Binds the texture with all that was added.
  void bind();

 private:
  /// Tiles stand beside one another, none higher than their shelf.
  struct Shelf {
    int row, height, end;
  };
  Shelf* shelf_for(int width, int height);
  void copy(const GlyphMask& mask, const AtlasTile& tile, int from_x, int from_y);

  const Gl& gl_;
  GLuint texture_ = 0;
  int rows_ = 0;                       ///< of the texture
  int dirty_from_ = 0, dirty_to_ = 0;  ///< rows that the texture lacks
  std::vector<std::uint8_t> texels_;
  std::vector<Shelf> shelves_;
  std::map<MaskName, std::vector<AtlasTile>> masks_;
};

}  // namespace polhode
