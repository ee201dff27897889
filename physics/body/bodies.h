// SPDX-License-Identifier: MIT
// Bodies a lecture speaks of: simple shapes of uniform density, and a table of named ones.
// Moments: Goldstein, Classical Mechanics, 3rd ed., §5.3; Landau & Lifshitz, Mechanics, §32, problem 2.
// Body axes 1, 2, 3 are the principal axes in the order of `size_m`, in no order of the moments; where a body
// has a natural longest and thinnest direction, axis 1 is the longest (smallest moment) and axis 3 the
// thinnest (largest).
#pragma once

#include "physics/body/principal_moments.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

enum class ShapeKind { box, ellipsoid, cylinder, t_handle };

/// A shape to draw, its faces or axes along the principal axes 1, 2, 3 of its body, centred on the centre of
/// mass. box: edges along 1, 2, 3. ellipsoid: axes along 1, 2, 3. cylinder: about axis 3, its section the
/// ellipse of full axes size[0], size[1]. t_handle: see THandleGeometry.
struct Shape {
  ShapeKind kind = ShapeKind::box;
  Vec3 size_m = Vec3::Ones();  ///< full extents along the body axes 1, 2, 3
  bool operator==(const Shape&) const = default;
};

struct Body {
  std::string name;
  PrincipalMoments moments;    ///< kg m²
  std::optional<Shape> shape;  ///< nothing: known by its moments only
  double mass_kg = 1.0;        ///< 1 kg where nobody said
  bool operator==(const Body&) const = default;
};

/// Uniform box of full edge lengths a, b, c: I1 = m(b² + c²)/12, and cyclic.
/// This, the next two and t_handle_moments: relative error 4ε; @throws std::domain_error if a size or the
/// mass is not finite and > 0, or the moments overflow or underflow.
PrincipalMoments box_moments(const Vec3& size_m, double mass_kg);

/// Uniform ellipsoid of full axes a, b, c: I1 = m(b² + c²)/20, and cyclic.
PrincipalMoments ellipsoid_moments(const Vec3& size_m, double mass_kg);

/// Uniform cylinder about axis 3; size (d, d, h): I1 = I2 = m(d²/16 + h²/12), I3 = m d²/8. With two
/// diameters, of elliptic section: I1 = m(d2²/16 + h²/12), I2 = m(d1²/16 + h²/12), I3 = m(d1² + d2²)/16.
PrincipalMoments cylinder_moments(const Vec3& size_m, double mass_kg);

/// A T of two uniform round bars of the same diameter and density. The crossbar lies along axis 1; the stem
/// lies along axis 2, from the crossbar's tangent plane towards −2, square-ended (its end is not hollowed to
/// fit the crossbar; a drawing may run it on to the crossbar's axis). The T lies in the plane of axes 1
/// and 2.
struct THandleGeometry {
  double diameter_m;         ///< of both bars, = size[2]
  double crossbar_length_m;  ///< along axis 1, = size[0]
  double stem_length_m;      ///< along axis 2, = size[1] − size[2]
  double crossbar_at_m;      ///< coordinate 2 of the crossbar's axis, ≥ 0, from the common centre of mass
  double stem_at_m;          ///< coordinate 2 of the stem's centre, ≤ 0
};

/// Size (width of the crossbar, whole height, diameter of the bars).
/// @throws std::domain_error if a size is not finite and > 0 or the height does not exceed the diameter.
THandleGeometry t_handle_geometry(const Vec3& size_m);

/// Moments of both bars about their common centre of mass, by Steiner's theorem; usually I1 < I2 < I3, so
/// that a spin about the stem is about the intermediate axis.
PrincipalMoments t_handle_moments(const Vec3& size_m, double mass_kg);

/// Body of a shape and mass. @throws std::domain_error if a size or the mass is not finite and > 0.
Body make_body(std::string name, ShapeKind kind, const Vec3& size_m, double mass_kg);

/// Uniform box with these moments: a² = 6(I2 + I3 − I1)/m, and cyclic. An edge below 1/500 of the longest (a
/// flat body has one of zero) is given as that, so it can be drawn.
Shape equivalent_box(const PrincipalMoments& I, double mass_kg = 1.0);

/// "box" "ellipsoid" "cylinder" "t-handle".
std::string_view name_of(ShapeKind kind);
std::vector<std::string> shape_kind_names();
/// Nothing if unknown.
std::optional<ShapeKind> shape_kind_from(std::string_view name);

/// One of named_bodies(); nothing if unknown. Sizes, masses and sources: named_bodies.cpp.
std::optional<Body> find_body(std::string_view name);

/// textbook book racket phone t-handle earth slender-rod needle disc sphere box ellipsoid cylinder, in this
/// order.
std::vector<std::string> named_bodies();

}  // namespace polhode
