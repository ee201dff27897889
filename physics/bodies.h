// SPDX-License-Identifier: MIT
// Bodies a lecture speaks of: simple shapes of uniform density, and a table of named ones.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "physics/principal_moments.h"

namespace polhode {

enum class ShapeKind { box, ellipsoid, cylinder, t_handle };

/// A shape to draw, its faces or axes along the principal axes 1, 2, 3 of its body, centred on the centre of mass.
struct Shape {
  ShapeKind kind = ShapeKind::box;
  Vec3 size_m = Vec3::Ones();  ///< full extents along the body axes 1, 2, 3
};

struct Body {
  std::string name;
  PrincipalMoments moments;    ///< kg m²
  std::optional<Shape> shape;  ///< nothing: known by its moments only
};

/// Uniform box of full edge lengths a, b, c: I1 = m(b² + c²)/12, and cyclic.
PrincipalMoments box_moments(const Vec3& size_m, double mass_kg);
/// Uniform ellipsoid of full axes a, b, c: I1 = m(b² + c²)/20, and cyclic.
PrincipalMoments ellipsoid_moments(const Vec3& size_m, double mass_kg);
/// Uniform cylinder about axis 3; size (d, d, h).
PrincipalMoments cylinder_moments(const Vec3& size_m, double mass_kg);

/// Body of a shape and mass. @throws std::domain_error if a size or the mass is not finite and > 0.
Body make_body(std::string name, ShapeKind kind, const Vec3& size_m, double mass_kg);

/// Uniform box with these moments (unit mass scale: only the ratios of its edges matter to a picture).
Shape equivalent_box(const PrincipalMoments& I);

std::optional<ShapeKind> shape_kind_from(std::string_view name);

/// textbook book racket phone t-handle earth slender-rod needle disc sphere ...; nothing if unknown.
std::optional<Body> find_body(std::string_view name);
std::vector<std::string> named_bodies();

}  // namespace polhode
