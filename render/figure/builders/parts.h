// SPDX-License-Identifier: MIT
// Pieces that solid bodies are put together of. Internal to render/figure/.
#pragma once

#include "physics/body/bodies.h"
#include "render/figure/draw_list.h"

#include <array>
#include <vector>

namespace polhode::builders {

inline constexpr double kEdgeRadius = 0.006;  ///< of the lines along edges, scene units
inline constexpr Color kBodyEdge = color_from_hex(0x6A6152);

/// A part of a body in the body's own axes, m, to be placed in the view. Radii of edges are in scene units
/// already.
struct Part {
  Mesh mesh;
  std::vector<Tube> edges;
};

void add_quad(Mesh& mesh, const std::array<Vec3, 4>& corners, const Vec3& normal);
/// About the origin; a cylinder about axis 3, of elliptic section.
Part box_part(const Vec3& half);
Part cylinder_part(const Vec3& half);
void turn_and_move(Part& part, const Quat& q, const Vec3& by);

/// As one holds it; or as a ghost of glass, whose inner parts would show through one another.
enum class Look { solid, glass };
/// The parts of a body that has a look of its own: a box whose name ends in "book" or "phone", and a body
/// without a shape whose name ends in "racket". Empty for all others.
std::vector<Part> look_of(const Body& body, Look look);

}  // namespace polhode::builders
