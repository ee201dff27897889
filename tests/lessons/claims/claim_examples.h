// SPDX-License-Identifier: MIT
// States and expressions to try the evaluation with.
#pragma once

#include "lessons/claims/claim_state.h"

#include <random>
#include <string>
#include <vector>

namespace polhode::testing {

/// Random residues, none of them zero.
inline StateNumbers<FieldElement> random_numbers(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  StateNumbers<FieldElement> n;
  const auto fill = [&random](auto& all) {
    for (FieldElement& one : all) one = FieldElement(static_cast<std::int64_t>(1 + random() % (kPrime - 1)));
  };
  fill(n.q);
  fill(n.I);
  fill(n.J);
  for (auto* vector : {&n.w, &n.dw, &n.v_S, &n.dv_S, &n.A_S, &n.dA_S, &n.N_B, &n.F_S, &n.ddw, &n.ddv_S,
                       &n.ddA_S, &n.dN_B, &n.dF_S})
    fill(*vector);
  for (FieldElement* one : {&n.m, &n.h, &n.k})
    *one = FieldElement(static_cast<std::int64_t>(1 + random() % (kPrime - 1)));
  return n;
}

/// Every quantity and every operation of the language, alone and together.
inline const std::vector<std::string>& example_expressions() {
  static const std::vector<std::string> all = {
      "T",
      "I1*w1 - I2*w2 + I3*w3",
      "dw1 + dw2*dw3",
      "N1*N2 - N3",
      "m^3",
      "h*k - 2*h",
      "omega",
      "L",
      "N",
      "p",
      "v",
      "F",
      "A",
      "e1",
      "e2 - 2*e3",
      "Jxx*Jyy - Jxy^2 + Jzz*Jxz - Jyz",
      "-A",
      "A + v - F",
      "m*A",
      "0.25*A",
      "dot(A, L)",
      "cross(A, cross(v, omega))",
      "norm2(A)",
      "inertia(A)",
      "apply(J, v)",
      "comp(A, 1) + comp(v, 2)*comp(L, 3)",
      "trace(J)",
      "star(A)",
      "star(cross(v, L))",
      "ddt(A)",
      "ddt(L)",
      "ddt(inertia(A))",
      "ddt(apply(J, A))",
      "ddt(e2)",
      "ddt(dot(A, e1))",
      "ddt(T*w1)",
      "ddt(norm2(cross(A, omega)))",
      "ddt(comp(p, 3))",
      "inertia(star(apply(J, omega))) - apply(J, ddt(L))",
      "ddt(dw1) + N2*w1",
      "ddt(ddt(L)) + ddt(N)",
      "ddt(ddt(T)) - ddt(N3)*w3",
      "star(star(A)) + star(ddt(v))",
      "ddt(star(p)) - ddt(F)",
      "dot(ddt(ddt(e3)), A)",
  };
  return all;
}

/// The same with divisors.
inline const std::vector<std::string>& example_quotients() {
  static const std::vector<std::string> all = {
      "A/T", "w1/(w2 + w3)", "norm2(A)^(-2)", "ddt(1/(w1 + I2))", "ddt(A/norm2(A))", "star(L/dot(v, A))"};
  return all;
}

}  // namespace polhode::testing
