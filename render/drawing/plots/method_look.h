// SPDX-License-Identifier: MIT
// How the curves of methods look in plots.
#pragma once

#include "physics/method_facts.h"
#include "render/drawing/plots/plot.h"

namespace polhode {

/// Explicit Runge-Kutta methods orange, geometric ones blue, adaptive ones purple, closed forms a star.
PlotLook look_of(Method method);
/// Among all methods of its look: each has its mark in every plot.
PlaceInLook place_of(Method method);

}  // namespace polhode
