// SPDX-License-Identifier: MIT
#include "lessons/claims/proof/dependence.h"

#include <utility>

namespace polhode {

const std::array<bool Dependence::*, 19> Dependence::kParts = {
    &Dependence::I, &Dependence::J,  &Dependence::w,   &Dependence::dw, &Dependence::ddw,
    &Dependence::N, &Dependence::dN, &Dependence::v,   &Dependence::dv, &Dependence::ddv,
    &Dependence::A, &Dependence::dA, &Dependence::ddA, &Dependence::F,  &Dependence::dF,
    &Dependence::m, &Dependence::h,  &Dependence::k,   &Dependence::q};

namespace {

Dependence of_quantity(Quantity quantity) {
  using S = Quantity;
  Dependence d;
  switch (quantity) {
    case S::I1:
    case S::I2:
    case S::I3:
      d.I = true;
      break;
    case S::T:
    case S::L:
      d.I = d.w = true;
      break;
    case S::w1:
    case S::w2:
    case S::w3:
    case S::omega:
      d.w = true;
      break;
    case S::dw1:
    case S::dw2:
    case S::dw3:
      d.dw = true;
      break;
    case S::N1:
    case S::N2:
    case S::N3:
    case S::N:
      d.N = true;
      break;
    case S::m:
      d.m = true;
      break;
    case S::h:
      d.h = true;
      break;
    case S::k:
      d.k = true;
      break;
    case S::p:
      d.m = d.v = true;
      break;
    case S::v:
      d.v = true;
      break;
    case S::F:
      d.F = true;
      break;
    case S::A:
      d.A = true;
      break;
    case S::e1:
    case S::e2:
    case S::e3:
      break;
    case S::ex:
    case S::ey:
    case S::ez:
      d.q = true;
      break;
    case S::Jxx:
    case S::Jxy:
    case S::Jxz:
    case S::Jyy:
    case S::Jyz:
    case S::Jzz:
      d.J = true;
      break;
  }
  return d;
}

/// A rate brings in the rates of what there is, and for a vector the turning of the axes.
void differentiate(Dependence& d, bool vector) {
  d.ddw = d.ddw || d.dw;
  d.ddv = d.ddv || d.dv;
  d.ddA = d.ddA || d.dA;
  d.dw = d.dw || d.w;
  d.dv = d.dv || d.v;
  d.dA = d.dA || d.A;
  d.dN = d.dN || d.N;
  d.dF = d.dF || d.F;
  d.w = d.w || vector;
}

Dependence dependence_of(const Expression& expression) {
  std::vector<Dependence> all;
  for (const ExpressionNode& node : expression.nodes) {
    Dependence d;
    if (node.operation == Operation::quantity) d = of_quantity(node.quantity);
    if (node.operation == Operation::constant) d.constants = {node.integer};
    if (node.operation == Operation::inertia) d.I = true;
    if (node.operation == Operation::apply || node.operation == Operation::trace) d.J = true;
    if (node.a >= 0) d |= all[static_cast<std::size_t>(node.a)];
    if (node.b >= 0) d |= all[static_cast<std::size_t>(node.b)];
    if (node.operation == Operation::ddt || node.operation == Operation::star)
      differentiate(d, node.type == ExpressionType::vector);
    all.push_back(std::move(d));
  }
  if (expression.constants) all.back().names = *expression.constants;
  return std::move(all.back());
}

/// What is given brings in what it is set to.
void add_given(Dependence& d, const Given& given) {
  for (auto setting = given.settings.rbegin(); setting != given.settings.rend(); ++setting) {
    const Dependence set = of_quantity(setting->quantity);
    const bool sets_rate = (set.N && d.dN) || (set.F && d.dF);
    if (!sets_rate && !(set.I && d.I) && !(set.w && d.w) && !(set.N && d.N) && !(set.F && d.F)) continue;
    Dependence value = dependence_of(setting->value);
    if (sets_rate) differentiate(value, setting->value.type() == ExpressionType::vector);
    d |= value;
  }
}

}  // namespace

Dependence dependence_of(const Equality& equality, LawsAssumed laws, const Given& given) {
  Dependence d = dependence_of(equality.left);
  d |= dependence_of(equality.right);
  if (laws != LawsAssumed::identity) {
    if (d.ddw) d.dw = d.dN = true;
    if (d.ddv) d.dF = d.m = true;
    if (d.dw) d.I = d.w = d.N = true;
    if (d.dv) d.F = d.m = true;
    d.dw = d.ddw = d.dv = d.ddv = false;
    if (laws == LawsAssumed::free) d.no_torque = d.N || d.dN, d.N = d.dN = false;
  }
  for (const Bound& bound : given.bounds) {
    d |= dependence_of(bound.sides.left);
    d |= dependence_of(bound.sides.right);
  }
  add_given(d, given);
  if (given.sets(Quantity::N)) d.dN = false;
  if (given.sets(Quantity::F)) d.dF = false;
  return d;
}

}  // namespace polhode
