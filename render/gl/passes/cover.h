// SPDX-License-Identifier: MIT
// Where a pane's layer is drawn on: what is cleared, resolved and laid over is no more. No GL calls; internal
// to render/gl/.
#pragma once

#include "render/figure/draw_list.h"
#include "render/gl/framebuffer.h"
#include "render/gl/passes/viewpoint.h"

#include <array>
#include <vector>

namespace polhode {

/// Of each band of rows of a picture, from which column to which something is drawn.
class Cover {
 public:
  /// @param part of the picture that can be drawn on, the viewport
  explicit Cover(const PixelArea& part);

  /// What is no more than `margin` away from a triangle, px of the viewport from its lower left corner.
  void add(const std::array<Eigen::Vector2d, 3>& triangle, double margin);
  void add_all();

  /// In pixels of the picture: at most kMostBoxes that hold all that was added, none over another.
  std::vector<PixelArea> boxes() const;

  static constexpr std::size_t kMostBoxes = 8;  // a box costs some 0.1 ms to resolve, a megapixel 6 ms

 private:
  struct Span {
    int from = 0, to = 0;  ///< columns of the viewport, `to` left out
  };
  PixelArea part_;
  std::vector<Span> bands_;  ///< from the lowest
};

/// Of lines, arrows, balls, meshes and the glass in front of them, as make_geometry() and the near glass draw
/// them; the whole where something of them is not before the eye.
Cover cover_of(const DrawList& list, const Viewpoint& at, const PixelArea& viewport);

}  // namespace polhode
