// SPDX-License-Identifier: MIT
// A parametrised curve as a polyline within a chord tolerance.
#pragma once

#include "physics/body/types.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace polhode {

struct Sampling {
  double chord_tolerance;  ///< unit of the curve
  int first_pieces = 1;    ///< equal pieces of the parameter to start from; no chord spans more than one
  int max_halvings = 40;   ///< of each of them
  std::size_t max_points;  ///< no more halving after this many: the tolerance is then not kept
};

/// Points from curve(x0) to curve(x1), both included, found by halving the parameter until the curve at 1/4,
/// 1/2 and 3/4 of a piece is within 3/4 of the tolerance of its chord; for arcs without a corner between the
/// points looked at, no point of the curve is then further than the tolerance from the polyline, nor the
/// reverse. Ends before the first point that is not finite.
std::vector<Vec3> sample_curve(const std::function<Vec3(double)>& curve, double x0, double x1,
                               const Sampling& sampling);

/// Distance of p from the segment from a to b.
double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b);

}  // namespace polhode
