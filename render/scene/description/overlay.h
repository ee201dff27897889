// SPDX-License-Identifier: MIT
// What a scene can show. To add an overlay: its row here, and a file with the builder that draws it, which is
// named in a list: kBuilders in render/figure/builders/builders.h of what is drawn in space, kKinds in
// render/drawing/diagrams/diagram_paper.h of what is drawn on paper. In space it has its label in
// render/figure/builders/labels.cpp, and in extents.cpp where it can come. A stage of
// docs/overlays/overlays.md says what it is and shows it, with a picture beside it; lessons/FORMAT.md lists
// its name, and has a line of it where there is more to know.
#pragma once

#include "base/words/phrase.h"
#include "render/scene/description/requirements.h"

#include <array>
#include <bitset>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// What each shows: docs/overlays/overlays.md, in a sentence and a picture.
enum class Overlay {
  shape,
  energy_ellipsoid,
  momentum_sphere,
  momentum_ellipsoid,
  omega,
  L,
  N,
  axes_body,
  axes_space,
  room,
  polhode,
  polhode_family,
  separatrix,
  herpolhode,
  plane,
  rolling_ticks,
  trail_L,
  trail_omega,
  cones,
  labels,
  values,
  turn_orders,
  p,
  v,
  F,
  puck,
  transport,
  terms,
  pivot,
  spin,
  tensor_bars,
  cofactors,
  cyclic_wheel,
  energy_rows,
  momentum_rows,
  cards,
  method_table,
  order_plot,
};
inline constexpr int kOverlayCount = static_cast<int>(Overlay::order_plot) + 1;

/// What has to hold of a scene for there to be something to see; several are added up.
enum class SeenIf : unsigned {
  always = 0,
  free = 1,         ///< no torque acts: polhode, herpolhode, cones and invariable plane belong to free motion
  torque = 2,       ///< a torque acts
  moves = 4,        ///< not at rest without torque
  space_view = 8,   ///< seen from space
  L_down = 16,      ///< L points down: only there is the invariable plane level
  translates = 32,  ///< the centre of mass moves
  force = 64,       ///< a force acts on the centre of mass
  pivot = 128,      ///< the body is a heavy top
};
constexpr SeenIf operator|(SeenIf a, SeenIf b) {
  return static_cast<SeenIf>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}

/// In which views the attitude is needed to draw it.
enum class AttitudeIn { none, space, body, both };

struct OverlayFacts {
  Overlay overlay;
  std::string_view name;  ///< in lessons
  Phrase words;           ///< in alternative texts; empty: it only says more of the rest
  SeenIf seen_if = SeenIf::always;
  AttitudeIn attitude = AttitudeIn::none;
  /// Parts of the model; null: no more.
  std::array<bool Requirements::*, 3> needs = {};
  bool is_diagram = false;      ///< flat, with a place of its own (render/drawing/diagrams/)
  bool stays_in_turns = false;  ///< also where the body is turned by hand, and has no motion (turn_orders)
};

/// One row for each overlay, in the order of the enumeration. What needs the polhode or the attitude needs
/// omega, too (scene_needs.cpp).
inline constexpr std::array<OverlayFacts, kOverlayCount> kOverlays = [] {
  using O = Overlay;
  using R = Requirements;
  using S = SeenIf;
  using In = AttitudeIn;
  return std::array<OverlayFacts, kOverlayCount>{{
      {.overlay = O::shape,
       .name = "shape",
       .words = {"the solid body", "der Körper"},
       .attitude = In::space,
       .needs = {&R::solid},
       .stays_in_turns = true},
      {.overlay = O::energy_ellipsoid,
       .name = "energy-ellipsoid",
       .words = {"the energy ellipsoid", "das Energieellipsoid"},
       .seen_if = S::moves,
       .attitude = In::space},
      {.overlay = O::momentum_sphere,
       .name = "momentum-sphere",
       .words = {"the sphere of constant angular momentum", "die Kugel konstanten Drehimpulses"},
       .seen_if = S::moves,
       .attitude = In::space},
      {.overlay = O::momentum_ellipsoid,
       .name = "momentum-ellipsoid",
       .words = {"the momentum ellipsoid", "das Drehimpulsellipsoid"},
       .seen_if = S::moves,
       .attitude = In::space},
      {.overlay = O::omega,
       .name = "omega",
       .words = {"the angular velocity ω", "die Winkelgeschwindigkeit ω"},
       .seen_if = S::moves,
       .attitude = In::space,
       .needs = {&R::omega}},
      {.overlay = O::L,
       .name = "L",
       .words = {"the angular momentum L", "der Drehimpuls L"},
       .seen_if = S::moves,
       .attitude = In::space,
       .needs = {&R::omega}},
      {.overlay = O::N,
       .name = "N",
       .words = {"the torque N", "das Drehmoment N"},
       .seen_if = S::torque,
       .attitude = In::space,
       .needs = {&R::omega}},
      {.overlay = O::axes_body,
       .name = "axes-body",
       .words = {"the body axes 1, 2, 3", "die Körperachsen 1, 2, 3"},
       .attitude = In::space,
       .stays_in_turns = true},
      {.overlay = O::axes_space,
       .name = "axes-space",
       .words = {"the space axes x, y, z", "die raumfesten Achsen x, y, z"},
       .attitude = In::body,
       .stays_in_turns = true},
      {.overlay = O::room,
       .name = "room",
       .words = {"a room at rest in space", "ein ruhender Raum"},
       .attitude = In::body,
       .stays_in_turns = true},
      {.overlay = O::polhode,
       .name = "polhode",
       .words = {"the polhode", "die Polhodie"},
       .seen_if = S::free | S::moves,
       .attitude = In::space,
       .needs = {&R::omega, &R::polhode}},
      {.overlay = O::polhode_family,
       .name = "polhode-family",
       .words = {"the family of polhodes of the same energy", "die Schar der Polhodien gleicher Energie"},
       .seen_if = S::moves,
       .attitude = In::space,
       .needs = {&R::polhode_family}},
      {.overlay = O::separatrix,
       .name = "separatrix",
       .words = {"the separatrices", "die Separatrizen"},
       .seen_if = S::moves,
       .attitude = In::space,
       .needs = {&R::separatrix}},
      {.overlay = O::herpolhode,
       .name = "herpolhode",
       .words = {"the herpolhode", "die Herpolhodie"},
       .seen_if = S::free | S::moves | S::space_view,
       .needs = {&R::herpolhode}},
      {.overlay = O::plane,
       .name = "plane",
       .words = {"the invariable plane", "die invariable Ebene"},
       .seen_if = S::free | S::moves | S::space_view | S::L_down,
       .needs = {&R::omega}},
      {.overlay = O::rolling_ticks,
       .name = "rolling-ticks",
       .words = {"ticks of equal arc length on the polhode and on the herpolhode",
                 "Marken gleicher Bogenlänge auf Polhodie und Herpolhodie"},
       .seen_if = S::free | S::moves | S::space_view,
       .attitude = In::space,
       .needs = {&R::omega, &R::rolling_ticks}},
      {.overlay = O::trail_L,
       .name = "trail-L",
       .words = {"the trail of the tip of L", "die Spur der Spitze von L"},
       .seen_if = S::moves,
       .attitude = In::space,
       .needs = {&R::omega, &R::trail_L}},
      {.overlay = O::trail_omega,
       .name = "trail-omega",
       .words = {"the trail of the tip of ω", "die Spur der Spitze von ω"},
       .seen_if = S::moves,
       .attitude = In::space,
       .needs = {&R::omega, &R::trail_omega}},
      {.overlay = O::cones,
       .name = "cones",
       .words = {"the body cone and the space cone", "der Gangpolkegel und der Rastpolkegel"},
       .seen_if = S::free | S::moves,
       .attitude = In::space,
       .needs = {&R::polhode, &R::herpolhode, &R::cones}},
      {.overlay = O::labels, .name = "labels", .words = {"", ""}, .stays_in_turns = true},
      {.overlay = O::values,
       .name = "values",
       .words = {"the computed values", "die berechneten Werte"},
       .needs = {&R::omega}},
      {.overlay = O::turn_orders,
       .name = "turn-orders",
       .words = {"the body turned by a quarter about x and then y, and beside it about y and then x",
                 "der Körper, um je eine Vierteldrehung erst um x, dann um y gedreht, daneben erst um y, "
                 "dann um x"},
       .needs = {&R::solid},
       .stays_in_turns = true},
      {.overlay = O::p,
       .name = "p",
       .words = {"the momentum p of the centre of mass", "der Impuls p des Schwerpunkts"},
       .seen_if = S::translates},
      {.overlay = O::v,
       .name = "v",
       .words = {"the velocity v of the centre of mass", "die Geschwindigkeit v des Schwerpunkts"},
       .seen_if = S::translates},
      {.overlay = O::F, .name = "F", .words = {"the force F", "die Kraft F"}, .seen_if = S::force},
      {.overlay = O::puck, .name = "puck", .words = {"a sliding puck", "ein gleitender Puck"}},
      {.overlay = O::transport,
       .name = "transport",
       .words = {"an arrow A, at its tip a triangle of dA/dt, d*A/dt and ω×A",
                 "ein Pfeil A, an seiner Spitze ein Dreieck aus dA/dt, d*A/dt und ω×A"},
       .seen_if = S::moves,
       .attitude = In::both},
      {.overlay = O::terms,
       .name = "terms",
       .words = {"the arrows of I·ω̇ and ω×(I·ω), which add up to N",
                 "die Pfeile von I·ω̇ und ω×(I·ω), deren Summe N ist"},
       .seen_if = S::moves,
       .attitude = In::space,
       .needs = {&R::omega, &R::terms}},
      {.overlay = O::pivot,
       .name = "pivot",
       .words = {"the stand and the axle", "das Stativ und die Achse"},
       .seen_if = S::pivot,
       .attitude = In::space},
      {.overlay = O::spin,
       .name = "spin",
       .words = {"an arrow bent about axis 3, the way the body spins",
                 "ein um Achse 3 gebogener Pfeil, in dessen Sinn sich der Körper dreht"},
       .seen_if = S::moves,
       .attitude = In::space,
       .needs = {&R::omega}},
      {.overlay = O::tensor_bars,
       .name = "tensor-bars",
       .words = {"bars of the components of I in space and in the body",
                 "Balken der Komponenten von I im Raum und im Körper"},
       .attitude = In::both,
       .is_diagram = true},
      {.overlay = O::cofactors,
       .name = "cofactors",
       .words = {"ω×(I·ω) as a determinant with its cofactors",
                 "ω×(I·ω) als Determinante mit ihren Unterdeterminanten"},
       .needs = {&R::omega},
       .is_diagram = true},
      {.overlay = O::cyclic_wheel,
       .name = "cyclic-wheel",
       .words = {"the wheel of the indices 1, 2, 3", "das Rad der Indizes 1, 2, 3"},
       .needs = {&R::omega},
       .is_diagram = true},
      {.overlay = O::energy_rows,
       .name = "energy-rows",
       .words = {"the three products that cancel in the rate of the energy",
                 "die drei Produkte, die sich in der Änderungsrate der Energie aufheben"},
       .needs = {&R::omega},
       .is_diagram = true},
      {.overlay = O::momentum_rows,
       .name = "momentum-rows",
       .words = {"the three products that cancel in the rate of L·L",
                 "die drei Produkte, die sich in der Änderungsrate von L·L aufheben"},
       .needs = {&R::omega},
       .is_diagram = true},
      {.overlay = O::cards,
       .name = "cards",
       .words = {"cards of the twelve equations", "Karten der zwölf Gleichungen"},
       .is_diagram = true},
      {.overlay = O::method_table,
       .name = "method-table",
       .words = {"a table of methods, their errors and their cost",
                 "eine Tabelle der Verfahren, ihrer Fehler und ihres Aufwands"},
       .needs = {&R::methods},
       .is_diagram = true},
      {.overlay = O::order_plot,
       .name = "order-plot",
       .words = {"the errors of methods against their work, and their measured orders",
                 "die Fehler der Verfahren über ihrem Aufwand und ihre gemessenen Ordnungen"},
       .needs = {&R::orders},
       .is_diagram = true},
  }};
}();

constexpr const OverlayFacts& facts_of(Overlay overlay) {
  return kOverlays[static_cast<std::size_t>(overlay)];
}
constexpr bool is_diagram(Overlay overlay) { return facts_of(overlay).is_diagram; }

/// "energy-ellipsoid", "omega", "L", ... as in lessons and in `info`.
std::string_view name_of(Overlay overlay);
std::optional<Overlay> overlay_from(std::string_view name);
/// All names in the order of the enumeration (for "did you mean").
const std::vector<std::string>& overlay_names();

class OverlaySet {
 public:
  OverlaySet() = default;
  OverlaySet(std::initializer_list<Overlay> overlays) {
    for (Overlay o : overlays) insert(o);
  }
  void insert(Overlay o) { bits_.set(static_cast<std::size_t>(o)); }
  void erase(Overlay o) { bits_.reset(static_cast<std::size_t>(o)); }
  bool contains(Overlay o) const { return bits_.test(static_cast<std::size_t>(o)); }
  bool empty() const { return bits_.none(); }
  bool operator==(const OverlaySet&) const = default;

 private:
  std::bitset<kOverlayCount> bits_;
};

/// The diagrams of an overlay set, in the order of the enumeration.
std::vector<Overlay> diagrams_in(const OverlaySet& drawn);
/// Whether there is a figure in space: without diagrams always, beside them of marks (mark.h) and anything
/// else but names and values.
bool shows_space(const OverlaySet& drawn, bool has_marks);
/// Whether there is nothing to be seen, in space or on paper: names and values alone are of nothing.
bool shows_nothing(const OverlaySet& drawn, bool has_marks);

}  // namespace polhode
