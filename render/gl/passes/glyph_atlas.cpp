// SPDX-License-Identifier: MIT
#include "render/gl/passes/glyph_atlas.h"

#include <algorithm>
#include <cstddef>

namespace polhode {
namespace {

constexpr int kFirstRows = 256;

int rounded_up(int value, int step) { return (value + step - 1) / step * step; }

}  // namespace

GlyphAtlas::GlyphAtlas(const Gl& gl) : gl_(gl) {
  gl.GenTextures(1, &texture_);
  gl.BindTexture(GL_TEXTURE_2D, texture_);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

GlyphAtlas::~GlyphAtlas() { gl_.DeleteTextures(1, &texture_); }

const std::vector<AtlasTile>* GlyphAtlas::find(const MaskName& name) const {
  const auto found = masks_.find(name);
  return found == masks_.end() ? nullptr : &found->second;
}

const std::vector<AtlasTile>* GlyphAtlas::add(const MaskName& name, const GlyphMask& mask) {
  std::vector<AtlasTile> tiles;
  for (int y = 0; y < mask.height; y += kWidth)
    for (int x = 0; x < mask.width; x += kWidth) {
      AtlasTile tile{x + mask.left,
                     y - mask.top,
                     std::min(kWidth, mask.width - x),
                     std::min(kWidth, mask.height - y),
                     0,
                     0};
      Shelf* shelf = shelf_for(tile.width, tile.height);
      if (shelf == nullptr) return nullptr;
      tile.column = shelf->end;
      tile.row = shelf->row;
      shelf->end += tile.width;
      copy(mask, tile, x, y);
      tiles.push_back(tile);
    }
  return &(masks_[name] = std::move(tiles));
}

void GlyphAtlas::clear() {
  shelves_.clear();
  masks_.clear();
}

GlyphAtlas::Shelf* GlyphAtlas::shelf_for(int width, int height) {
  constexpr int kStep = 4;  // heights differ a little from glyph to glyph
  const int wanted = rounded_up(height, kStep);
  for (Shelf& shelf : shelves_)
    if (shelf.height >= height && shelf.height <= wanted + wanted / 4 && shelf.end + width <= kWidth)
      return &shelf;
  const int row = shelves_.empty() ? 0 : shelves_.back().row + shelves_.back().height;
  if (row + wanted > kMostRows) return nullptr;
  shelves_.push_back({row, wanted, 0});
  const std::size_t texels = static_cast<std::size_t>(kWidth) * static_cast<std::size_t>(row + wanted);
  if (texels > texels_.size()) texels_.resize(texels);
  return &shelves_.back();
}

void GlyphAtlas::copy(const GlyphMask& mask, const AtlasTile& tile, int from_x, int from_y) {
  for (int y = 0; y < tile.height; ++y) {
    const auto from = mask.ink.begin() + static_cast<std::ptrdiff_t>(from_y + y) * mask.width + from_x;
    std::copy(from, from + tile.width,
              texels_.begin() + static_cast<std::ptrdiff_t>(tile.row + y) * kWidth + tile.column);
  }
  dirty_from_ = dirty_from_ == dirty_to_ ? tile.row : std::min(dirty_from_, tile.row);
  dirty_to_ = std::max(dirty_to_, tile.row + tile.height);
}

void GlyphAtlas::bind() {
  gl_.BindTexture(GL_TEXTURE_2D, texture_);
  if (dirty_from_ == dirty_to_) return;
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  if (dirty_to_ > rows_) {
    for (rows_ = std::max(rows_, kFirstRows); rows_ < dirty_to_;) rows_ *= 2;
    texels_.resize(static_cast<std::size_t>(kWidth) * static_cast<std::size_t>(rows_));
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, kWidth, rows_, 0, GL_RED, GL_UNSIGNED_BYTE, texels_.data());
  } else {
    gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, dirty_from_, kWidth, dirty_to_ - dirty_from_, GL_RED,
                      GL_UNSIGNED_BYTE, texels_.data() + static_cast<std::ptrdiff_t>(dirty_from_) * kWidth);
  }
  dirty_from_ = dirty_to_ = 0;
}

}  // namespace polhode
