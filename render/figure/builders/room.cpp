// SPDX-License-Identifier: MIT
// The room that a body turns in: one sees which frame rests. In the body's own frame it is the room that
// turns. All six walls are in the list; a wall is seen from inside alone, and so only those behind the body
// are drawn, wherever the camera stands. No two walls are alike, or a room that has turned by a right angle
// would look like one that has not.
#include "render/figure/builders/builders.h"
#include "render/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace polhode::builders {
namespace {

constexpr double kHalf = 1.5;  // of its edges about the centre: holds the triads, and an L of usual length
constexpr double kCell = 0.5;
constexpr double kLineRadius = 0.0035;
// Of the grey of axes.
constexpr float kLineAlpha = 0.34F, kWallAlpha = 0.05F, kFloorAlpha = 0.16F, kOpeningAlpha = 0.11F;

/// A door or a window in the wall across this axis, in parts of the half edges.
struct Opening {
  int axis;
  double side;
  std::array<double, 2> beside, height;
};
constexpr std::array<Opening, 4> kOpenings{{{1, 1.0, {0.0, 2.0 / 3.0}, {-1.0, 1.0 / 3.0}},
                                            {0, -1.0, {-2.0 / 3.0, 0.0}, {-1.0 / 3.0, 1.0 / 3.0}},
                                            {1, -1.0, {-2.0 / 3.0, -1.0 / 3.0}, {-1.0 / 3.0, 1.0 / 3.0}},
                                            {1, -1.0, {1.0 / 3.0, 2.0 / 3.0}, {-1.0 / 3.0, 1.0 / 3.0}}}};

/// About the origin of S, wide enough for a centre of mass that moves.
Eigen::AlignedBox3d extent_S(const Snapshot& m) {
  Eigen::AlignedBox3d path{Vec3(Vec3::Zero())};
  if (m.view == View::space)
    for (const Vec3& center : path_of_center_V(m)) path.extend(center);
  const Vec3 half = Vec3::Constant(kHalf + 0.5 * path.sizes().maxCoeff());
  return {path.center() - half, path.center() + half};
}

}  // namespace

void add_room(const Snapshot& m, const Camera& /*camera*/, DrawList& list) {
  if (!m.shows(Overlay::room)) return;
  Eigen::AlignedBox3d room = extent_S(m);
  const bool stands_on_floor = !list.floors.empty();
  if (stands_on_floor) room.min().z() = list.floors.front().z + m.center_V.z();
  const Vec3 half = 0.5 * room.sizes();
  const auto cells = [](double half_edge) {
    return std::max(1, static_cast<int>(std::lround(2.0 * half_edge / kCell)));
  };
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      const bool is_floor = axis == 2 && side < 0.0;
      if (is_floor && stands_on_floor) continue;
      // Turned so that right × up points into the room.
      const int first = (axis + (side < 0.0 ? 1 : 2)) % 3, second = 3 - axis - first;
      Wall wall;
      wall.center = m.q_VS * Vec3(room.center() + side * half[axis] * Vec3::Unit(axis)) - m.center_V;
      wall.right = m.q_VS * (half[first] * Vec3::Unit(first));
      wall.up = m.q_VS * (half[second] * Vec3::Unit(second));
      wall.cells = {cells(half[first]), cells(half[second])};
      wall.radius = kLineRadius * m.thickness * m.emphasis(Overlay::room);
      wall.line = wall.ground = kAxesRole.paint;
      wall.line.a = kLineAlpha;
      wall.ground.a = is_floor ? kFloorAlpha : kWallAlpha;
      list.walls.push_back(wall);
      for (const Opening& opening : kOpenings) {
        if (opening.axis != axis || opening.side != side) continue;
        const auto& [right, up] = first == 2 ? std::pair(opening.height, opening.beside)
                                             : std::pair(opening.beside, opening.height);
        Wall part = wall;
        part.center += 0.5 * (right[0] + right[1]) * wall.right + 0.5 * (up[0] + up[1]) * wall.up;
        part.right *= 0.5 * (right[1] - right[0]);
        part.up *= 0.5 * (up[1] - up[0]);
        part.cells = {1, 1};
        part.ground.a = kOpeningAlpha;
        list.walls.push_back(part);
      }
    }
}

}  // namespace polhode::builders
