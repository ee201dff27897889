// SPDX-License-Identifier: MIT
#include "render/gl/passes/viewpoint.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polhode {
namespace {

/// A pixel or two of a small picture, for soft edges and rounding.
constexpr double kMargin = 0.004;

ClipBox widened(ClipBox b, double by) { return {b.x0 - by, b.y0 - by, b.x1 + by, b.y1 + by}; }

/// The larger root of a x² + b x + c, or nothing: none, or not finite.
std::optional<double> larger_root(double a, double b, double c) {
  const double discriminant = b * b - 4.0 * a * c;
  if (!(a > 0.0) || discriminant < 0.0) return std::nullopt;
  return (-b + std::sqrt(discriminant)) / (2.0 * a);
}

/// Of the floor below the centre of the ellipsoid, in the space where this is the unit ball: how far from
/// `middle` towards `direction` the ellipsoid still changes it. As in floor.frag.
std::optional<double> shaded_way(const Vec3& middle, const Vec3& direction, const Vec3& light) {
  // Contact: 0.22 / |p|⁴ of 255 levels is half a level.
  constexpr double kContact2 = 10.6;
  const auto contact =
      larger_root(direction.squaredNorm(), 2.0 * middle.dot(direction), middle.squaredNorm() - kContact2);
  // Shadow: |p|² − s² = (1.16 + 0.16 s)², where s is the way to the light's nearest point.
  constexpr double kSharp = 1.16, kBlur = 0.16, kLean = 1.0 + kBlur * kBlur;
  const double s0 = -middle.dot(light), s1 = -direction.dot(light);
  const auto shadow =
      larger_root(direction.squaredNorm() - kLean * s1 * s1,
                  2.0 * (middle.dot(direction) - kLean * s0 * s1 - kSharp * kBlur * s1),
                  middle.squaredNorm() - kLean * s0 * s0 - 2.0 * kSharp * kBlur * s0 - kSharp * kSharp);
  if (!contact || !shadow) return std::nullopt;
  return std::max(*contact, *shadow);
}

}  // namespace

Viewpoint viewpoint_of(const Camera& camera, double aspect, double height) {
  const Mat4 view = camera.view(), projection = camera.projection(aspect);
  Mat4 turn = view;
  turn.topRightCorner<3, 1>().setZero();
  Viewpoint at;
  at.view_projection = projection * view;
  at.ray = (projection * turn).inverse();
  at.eye = camera.eye;
  at.right = view.block<1, 3>(0, 0).transpose();
  const Vec3 up = view.block<1, 3>(1, 0).transpose(), back = view.block<1, 3>(2, 0).transpose();
  at.light = (-0.45 * at.right + 0.75 * up + 0.42 * back + Vec3(0.0, 0.0, 0.35)).normalized();
  at.pixel = 2.0 * std::tan(0.5 * camera.fov_y_rad) / height;
  return at;
}

Mat3 to_ball(const GlassEllipsoid& e) {
  return e.semi_axes.cwiseInverse().asDiagonal() * e.rotation.toRotationMatrix().transpose();
}

FloorForm floor_form(const Viewpoint& at, double floor_z, const GlassEllipsoid& e, double unit) {
  const Mat3 ball = to_ball(e);
  const Eigen::Matrix<double, 3, 2> axes = unit * ball.leftCols<2>();
  const Vec3 origin = ball * (Vec3(0.0, 0.0, floor_z) - e.center), light = (ball * at.light).normalized();
  // p = axes (x, y) + origin, and axes = Q R with orthogonal columns in Q: what of p lies in the floor is R
  // (x, y) + Qᵀ origin, the rest is the same everywhere.
  const Vec3 q0 = axes.col(0).normalized();
  const Vec3 q1 = (axes.col(1) - q0.dot(axes.col(1)) * q0).normalized();
  const double beside = origin.dot(q0.cross(q1));
  return {{q0.dot(axes.col(0)), q0.dot(axes.col(1)), q0.dot(origin)},
          {q1.dot(axes.col(1)), q1.dot(origin), beside * beside},
          {-light.dot(axes.col(0)), -light.dot(axes.col(1)), -light.dot(origin)}};
}

bool is_seen(const Wall& wall, const Vec3& eye) {
  return wall.right.cross(wall.up).dot(eye - wall.center) > 0.0;
}

ClipBox common(const ClipBox& a, const ClipBox& b) {
  return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

ClipBox united(const ClipBox& a, const ClipBox& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

std::vector<ClipBox> around(const ClipBox& hole, const ClipBox& whole) {
  if (hole.empty()) return {whole};
  std::vector<ClipBox> boxes;
  for (const ClipBox& box :
       {ClipBox{whole.x0, whole.y0, whole.x1, hole.y0},  //
        ClipBox{whole.x0, hole.y0, hole.x0, hole.y1}, ClipBox{hole.x1, hole.y0, whole.x1, hole.y1},
        ClipBox{whole.x0, hole.y1, whole.x1, whole.y1}})
    if (!box.empty()) boxes.push_back(box);
  return boxes;
}

namespace {

/// Of the outline in clip space: its middle, and half-axes squared as a matrix. Nothing if the eye's plane
/// cuts the ellipsoid.
std::optional<std::pair<Eigen::Vector2d, Eigen::Matrix2d>> outline(const GlassEllipsoid& e,
                                                                   const Mat4& view_projection) {
  Mat4 place = Mat4::Identity();
  place.topLeftCorner<3, 3>() = e.rotation.toRotationMatrix() * e.semi_axes.asDiagonal();
  place.topRightCorner<3, 1>() = e.center;
  const Mat4 m = view_projection * place;
  const Eigen::Vector4d unit_ball(1.0, 1.0, 1.0, -1.0);
  const Mat4 dual = m * unit_ball.asDiagonal() * m.transpose();
  if (dual(3, 3) >= 0.0) return std::nullopt;
  const Eigen::Vector2d middle = dual.topRightCorner<2, 1>() / dual(3, 3);
  return std::pair{middle,
                   Eigen::Matrix2d(middle * middle.transpose() - dual.topLeftCorner<2, 2>() / dual(3, 3))};
}

}  // namespace

ClipBox outline_box(const GlassEllipsoid& e, const Mat4& view_projection) {
  const auto found = outline(e, view_projection);
  if (!found) return {};
  const auto& [middle, squares] = *found;
  const Eigen::Vector2d half = squares.diagonal().cwiseMax(0.0).cwiseSqrt();
  const Eigen::Vector2d low = middle - half, high = middle + half;
  return common(widened({low.x(), low.y(), high.x(), high.y()}, kMargin), {});
}

OutlineEllipse outline_ellipse(const GlassEllipsoid& e, const Mat4& view_projection) {
  constexpr double kLeastWidth = 0.3;  // triangles that are slivers interpolate badly
  constexpr double kFurthest = 3.0;    // and of triangles much larger than the screen too few digits are left
  OutlineEllipse screen{Eigen::Vector2d::Zero(), std::numbers::sqrt2 * Eigen::Matrix2d::Identity()};
  const auto found = outline(e, view_projection);
  if (!found) return screen;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(found->second);
  Eigen::Vector2d half = axes.eigenvalues().cwiseMax(0.0).cwiseSqrt().array() + kMargin;
  half = half.cwiseMax(kLeastWidth * half.maxCoeff());
  if (!(found->first.norm() + half.maxCoeff() < kFurthest)) return screen;
  return {found->first, axes.eigenvectors() * half.asDiagonal()};
}

namespace {

/// Sutherland and Hodgman, Reentrant polygon clipping, Comm. ACM 17 (1974) 32, for one edge of the screen.
/// @param axis 0 or 1, of which sign · coordinate ≤ 1 is kept
std::vector<Eigen::Vector2d> cut(const std::vector<Eigen::Vector2d>& polygon, int axis, double sign) {
  std::vector<Eigen::Vector2d> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double outside_a = sign * a[axis] - 1.0, outside_b = sign * b[axis] - 1.0;
    if (outside_a <= 0.0) kept.push_back(a);
    if ((outside_a <= 0.0) == (outside_b <= 0.0)) continue;
    Eigen::Vector2d point = a + outside_a / (outside_a - outside_b) * (b - a);
    point[axis] = sign;  // no rounding beyond the edge
    kept.push_back(point);
  }
  return kept;
}

}  // namespace

std::vector<Eigen::Vector2d> outline_polygon(const GlassEllipsoid& e, const Mat4& view_projection) {
  constexpr int kCorners = 20;
  constexpr double kCorner = 2.0 * std::numbers::pi / kCorners;
  const OutlineEllipse ellipse = outline_ellipse(e, view_projection);
  std::vector<Eigen::Vector2d> polygon;
  for (int i = 0; i < kCorners; ++i)
    polygon.emplace_back(ellipse.center + ellipse.axes *
                                              Eigen::Vector2d(std::cos(kCorner * i), std::sin(kCorner * i)) /
                                              std::cos(0.5 * kCorner));
  for (const int axis : {0, 1})
    for (const double sign : {1.0, -1.0}) polygon = cut(polygon, axis, sign);
  return polygon;
}

ClipBox floor_box(const Viewpoint& at, double floor_z) {
  const bool from_above = at.eye.z() > floor_z;
  const Vec3 away = -at.eye.cwiseProduct(Vec3(1, 1, 0));
  if (away.norm() <= 0.0) return {};
  const Vec3 far_end = away.normalized() * kFloorEnds + Vec3(0.0, 0.0, floor_z);
  const Eigen::Vector4d clip = at.view_projection * far_end.homogeneous();
  if (clip.w() <= 0.0) return {};
  const double y = std::clamp(clip.y() / clip.w(), -1.0, 1.0);
  return from_above ? ClipBox{-1, -1, 1, y} : ClipBox{-1, y, 1, 1};
}

namespace {

ClipBox image_box(const Viewpoint& at, double floor_z, const GlassEllipsoid& e) {
  GlassEllipsoid mirrored = e;
  mirrored.center.z() = 2.0 * floor_z - e.center.z();
  Mat3 rotation = e.rotation.toRotationMatrix();
  rotation.row(2) *= -1.0;
  rotation.col(2) *= -1.0;  // a rotation again: an ellipsoid does not tell an axis from its opposite
  mirrored.rotation = Quat(rotation);
  return outline_box(mirrored, at.view_projection);
}

ClipBox shade_box(const Viewpoint& at, double floor_z, const GlassEllipsoid& e) {
  const Mat3 ball = to_ball(e);
  const Vec3 light = (ball * at.light).normalized();
  const Vec3 foot(e.center.x(), e.center.y(), floor_z);
  constexpr int kDirections = 64;  // of a convex outline; the polygon lies inside it by less than 0.2 %
  constexpr double kBeyond = 1.01;
  ClipBox box{0, 0, 0, 0};
  for (int i = 0; i < kDirections; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / kDirections;
    const Vec3 direction(std::cos(turn), std::sin(turn), 0.0);
    const auto way = shaded_way(ball * (foot - e.center), ball * direction, light);
    if (!way) return {};
    const Eigen::Vector4d clip = at.view_projection * (foot + kBeyond * *way * direction).homogeneous();
    if (clip.w() <= 0.0) return {};
    const double x = clip.x() / clip.w(), y = clip.y() / clip.w();
    box = united(box, widened({x, y, x, y}, kMargin));
  }
  return common(box, {});
}

}  // namespace

FloorShading floor_shading(const Viewpoint& at, double floor_z, const GlassEllipsoid& ellipsoid) {
  return {shade_box(at, floor_z, ellipsoid), image_box(at, floor_z, ellipsoid)};
}

}  // namespace polhode
