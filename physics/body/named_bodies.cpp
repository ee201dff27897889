// SPDX-License-Identifier: MIT
// The table of named bodies. Sizes are those of ordinary specimens, density taken as uniform; where a body is
// known by measured moments the source stands beside it.
#include "physics/body/bodies.h"

#include <array>

namespace polhode {
namespace {

struct Entry {
  std::string_view name;
  Body (*make)(std::string name);
};

template <ShapeKind kind>
Body solid(std::string name, double a_m, double b_m, double c_m, double mass_kg) {
  return make_body(std::move(name), kind, Vec3(a_m, b_m, c_m), mass_kg);
}

constexpr auto box = solid<ShapeKind::box>;
constexpr auto ellipsoid = solid<ShapeKind::ellipsoid>;
constexpr auto cylinder = solid<ShapeKind::cylinder>;
constexpr auto t_handle = solid<ShapeKind::t_handle>;

// No specimen: three distinct moments in easy ratio, the lecture's own example.
Body textbook(std::string name) { return {std::move(name), {1.0, 1.75, 2.5}, std::nullopt}; }

// Hardback: height (along the spine), width, thickness.
Body book(std::string name) { return box(std::move(name), 0.24, 0.17, 0.03, 0.8); }

// Tennis racket: 1 the handle, 2 across the head in its plane, 3 normal to the head. Rounded from measured
// rackets as in H. Brody, "The moment of inertia of a tennis racket", Phys. Teach. 23 (1985) 213. Nearly
// flat: I3 ≈ I1 + I2.
Body racket(std::string name) { return {std::move(name), {0.0012, 0.0164, 0.0175}, std::nullopt}; }

// Smartphone: height, width, thickness of a common model, 174 g.
Body phone(std::string name) { return box(std::move(name), 0.147, 0.0715, 0.0078, 0.174); }

// Steel handle as spun on the space station (Dzhanibekov's wing nut, enlarged): 7850 kg/m³ × volume.
Body steel_t_handle(std::string name) { return t_handle(std::move(name), 0.12, 0.07, 0.012, 0.158); }

// E. Groten, "Fundamental parameters and current (2004) best estimates...", J. Geodesy 77 (2004) 724: A
// = 8.0101e37, B = 8.0103e37, C = 8.0365e37 kg m². A and B are replaced by their mean, so the body is a
// symmetric top and its free nutation has Euler's period of 305 days. Drawn as the WGS 84 ellipsoid; the
// density is not uniform.
Body earth(std::string name) {
  return {std::move(name),
          {8.0102e37, 8.0102e37, 8.0365e37},
          Shape{ShapeKind::ellipsoid, Vec3(12756274.0, 12756274.0, 12713504.6284)},
          5.9722e24};
}

// Moments of the lecture's stage `trust`, axis 3 along the rod: a cylinder of 1 kg with l² = 12(I1 − I3/2),
// d² = 8 I3.
Body slender_rod(std::string name) {
  return {std::move(name),
          {1.0, 1.0, 1e-4},
          Shape{ShapeKind::cylinder, Vec3(0.0282842712474619, 0.0282842712474619, 3.4640150115148147)}};
}

// Steel darning needle, 7850 kg/m³ × volume; axis 3 along it.
Body needle(std::string name) { return cylinder(std::move(name), 0.001, 0.001, 0.06, 0.00037); }

// Quoit-like plate; axis 3 normal to it.
Body disc(std::string name) { return cylinder(std::move(name), 0.3, 0.3, 0.01, 1.0); }

Body sphere(std::string name) { return ellipsoid(std::move(name), 0.2, 0.2, 0.2, 1.0); }
Body plain_box(std::string name) { return box(std::move(name), 0.3, 0.2, 0.1, 1.0); }
Body plain_ellipsoid(std::string name) { return ellipsoid(std::move(name), 0.3, 0.2, 0.1, 1.0); }
Body plain_cylinder(std::string name) { return cylinder(std::move(name), 0.1, 0.1, 0.3, 1.0); }

constexpr std::array<Entry, 13> kBodies{{
    {"textbook", textbook},
    {"book", book},
    {"racket", racket},
    {"phone", phone},
    {"t-handle", steel_t_handle},
    {"earth", earth},
    {"slender-rod", slender_rod},
    {"needle", needle},
    {"disc", disc},
    {"sphere", sphere},
    {"box", plain_box},
    {"ellipsoid", plain_ellipsoid},
    {"cylinder", plain_cylinder},
}};

}  // namespace

std::optional<Body> find_body(std::string_view name) {
  for (const Entry& entry : kBodies) {
    if (entry.name == name) return entry.make(std::string(name));
  }
  return std::nullopt;
}

std::vector<std::string> named_bodies() {
  std::vector<std::string> names;
  for (const Entry& entry : kBodies) names.emplace_back(entry.name);
  return names;
}

}  // namespace polhode
