// SPDX-License-Identifier: MIT
#include "physics/body/bodies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace polhode {
namespace {

// In the order of the enumerators.
constexpr std::array<std::string_view, 4> kShapeNames = {"box", "ellipsoid", "cylinder", "t-handle"};

constexpr double kThinnestDrawn = 1.0 / 500.0;  // of the longest edge

void require_positive(const Vec3& size_m, double mass_kg = 1.0) {
  const auto positive = [](double x) { return std::isfinite(x) && x > 0; };
  if (!std::all_of(size_m.begin(), size_m.end(), positive))
    throw std::domain_error("sizes must be finite and > 0");
  if (!positive(mass_kg)) throw std::domain_error("the mass must be finite and > 0");
}

// The second moments ∫x_i² dm are summed in pairs: then rounding cannot break I3 ≤ I1 + I2 by more than 2ε.
PrincipalMoments from_second_moments(const Vec3& M) { return {M[1] + M[2], M[2] + M[0], M[0] + M[1]}; }

// Second moments of a uniform bar of diameter d and length l along `axis` about its own centre.
Vec3 bar_second_moments(double diameter_m, double length_m, int axis, double mass_kg) {
  Vec3 M = Vec3::Constant(mass_kg * diameter_m * diameter_m / 16);
  M[axis] = mass_kg * length_m * length_m / 12;
  return M;
}

PrincipalMoments moments_of(ShapeKind kind, const Vec3& size_m, double mass_kg) {
  switch (kind) {
    case ShapeKind::box:
      return box_moments(size_m, mass_kg);
    case ShapeKind::ellipsoid:
      return ellipsoid_moments(size_m, mass_kg);
    case ShapeKind::cylinder:
      return cylinder_moments(size_m, mass_kg);
    case ShapeKind::t_handle:
      return t_handle_moments(size_m, mass_kg);
  }
  throw std::domain_error("unknown kind of shape");
}

}  // namespace

PrincipalMoments box_moments(const Vec3& size_m, double mass_kg) {
  require_positive(size_m, mass_kg);
  return from_second_moments(mass_kg * size_m.cwiseAbs2() / 12);
}

PrincipalMoments ellipsoid_moments(const Vec3& size_m, double mass_kg) {
  require_positive(size_m, mass_kg);
  return from_second_moments(mass_kg * size_m.cwiseAbs2() / 20);
}

PrincipalMoments cylinder_moments(const Vec3& size_m, double mass_kg) {
  require_positive(size_m, mass_kg);
  return from_second_moments(mass_kg * size_m.cwiseAbs2().cwiseQuotient(Vec3(16, 16, 12)));
}

THandleGeometry t_handle_geometry(const Vec3& size_m) {
  require_positive(size_m);
  const double crossbar = size_m[0];
  const double stem = size_m[1] - size_m[2];
  if (stem <= 0) throw std::domain_error("a T-handle must be higher than its bars are thick");
  const double apart = size_m[1] / 2;  // d/2 of the crossbar and half the stem
  const double whole = crossbar + stem;
  return {size_m[2], crossbar, stem, apart * (stem / whole), -apart * (crossbar / whole)};
}

PrincipalMoments t_handle_moments(const Vec3& size_m, double mass_kg) {
  require_positive(size_m, mass_kg);
  const THandleGeometry T = t_handle_geometry(size_m);
  const double whole = T.crossbar_length_m + T.stem_length_m;
  const double crossbar_kg = mass_kg * (T.crossbar_length_m / whole);
  const double stem_kg = mass_kg * (T.stem_length_m / whole);
  Vec3 M = bar_second_moments(T.diameter_m, T.crossbar_length_m, 0, crossbar_kg) +
           bar_second_moments(T.diameter_m, T.stem_length_m, 1, stem_kg);
  M[1] += crossbar_kg * T.crossbar_at_m * T.crossbar_at_m + stem_kg * T.stem_at_m * T.stem_at_m;
  return from_second_moments(M);
}

Body make_body(std::string name, ShapeKind kind, const Vec3& size_m, double mass_kg) {
  return {std::move(name), moments_of(kind, size_m, mass_kg), Shape{kind, size_m}, mass_kg};
}

Shape equivalent_box(const PrincipalMoments& I, double mass_kg) {
  const int e = 2 * (std::ilogb(I.vector().maxCoeff()) / 2);  // even: its root is exact
  const Vec3 J = I.vector().unaryExpr([e](double x) { return std::scalbn(x, -e); });
  const auto edge = [&J](int i) {
    const double largest = std::max(J[(i + 1) % 3], J[(i + 2) % 3]);
    const double other = std::min(J[(i + 1) % 3], J[(i + 2) % 3]);
    return std::sqrt(std::max(0.0, 6 * ((largest - J[i]) + other)));
  };
  Vec3 size_m(edge(0), edge(1), edge(2));
  size_m = size_m.cwiseMax(kThinnestDrawn * size_m.maxCoeff());
  return {ShapeKind::box,
          size_m.unaryExpr([e](double x) { return std::scalbn(x, e / 2); }) / std::sqrt(mass_kg)};
}

std::string_view name_of(ShapeKind kind) { return kShapeNames[static_cast<std::size_t>(kind)]; }

std::vector<std::string> shape_kind_names() { return {kShapeNames.begin(), kShapeNames.end()}; }

std::optional<ShapeKind> shape_kind_from(std::string_view name) {
  const auto found = std::find(kShapeNames.begin(), kShapeNames.end(), name);
  if (found == kShapeNames.end()) return std::nullopt;
  return static_cast<ShapeKind>(found - kShapeNames.begin());
}

}  // namespace polhode
