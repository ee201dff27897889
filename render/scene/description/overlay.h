// SPDX-License-Identifier: MIT
// What a scene can show. To add an overlay: its name here, its row in overlay.cpp, and the builder that draws
// it (render/figure/builders/ in space, render/drawing/diagrams/ on paper).
#pragma once

#include "render/scene/description/requirements.h"

#include <array>
#include <bitset>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

enum class Overlay {
  shape,               ///< the body itself, solid
  energy_ellipsoid,    ///< Σ I_i ω_i² = 2T, ω-space; its surface carries ω's tip
  momentum_sphere,     ///< |L| = const, L-space, body axes
  momentum_ellipsoid,  ///< Σ L_i²/I_i = 2T, L-space, body axes
  omega,               ///< ω, its tip on the energy ellipsoid
  L,                   ///< L at a fixed length along its direction; under torque true to scale
  N,                   ///< torque, where it is not zero
  axes_body,           ///< triad of B: 1, 2, 3
  axes_space,          ///< triad of S: x, y, z
  polhode,             ///< path of ω in the body
  polhode_family,      ///< polhodes of the same energy, coloured by L²/2T
  separatrix,          ///< the two ellipses L² = 2T·I_mid
  herpolhode,          ///< path of ω in space, on the invariable plane
  plane,               ///< invariable plane ω·L = 2T
  trail_L,             ///< where the tip of L has been
  trail_omega,         ///< where the tip of ω has been
  cones,               ///< body cone and space cone swept by ω
  labels,              ///< names of what is shown
  values,              ///< computed numbers: moments, 2T, |L|, L²/2T
  turn_orders,         ///< the body turned about x then y, and about y then x, in two panes
  p,                   ///< momentum of the centre of mass
  v,                   ///< velocity of the centre of mass
  F,                   ///< force on the centre of mass, where it is not zero
  puck,                ///< a puck that slides beside the body, with its v and p
  transport,           ///< an arrow A; at its tip d*A/dt, ω×A and dA/dt close a triangle
  terms,               ///< I·ω̇ and ω×(I·ω) head to tail; their sum is N
  pivot,               ///< stand and axle of a heavy top
  tensor_bars,         ///< components of I in S beside those in S*
  cofactors,           ///< ω×(I·ω) as a determinant, one cofactor after the other
  cyclic_wheel,        ///< 1→2→3→1, and the term that it gives
  energy_rows,         ///< the three products ω_i·(10…12), which cancel
  momentum_rows,       ///< the three products I_i ω_i·(10…12), which cancel
  cards,               ///< the twelve equations
  method_table,        ///< methods × step: errors and cost
  order_plot,          ///< error of each method against its step, and the order that it shows
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
  std::string_view name;   ///< in lessons
  std::string_view words;  ///< in alternative texts; empty: it only says more of the rest
  SeenIf seen_if = SeenIf::always;
  AttitudeIn attitude = AttitudeIn::none;
  /// Parts of the model; null: no more.
  std::array<bool Requirements::*, 3> needs = {};
  bool is_diagram = false;      ///< flat, with a place of its own (render/drawing/diagrams/)
  bool stays_in_turns = false;  ///< also where the body is turned by hand, and has no motion (turn_orders)
};
const OverlayFacts& facts_of(Overlay overlay);
inline bool is_diagram(Overlay overlay) { return facts_of(overlay).is_diagram; }

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

}  // namespace polhode
