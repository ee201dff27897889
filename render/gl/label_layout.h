// SPDX-License-Identifier: MIT
// Where labels go: near what they name, clear of each other, of lines and of the picture's edge. No GL calls;
// internal to render/gl. Pixels from the upper left corner of the picture.
#pragma once

#include "physics/types.h"

#include <vector>

namespace polhode {

using Vec2 = Eigen::Vector2d;

struct PixelBox {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  double width() const { return x1 - x0; }
  double height() const { return y1 - y0; }
  bool contains(const Vec2& p) const { return p.x() >= x0 && p.x() <= x1 && p.y() >= y0 && p.y() <= y1; }
  double overlap(const PixelBox& o) const;  ///< area, px²
  PixelBox grown(double by) const { return {x0 - by, y0 - by, x1 + by, y1 + by}; }
};

struct LabelRequest {
  Vec2 anchor{0, 0};
  double width = 0, height = 0;
  Vec2 outward{0, 0};   ///< unit or zero: where there is nothing else, the label goes that way
  bool leader = false;  ///< may stand away from its anchor, joined to it by a line
};

struct PlacedLabel {
  PixelBox box;
  bool has_leader = false;
  Vec2 leader_end{0, 0};  ///< on the box's edge; the line starts at the anchor
};

/// Places labels in the order given, each at the cheapest of a fixed set of candidates: the cost counts
/// overlap with labels and boxes already placed, obstacles covered, leaders crossed, distance, and leaving
/// `frame`. `obstacles` are points on lines that should stay visible, `taken` boxes that are not to be
/// covered.
std::vector<PlacedLabel> place_labels(const std::vector<LabelRequest>& labels,
                                      const std::vector<Vec2>& obstacles, const std::vector<PixelBox>& taken,
                                      const PixelBox& frame);

}  // namespace polhode
