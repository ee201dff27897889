// SPDX-License-Identifier: MIT
// Bodies, states and torques: what is to be followed in time. The first of the library's five public headers;
// motion.h, method.h, poinsot.h and errors.h are the others. Together they are the interface.
//
// Offers   Vec3, Quat (Eigen's); PrincipalMoments, which only moments that some body has can make; Body and
//          Shape: boxes, ellipsoids, cylinders, T-handles of uniform density, and bodies with names;
//          RigidBodyState: attitude and ω; L, T and Euler's equations; Torque: a sum of terms; Problem: all
//          of it at t = 0.
// Units    SI and radians: kg, m, s, kg m², rad/s, N m, J.
// Frames   S is the inertial space frame, B the body's frame of principal axes. v_B are components in B, v_S
//          in S; v_S = q_SB * v_B. Quaternions are Hamilton's, active; Quat(w, x, y, z).
// Errors   What no rigid body can have throws std::domain_error, whose text says what is wrong.
//
// Example: energy and angular momentum of a book that turns about its intermediate axis.
//
//     using namespace polhode;
//     const Body book = *find_body("book");
//     const RigidBodyState start{.w_B = {0.01, 5, 0}};
//     const double T_J = kinetic_energy(book.moments, start.w_B);
//     const Vec3 L_S = angular_momentum_S(book.moments, start);
//     const bool is_sane = T_J > 0 && L_S.norm() > 0;
#pragma once

#include "physics/body/bodies.h"
#include "physics/body/euler.h"
#include "physics/body/principal_moments.h"
#include "physics/body/problem.h"
#include "physics/body/state.h"
#include "physics/body/torque.h"
#include "physics/body/types.h"
