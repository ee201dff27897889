// SPDX-License-Identifier: MIT
// The motion of a rigid body as a function of time, and many times of it at once.
//
// Offers   Motion, whose at(t) is the state at any time t, past or future, asked in any order;
//          states_at: many times on several cores. method.h makes motions.
// Units    t in s from the start, ω in rad/s.
// Frames   ω_B in the body's principal axes; q_SB takes body components to space components.
// Errors   A time that cannot be computed gives NaN in every component. at throws only for lack of memory,
//          and what an Effort of one's own throws (method.h).
// Threads  One motion may be asked by any number of threads at the same time, and gives each the same bits.
//
// Example: a motion of one's own, a steady spin, asked at two times.
//
//     using namespace polhode;
//     struct Spin final : Motion {
//       RigidBodyState at(double t_s) const override {
//         return {Quat(std::cos(t_s), 0, 0, std::sin(t_s)), {0, 0, 2}};
//       }
//       std::string_view method() const override { return "spin"; }
//     };
//     const double times_s[] = {0.5, 1e6};
//     RigidBodyState states[2];
//     states_at(Spin(), times_s, states, 2);
//     const bool is_sane = states[1].w_B.z() == 2;
#pragma once

#include "physics/analysis/batch.h"
#include "physics/motion.h"
