// SPDX-License-Identifier: MIT
// Flat shapes as triangles with soft edges. No GL calls; internal to render/gl/.
#pragma once

#include "render/drawing/sheet.h"
#include "render/gl/passes/geometry.h"

namespace polhode {

/// As shape.vert reads it.
struct ShapeVertex {
  std::array<float, 2> position;  ///< px from the upper left corner
  std::array<float, 4> color;     ///< premultiplied by alpha and by how much of the pixel is covered
  /// In a piece of a stroke: place along and across it from its middle, px; half its length; its radius.
  /// Elsewhere kNoPiece, which covers every pixel.
  std::array<float, 4> piece;
};

inline constexpr std::array<float, 4> kNoPiece = {0.0F, 0.0F, 0.0F, 1e6F};

/// Edges fade over one pixel across them, as the area of a pixel that is covered does; strokes thinner than a
/// pixel are drawn one pixel wide and fainter. In the order of the shapes. A piece of a stroke is one
/// rectangle; shape.frag finds its round ends.
Geometry<ShapeVertex> make_geometry(const std::vector<FlatShape>& shapes);

}  // namespace polhode
