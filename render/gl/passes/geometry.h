// SPDX-License-Identifier: MIT
// Draw-list items as vertices for a depth buffer. No GL calls; internal to render/gl/.
#pragma once

#include "render/figure/camera.h"
#include "render/figure/draw_list.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace polhode {

/// As tube.vert reads it.
struct TubeVertex {
  std::array<float, 3> position;
  std::array<float, 3> tangent;
  std::array<float, 4> color;
  std::array<float, 3> shape;  ///< side, radius, length along in dashes
};

/// As mesh.vert reads it.
struct MeshVertex {
  std::array<float, 3> position;
  std::array<float, 3> normal;
  std::array<float, 4> color;
};

template <class Vertex>
struct Geometry {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
};

struct PaneGeometry {
  Geometry<MeshVertex> bodies;  ///< opaque meshes
  /// What shows faintly through bodies in front of it: arrows as flat as ribbons, and balls. Nothing where
  /// there is no body.
  Geometry<TubeVertex> arrows_in_bodies;
  Geometry<MeshVertex> balls_in_bodies;
  Geometry<TubeVertex> tubes;
  Geometry<TubeVertex> faded_tubes;  ///< trails
  Geometry<MeshVertex> solid;        ///< heads of arrows, balls
  Geometry<MeshVertex> translucent;
};

PaneGeometry make_geometry(const DrawList& list, const Vec3& eye);

/// What an arrow consists of: cones are closed by a disc at their base.
struct Cone {
  Vec3 base, tip;
  double radius;
  Color color;
};
struct ArrowParts {
  Tube shaft;  ///< ends a little inside the head
  Cone head;
};
/// Nothing for an arrow without length.
std::optional<ArrowParts> parts_of(const Arrow& arrow);

/// Unit vector, or zero.
Vec3 direction(const Vec3& from, const Vec3& to);

/// The directions of a tube at both ends of each of its segments: continuous along a smooth curve, the
/// segment's own at a corner.
struct SegmentTangents {
  Vec3 start, end;
};
std::vector<SegmentTangents> tangents_of(const Tube& tube);

}  // namespace polhode
