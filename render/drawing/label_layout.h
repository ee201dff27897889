// SPDX-License-Identifier: MIT
// Where labels go: near what they name, clear of each other, of lines and of the picture's edge. Pixels from
// the upper left corner of the picture.
#pragma once

#include "render/drawing/sheet.h"

#include <vector>

namespace polhode {

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
  double unit = 0;     ///< distances are multiples of it; 0: of the height
  Vec2 outward{0, 0};  ///< unit or zero: where there is nothing else, the label goes that way
  /// Stands there, as near as it may, whatever lines are under it: it moves only from other labels, from what
  /// is taken, and from the frame's edge. So it keeps its side in a film.
  bool keeps_side = false;
  bool beside = false;  ///< of one that keeps its side: else it goes to the opposite one first
  bool leader = false;  ///< may stand away from its anchor, joined to it by a line
  double clear = 0;     ///< radius around the anchor that is not to be covered: of a mark
  bool close = false;   ///< of a label that may have a leader: may stand right beside its anchor too
};

struct PlacedLabel {
  PixelBox box;
  bool has_leader = false;
  Vec2 leader_end{0, 0};  ///< on the box's edge; the line starts at the anchor
};

/// How hard to try; the defaults suit a few labels around one body.
struct LabelRules {
  int starts = 1;  ///< how many of the labels have their turn at coming first; the best result counts
  int rounds = 0;  ///< in each, every label moves to what is cheapest beside all the others
  double cost_covered = 0.05;  ///< of an obstacle under a label
  double cost_crossed = 0.0;   ///< of an obstacle under a leader
  double air = 0.18;           ///< around a label, units
  double leader_gap = 0.16;    ///< between a label and the end of its leader, units
  double level_gap = 0.16;  ///< the same of a leader that comes in level: near a letter it is read as a minus
  double cost_level = 0.0;  ///< of a leader that comes in level
};

/// Places labels in the order given, each at the cheapest of a fixed set of candidates: the cost counts
/// overlap with labels and boxes already placed, obstacles covered, leaders crossed, distance, and leaving
/// `frame`; what would stand in it in part is moved into it. `obstacles` are points on lines that should stay
/// visible, `taken` boxes that are not to be covered.
std::vector<PlacedLabel> place_labels(const std::vector<LabelRequest>& labels,
                                      const std::vector<Vec2>& obstacles, const std::vector<PixelBox>& taken,
                                      const PixelBox& frame, const LabelRules& rules = {});

/// Places along a line for labels of one height that want to stand at `wanted`: at least `spacing` apart, in
/// the order of what they want, within [low, high] as far as there is room, and moved as little as possible
/// (least sum of squares).
std::vector<double> spread_apart(const std::vector<double>& wanted, double spacing, double low, double high);

}  // namespace polhode
