// SPDX-License-Identifier: MIT
#include "physics/integrators/scaled_problem.h"

#include "physics/exact/powers_of_two.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polhode {
namespace {

constexpr int kNone = std::numeric_limits<int>::min() / 4;

int exponent(double x) { return x == 0 ? kNone : std::ilogb(x); }
int exponent(const Vec3& v) { return exponent(v.cwiseAbs().maxCoeff()); }

// Exponents of the torque a term exerts on a body at rest.
struct TermExponent {
  int operator()(const SpaceTorque& term) const { return exponent(term.N_S); }
  int operator()(const BodyTorque& term) const { return exponent(term.N_B); }
  int operator()(const HeavyTop& term) const { return exponent(term.mgr); }
  int operator()(const LinearDamping&) const { return kNone; }
  int operator()(const EnergySink&) const { return kNone; }
};

struct ScaledTerm {
  int eI, ew;

  TorqueTerm operator()(const SpaceTorque& term) const {
    return SpaceTorque{times_two_to(-eI - 2 * ew, term.N_S)};
  }
  TorqueTerm operator()(const BodyTorque& term) const {
    return BodyTorque{times_two_to(-eI - 2 * ew, term.N_B)};
  }
  TorqueTerm operator()(const HeavyTop& term) const {
    return HeavyTop{std::scalbn(term.mgr, -eI - 2 * ew), term.axis_B};
  }
  TorqueTerm operator()(const LinearDamping& term) const {
    return LinearDamping{std::scalbn(term.c, -eI - ew)};
  }
  TorqueTerm operator()(const EnergySink& term) const { return term; }
};

int half_rounded_down(int e) { return (e - (e & 1)) / 2; }

}  // namespace

Problem in_units(const Problem& problem, int eI, int ew) {
  // A moment that falls out of the range is kept above 0: the body is possible.
  const Vec3 I = times_two_to(-eI, problem.I.vector()).cwiseMax(std::numeric_limits<double>::min());
  Problem result{PrincipalMoments(I[0], I[1], I[2]), problem.start, {}};
  result.start.w_B = times_two_to(-ew, problem.start.w_B);
  for (const TorqueTerm& term : problem.torque) result.torque.push_back(std::visit(ScaledTerm{eI, ew}, term));
  return result;
}

ScaledProblem scaled(const Problem& problem) {
  const int eI = exponent(problem.I.vector());
  int ew = exponent(problem.start.w_B);
  for (const TorqueTerm& term : problem.torque) {
    const int eN = std::visit(TermExponent{}, term);
    if (eN != kNone) ew = std::max(ew, half_rounded_down(eN - eI));
  }
  if (ew == kNone) ew = 0;

  return {in_units(problem, eI, ew), ew};
}

}  // namespace polhode
