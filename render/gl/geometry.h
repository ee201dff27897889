// SPDX-License-Identifier: MIT
// Draw-list items as vertices. No GL calls; internal to render/gl.
#pragma once

#include "render/scene/camera.h"
#include "render/scene/draw_list.h"

#include <array>
#include <cstdint>
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
  Geometry<TubeVertex> tubes;
  Geometry<TubeVertex> faded_tubes;  ///< trails
  Geometry<MeshVertex> solid;
  Geometry<MeshVertex> translucent;
};

PaneGeometry make_geometry(const DrawList& list);

/// Clip-space rectangle x0, y0, x1, y1 that holds the ellipsoid's outline: tangent planes through the eye,
/// from the dual quadric (Hartley & Zisserman, Multiple View Geometry, 2nd ed., eq. 8.7). The whole screen if
/// the eye's plane cuts the ellipsoid.
std::array<double, 4> outline_bounds(const GlassEllipsoid& ellipsoid, const Eigen::Matrix4d& view_projection);

}  // namespace polhode
