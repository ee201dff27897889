// SPDX-License-Identifier: MIT
// Where there is something to see over the whole film of a scene: what the camera is to hold. Nothing here
// depends on t. Internal to render/figure.
#pragma once

#include "render/figure/builders/builders.h"

#include <string>
#include <vector>

namespace polhode::builders {

/// An ellipsoid, a disc or a point that the picture has to hold, in axes of the view.
struct Extent {
  Vec3 center{0, 0, 0};
  Mat3 spread = Mat3::Zero();  ///< takes the unit ball to it; zero: a point
  /// More room on the side, left or right, that lies away from the centre: a name stands there.
  double aside = 0;
};
using Extents = std::vector<Extent>;

inline Extent ball_at(const Vec3& center, double radius) { return {center, radius * Mat3::Identity()}; }
/// At right angles to `normal`, a unit vector.
inline Extent disc_at(const Vec3& center, const Vec3& normal, double radius) {
  return {center, radius * (Mat3::Identity() - normal * normal.transpose())};
}
/// The name of an arrow that ends there and comes from `tail`; of so many letters.
Extent name_beyond(const Vec3& tip, const Vec3& tail, double letters = 1);
/// Letters of a formula as it is set, roughly.
double letters_of(const std::string& tex);

/// All that the scene shows in this view, names included. Without torque that is where an exact motion with
/// its T and L can ever bring it, which needs no motion to be computed; of a motion that is driven or
/// computed by steps, and of a lesson's own marks, it is sampled over the scene's span. A driven motion may
/// grow: states whose ω is more than a third longer than it ever is up to the still are left out.
Extents extents_of(const Snapshot& m);

/// Of a list about `center`.
Extents extents_of_drawn(const DrawList& list, const Vec3& center);

/// Of the marks alone.
void add_extents_of_marks(const Snapshot& m, Extents& extents);

/// The path of the centre of mass with its arrows, or that of the puck; space axes.
void add_extents_of_translation(const Snapshot& m, Extents& extents);

/// How far the furthest of them reaches from the centre.
double reach_of(const Extents& extents);

/// Corners of the body as it is drawn where it stands alone, body components. Empty: it fills its sphere, of
/// radius kAloneRadius.
std::vector<Vec3> solid_corners_B(const Snapshot& m);
inline constexpr double kAloneRadius = 0.95;  ///< of the sphere round a body that stands alone

}  // namespace polhode::builders
