// SPDX-License-Identifier: MIT
#include "render/scene/description/overlay.h"

#include <algorithm>

namespace polhode {
namespace {

using O = Overlay;
using R = Requirements;
using S = SeenIf;
using In = AttitudeIn;

// One row for each overlay. What needs the polhode or the attitude needs omega, too (model.cpp).
constexpr std::array<OverlayFacts, kOverlayCount> kFacts = {{
    {.overlay = O::shape,
     .name = "shape",
     .words = "the solid body",
     .attitude = In::space,
     .needs = {&R::solid},
     .stays_in_turns = true},
    {.overlay = O::energy_ellipsoid,
     .name = "energy-ellipsoid",
     .words = "the energy ellipsoid",
     .seen_if = S::moves,
     .attitude = In::space},
    {.overlay = O::momentum_sphere,
     .name = "momentum-sphere",
     .words = "the sphere of constant angular momentum",
     .seen_if = S::moves,
     .attitude = In::space},
    {.overlay = O::momentum_ellipsoid,
     .name = "momentum-ellipsoid",
     .words = "the momentum ellipsoid",
     .seen_if = S::moves,
     .attitude = In::space},
    {.overlay = O::omega,
     .name = "omega",
     .words = "the angular velocity ω",
     .seen_if = S::moves,
     .attitude = In::space,
     .needs = {&R::omega}},
    {.overlay = O::L,
     .name = "L",
     .words = "the angular momentum L",
     .seen_if = S::moves,
     .attitude = In::space,
     .needs = {&R::omega}},
    {.overlay = O::N,
     .name = "N",
     .words = "the torque N",
     .seen_if = S::torque,
     .attitude = In::space,
     .needs = {&R::omega}},
    {.overlay = O::axes_body,
     .name = "axes-body",
     .words = "the body axes 1, 2, 3",
     .attitude = In::space,
     .stays_in_turns = true},
    {.overlay = O::axes_space,
     .name = "axes-space",
     .words = "the space axes x, y, z",
     .attitude = In::body,
     .stays_in_turns = true},
    {.overlay = O::polhode,
     .name = "polhode",
     .words = "the polhode",
     .seen_if = S::free | S::moves,
     .attitude = In::space,
     .needs = {&R::omega, &R::polhode}},
    {.overlay = O::polhode_family,
     .name = "polhode-family",
     .words = "the family of polhodes of the same energy",
     .seen_if = S::moves,
     .attitude = In::space,
     .needs = {&R::polhode_family}},
    {.overlay = O::separatrix,
     .name = "separatrix",
     .words = "the separatrices",
     .seen_if = S::moves,
     .attitude = In::space,
     .needs = {&R::separatrix}},
    {.overlay = O::herpolhode,
     .name = "herpolhode",
     .words = "the herpolhode",
     .seen_if = S::free | S::moves | S::space_view,
     .needs = {&R::herpolhode}},
    {.overlay = O::plane,
     .name = "plane",
     .words = "the invariable plane",
     .seen_if = S::free | S::moves | S::space_view | S::L_down,
     .needs = {&R::omega}},
    {.overlay = O::trail_L,
     .name = "trail-L",
     .words = "the trail of the tip of L",
     .seen_if = S::moves,
     .attitude = In::space,
     .needs = {&R::omega, &R::trail_L}},
    {.overlay = O::trail_omega,
     .name = "trail-omega",
     .words = "the trail of the tip of ω",
     .seen_if = S::moves,
     .attitude = In::space,
     .needs = {&R::omega, &R::trail_omega}},
    {.overlay = O::cones,
     .name = "cones",
     .words = "the body cone and the space cone",
     .seen_if = S::free | S::moves,
     .attitude = In::space,
     .needs = {&R::polhode, &R::herpolhode, &R::cones}},
    {.overlay = O::labels, .name = "labels", .words = "", .stays_in_turns = true},
    {.overlay = O::values, .name = "values", .words = "the computed values", .needs = {&R::omega}},
    {.overlay = O::turn_orders,
     .name = "turn-orders",
     .words = "the body turned by a quarter about x and then y, and beside it about y and then x",
     .needs = {&R::solid},
     .stays_in_turns = true},
    {.overlay = O::p, .name = "p", .words = "the momentum p of the centre of mass", .seen_if = S::translates},
    {.overlay = O::v, .name = "v", .words = "the velocity v of the centre of mass", .seen_if = S::translates},
    {.overlay = O::F, .name = "F", .words = "the force F", .seen_if = S::force},
    {.overlay = O::puck, .name = "puck", .words = "a sliding puck"},
    {.overlay = O::transport,
     .name = "transport",
     .words = "an arrow A, at its tip a triangle of dA/dt, d*A/dt and ω×A",
     .seen_if = S::moves,
     .attitude = In::both},
    {.overlay = O::terms,
     .name = "terms",
     .words = "the arrows of I·ω̇ and ω×(I·ω), which add up to N",
     .seen_if = S::moves,
     .attitude = In::space,
     .needs = {&R::omega, &R::terms}},
    {.overlay = O::pivot,
     .name = "pivot",
     .words = "the stand and the axle",
     .seen_if = S::pivot,
     .attitude = In::space},
    {.overlay = O::tensor_bars,
     .name = "tensor-bars",
     .words = "bars of the components of I in space and in the body",
     .attitude = In::both,
     .is_diagram = true},
    {.overlay = O::cofactors,
     .name = "cofactors",
     .words = "ω×(I·ω) as a determinant with its cofactors",
     .needs = {&R::omega},
     .is_diagram = true},
    {.overlay = O::cyclic_wheel,
     .name = "cyclic-wheel",
     .words = "the wheel of the indices 1, 2, 3",
     .needs = {&R::omega},
     .is_diagram = true},
    {.overlay = O::energy_rows,
     .name = "energy-rows",
     .words = "the three products that cancel in the rate of the energy",
     .needs = {&R::omega},
     .is_diagram = true},
    {.overlay = O::momentum_rows,
     .name = "momentum-rows",
     .words = "the three products that cancel in the rate of L·L",
     .needs = {&R::omega},
     .is_diagram = true},
    {.overlay = O::cards, .name = "cards", .words = "cards of the twelve equations", .is_diagram = true},
    {.overlay = O::method_table,
     .name = "method-table",
     .words = "a table of methods, their errors and their cost",
     .needs = {&R::methods},
     .is_diagram = true},
    {.overlay = O::order_plot,
     .name = "order-plot",
     .words = "the errors of methods against the number of their steps, and their measured orders",
     .needs = {&R::orders},
     .is_diagram = true},
}};

constexpr bool is_in_order() {
  for (std::size_t i = 0; i < kFacts.size(); ++i)
    if (static_cast<std::size_t>(kFacts[i].overlay) != i) return false;
  return true;
}
static_assert(is_in_order(), "the rows stand in the order of the enumeration");

}  // namespace

const OverlayFacts& facts_of(Overlay overlay) { return kFacts[static_cast<std::size_t>(overlay)]; }

std::string_view name_of(Overlay overlay) { return facts_of(overlay).name; }

std::optional<Overlay> overlay_from(std::string_view name) {
  const auto found = std::find_if(kFacts.begin(), kFacts.end(),
                                  [&](const OverlayFacts& facts) { return facts.name == name; });
  return found == kFacts.end() ? std::nullopt : std::optional(found->overlay);
}

const std::vector<std::string>& overlay_names() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> all;
    for (const OverlayFacts& facts : kFacts) all.emplace_back(facts.name);
    return all;
  }();
  return kNames;
}

}  // namespace polhode
