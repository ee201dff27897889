// SPDX-License-Identifier: MIT
// A flat drawing as data: plots, and whatever else is lines, areas and text on a page. Pixels from the upper
// left corner, y down; colours are sRGB, straight alpha.
#pragma once

#include "base/color.h"
#include "base/vectors.h"
#include "render/typeset/display_list.h"

#include <string>
#include <variant>
#include <vector>

namespace polhode {

/// A line through the points, with round ends and joints. Where pieces of a translucent one meet, it is
/// denser.
struct Stroke {
  std::vector<Vec2> points;
  double width = 1;
  Color color;
  double dash = 0;  ///< length of a dash and of a gap; 0: solid
};

/// The area inside a polygon, either way round, that can be seen whole from its centroid: convex ones, stars.
struct Area {
  std::vector<Vec2> points;
  Color color;
};

/// Type with the place of its origin, the left end of its first baseline.
struct PlacedType {
  DisplayList list{};
  Vec2 at{0, 0};
  Color halo{0, 0, 0, 0};  ///< around the type, under the ink of all texts; alpha 0: none
  /// Still type has its baselines on whole pixels, and rules along the axes fill whole pixels; what moves
  /// slowly would jump so.
  bool moving = false;
  std::string text{};  ///< what it was set from
};

using FlatShape = std::variant<Stroke, Area>;

struct Sheet {
  std::vector<FlatShape> shapes{};       ///< the later over the earlier; figures set into the sheet over them
  std::vector<FlatShape> over_insets{};  ///< and these over the figures
  std::vector<PlacedType> texts{};       ///< over everything
};

/// Adds `part` over `sheet`, its origin at `at`.
void append(Sheet& sheet, Sheet part, const Vec2& at);

}  // namespace polhode
