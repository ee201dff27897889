// SPDX-License-Identifier: MIT
// The methods that follow a body in time, each by its name, and the motion that one of them makes.
//
// Offers   make_motion: the closed form of a free body or of a symmetric top, or an integrator, behind one
//          interface; the table of methods: what each is called, which torques it serves, its order, what it
//          keeps; Effort and Budget: to be told what a motion costs while it is computed, to stop it or to
//          limit it.
// Units    step_s in s; tolerance: error of one step, ω relative and q absolute.
// Frames   those of motion.h.
// Errors   std::domain_error from make_motion: a state or torque that is not finite, a method that does not
//          serve the problem (the text names those that do), a step that is missing or out of range, a
//          tolerance out of range.
//
// Example: a body thrown with a spin about its intermediate axis, an hour later.
//
//     using namespace polhode;
//     const Problem problem{{1, 1.75, 2.5}, {.w_B = {0.01, 5, 0}}, {}};
//     const auto motion = make_motion(problem, {Method::exact});
//     const RigidBodyState later = motion->at(3600);
//     const bool is_sane = std::abs(later.q_SB.norm() - 1) < 1e-15;
#pragma once

#include "physics/effort.h"
#include "physics/method.h"
