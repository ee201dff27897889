// SPDX-License-Identifier: MIT
#include "render/figure/pane_fit.h"

#include "render/figure/orbit_camera.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polhode {
namespace {

using builders::Extent;
using builders::Extents;

constexpr double kNearest = 1.3;  // of the eye from the middle, in radii: outside all that is held

/// How far extents reach to one side of the screen, from a point, against a plane through the eye that leans
/// by `slope` from the line of sight: all of them are seen below that slope if `reach` is not more than
/// slope times the eye's distance.
struct Reach {
  double reach = -std::numeric_limits<double>::infinity();
  double per_slope = 0.0;  ///< its derivative
};
/// @param axis of the screen, 0 to the right, 1 up; `sign` says to which of its sides
Reach reach_at(const Extents& seen, int axis, double sign, double slope) {
  Reach most;
  for (const Extent& extent : seen) {
    const Vec3 across = sign * extent.spread.row(axis), towards = extent.spread.row(2);
    const Vec3 lean = across + slope * towards;
    const double length = lean.norm();
    const double off = sign * extent.center[axis];
    const double beside = axis == 0 && off > 0.0 ? extent.aside : 0.0;
    const double reach = off + beside + slope * extent.center.z() + length;
    if (reach > most.reach)
      most = {reach, extent.center.z() + (length > 0.0 ? lean.dot(towards) / length : 0.0)};
  }
  return most;
}

/// One direction of the screen: the parts of the half field of view on its two sides that may be used.
struct Sides {
  int axis;
  double plus, minus;
};

struct Held {
  double half_tan = 0;  ///< the least tangent of half the field of view that holds all extents
  double middle = 0;    ///< where the middle of the screen lies then: no other holds them
};

/// What is wanted is convex in the tangent and falls until it is reached, so that Newton's method comes to it
/// from below.
Held least_that_holds(const Extents& seen, const Sides& sides, double distance) {
  constexpr int kMostSteps = 30;
  constexpr double kEnough = 1e-12;
  double half_tan = 0.0;
  for (int step = 0;; ++step) {
    const double to_plus = sides.plus * half_tan, to_minus = sides.minus * half_tan;
    const Reach plus = reach_at(seen, sides.axis, 1.0, to_plus),
                minus = reach_at(seen, sides.axis, -1.0, to_minus);
    const double wanted = plus.reach + minus.reach - (to_plus + to_minus) * distance;
    const double fall = sides.plus * (distance - plus.per_slope) + sides.minus * (distance - minus.per_slope);
    if (step == kMostSteps || !(wanted > kEnough * distance) || !(fall > 0.0))
      return {half_tan, 0.5 * ((plus.reach - to_plus * distance) - (minus.reach - to_minus * distance))};
    half_tan += wanted / fall;
  }
}

CameraSpec fitted_spec(const CameraSpec& spec) {
  CameraSpec from = spec;
  if (spec.fitted) {
    from.azimuth_rad = spec.fitted->azimuth_rad;
    from.elevation_rad = spec.fitted->elevation_rad;
  }
  return from;
}

}  // namespace

PaneFit pane_fit(const Extents& extents, const CameraSpec& spec, double aspect, const PaneMargins& margins,
                 double least_radius) {
  if (extents.empty()) return {};
  const Mat3 axes = orbit(fitted_spec(spec), Vec3::Zero(), 1.0).view().topLeftCorner<3, 3>();
  Extents seen = extents;
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (Extent& extent : seen) {
    extent.center = axes * extent.center;
    extent.spread = axes * extent.spread;
    const Vec3 half = extent.spread.rowwise().norm();
    low = low.cwiseMin(extent.center - half);
    high = high.cwiseMax(extent.center + half);
  }
  const Vec3 middle = 0.5 * (low + high);
  double radius = least_radius;
  for (const Extent& extent : seen)
    radius = std::max(radius, (extent.center - middle).norm() + extent.spread.colwise().norm().maxCoeff());
  if (!(radius > 0.0)) return {};
  // Names stand away from the centre, which the extents are given from: to the right of it, or to the left.
  for (Extent& extent : seen) extent.center.z() -= middle.z();

  const double distance = radius * std::max(spec.distance, kNearest);
  const Sides across{0, aspect * (1.0 - 2.0 * margins.side), aspect * (1.0 - 2.0 * margins.side)};
  const Sides upright{1, 1.0 - 2.0 * margins.top, 1.0 - 2.0 * margins.bottom};
  const Held held_across = least_that_holds(seen, across, distance),
             held_upright = least_that_holds(seen, upright, distance);
  const double half_tan = std::max(held_across.half_tan, held_upright.half_tan);
  const Vec3 target(held_across.middle, held_upright.middle, middle.z());
  return {axes.transpose() * target, radius, half_tan};
}

Camera fitted_camera(const PaneFit& fit, const CameraSpec& spec) {
  CameraSpec from = spec;
  from.distance = std::max(spec.distance, kNearest);
  Camera camera = orbit(from, fit.target, fit.radius);
  camera.fov_y_rad = 2.0 * std::atan(fit.half_tan / spec.zoom);
  return camera;
}

}  // namespace polhode
