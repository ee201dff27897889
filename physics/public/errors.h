// SPDX-License-Identifier: MIT
// How good a computed motion is: how far from the true one, what it has kept, how far ahead it can be known
// at all, and what its accuracy costs.
//
// Offers   error_of: the distance of two states; drift_along: what a motion has lost of T and L;
//          conditioning, closed_form_error, horizon_of: how far ahead a motion can be predicted from doubles;
//          characteristic_time; measure_work_precision: error against CPU time, method by method.
// Units    errors relative or in rad; times in s, or in periods where the name says so.
// Frames   none: every number is a magnitude.
// Errors   What does not exist, such as the period of a steady rotation, is an empty std::optional; what is
//          not kept or cannot be computed is NaN; a measurement without a reference is a Result that holds
//          the reason.
//
// Example: how far RK4 with a step of 10 ms is from the closed form after a minute.
//
//     using namespace polhode;
//     const Problem problem{{1, 2, 3}, {.w_B = {0.1, 1.5, 0.2}}, {}};
//     const auto exact = make_motion(problem, {Method::exact});
//     const auto rk4 = make_motion(problem, {Method::rk4, 0.01});
//     const StateError error = error_of(rk4->at(60), exact->at(60));
//     const bool is_sane = error.omega < 1e-6 && error.attitude_rad < 1e-6;
#pragma once

#include "physics/analysis/characteristic_time.h"
#include "physics/analysis/conditioning.h"
#include "physics/analysis/horizon.h"
#include "physics/analysis/motion_errors.h"
#include "physics/analysis/work_precision.h"
#include "physics/method.h"
