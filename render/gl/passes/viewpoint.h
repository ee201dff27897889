// SPDX-License-Identifier: MIT
// What drawing needs to know about a pane's camera, and which parts of the screen things fall on. No GL
// calls; internal to render/gl/.
#pragma once

#include "render/figure/camera.h"
#include "render/figure/draw_list.h"

#include <vector>

namespace polhode {

using Mat4 = Eigen::Matrix4d;

struct Viewpoint {
  Mat4 view_projection;
  Mat4 ray;  ///< clip (x, y, 1, 1) to a direction in the view's frame, not normalised
  Vec3 eye;
  Vec3 right;    ///< of the screen, unit
  Vec3 light;    ///< unit, towards the key light: over the viewer's left shoulder
  double pixel;  ///< side of a pixel at distance 1 along the line of sight, scene units
};
/// @param height of the viewport, px
Viewpoint viewpoint_of(const Camera& camera, double aspect, double height);

/// From the view's frame to the space where the ellipsoid, moved to the origin, is the unit ball.
Mat3 to_ball(const GlassEllipsoid& e);

/// Whether the eye is on the side from which a wall is seen.
bool is_seen(const Wall& wall, const Vec3& eye);

/// A rectangle of the viewport in clip space.
struct ClipBox {
  double x0 = -1, y0 = -1, x1 = 1, y1 = 1;
  bool empty() const { return x0 >= x1 || y0 >= y1; }
};
ClipBox common(const ClipBox& a, const ClipBox& b);
ClipBox united(const ClipBox& a, const ClipBox& b);
/// What `hole`, which lies in `whole`, leaves of it: at most four boxes, none empty, none over another.
std::vector<ClipBox> around(const ClipBox& hole, const ClipBox& whole);

/// Holds the ellipsoid's outline: tangent planes through the eye, from the dual quadric (Hartley & Zisserman,
/// Multiple View Geometry, 2nd ed., eq. 8.7). The whole screen if the eye's plane cuts the ellipsoid.
ClipBox outline_box(const GlassEllipsoid& ellipsoid, const Mat4& view_projection);

/// The ellipse in clip space that holds it: center + axes · (cos, sin), a soft edge larger, never a sliver.
/// One around the screen if that would be some screens large, or the eye's plane cuts the ellipsoid.
struct OutlineEllipse {
  Eigen::Vector2d center;
  Eigen::Matrix2d axes;
};
OutlineEllipse outline_ellipse(const GlassEllipsoid& ellipsoid, const Mat4& view_projection);

/// A convex polygon around that ellipse, a hundredth larger (a box would be a quarter larger), cut at the
/// edges of the screen; empty beside it. OpenGL is left nothing to clip: where it does, Mesa's software
/// rasterisers (22.3, draw_pipe_clip.c) interpolate `noperspective` outputs along edges that are nearly
/// upright from a difference of x that is rounding alone.
std::vector<Eigen::Vector2d> outline_polygon(const GlassEllipsoid& ellipsoid, const Mat4& view_projection);

/// Floors fade out at this distance from the middle of the view.
inline constexpr double kFloorFades = 1.6, kFloorEnds = 7.5;

/// Where the floor is seen: up to its far end for an eye above it, from there up for one below. The whole
/// screen for an eye that stands over its end.
ClipBox floor_box(const Viewpoint& at, double floor_z);

/// What the shadow of an ellipsoid on the floor is made of, in the space where it is the unit ball, for the
/// point (unit x, unit y) of the floor: its squared distance from the centre is u² + v² + w², and from it the
/// ray to the light passes the centre after a way of to_light.
struct FloorForm {
  Vec3 u;         ///< u = u[0] x + u[1] y + u[2]
  Vec3 v;         ///< v = v[0] y + v[1], w² = v[2]
  Vec3 to_light;  ///< of x, y and 1
};
FloorForm floor_form(const Viewpoint& at, double floor_z, const GlassEllipsoid& ellipsoid, double unit);

/// Where the ellipsoid changes the floor by half a level of 255 or more.
struct FloorShading {
  ClipBox shade;  ///< shadow, and darkening at the contact
  ClipBox image;  ///< in the mirror
};
FloorShading floor_shading(const Viewpoint& at, double floor_z, const GlassEllipsoid& ellipsoid);

}  // namespace polhode
