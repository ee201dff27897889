// SPDX-License-Identifier: MIT
// Poinsot's construction: the surfaces and curves on which torque-free motion runs, and when it turns over.
//
// Offers   semi-axes of the ellipsoids of energy and momentum, the invariable plane; polhode, families of
//          polhodes, separatrices, herpolhode as polylines within a chord tolerance; the period of the
//          polhode; flip_times; sample_curve for curves of one's own.
// Units    rad/s for what is in ω-space, kg m²/s for what is in L-space, s; chord tolerances in rad/s.
// Frames   polhode, family, separatrices and ellipsoids in B; the herpolhode in S.
// Errors   std::domain_error for a chord tolerance or an energy that is not finite and > 0, and for a
//          polhode that does not exist. What a motion may lack, such as a period, is a std::optional.
//
// Example: a polhode to 1e-3 rad/s, and how long ω takes for one round of it.
//
//     using namespace polhode;
//     const PrincipalMoments I(1, 2, 3);
//     const Curve curve = polhode_curve(I, {0.01, 5, 0}, 1e-3);
//     const double period_s = polhode_period(I, {0.01, 5, 0}).value();
//     const bool is_sane = curve.closed && period_s > 0;
#pragma once

#include "physics/geometry/curve_sampling.h"
#include "physics/geometry/flips.h"
#include "physics/geometry/poinsot.h"
