// SPDX-License-Identifier: MIT
// What a scene can show. To add an overlay: one line here, one in overlay.cpp's table, one builder in
// builders/.
#pragma once

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

/// Flat figures (boards/boards.h): they come last in the enumeration.
constexpr bool is_board(Overlay overlay) { return overlay >= Overlay::tensor_bars; }

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
