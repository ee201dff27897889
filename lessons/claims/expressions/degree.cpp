// SPDX-License-Identifier: MIT
#include "lessons/claims/expressions/degree.h"

#include "lessons/claims/expressions/expression_names.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace polhode {
namespace {

constexpr Degree kRotation{2, 2};  ///< of R(q); with the axes of body and space the same it is 1

double log2_of_sum(double a_bits, double b_bits) {
  return std::max(a_bits, b_bits) + std::log2(1 + std::exp2(-std::abs(a_bits - b_bits)));
}

int at_most_enough(std::int64_t degree) {
  return static_cast<int>(std::min<std::int64_t>(degree, kMostProvableDegree));
}
int sum_of(int a, int b) { return at_most_enough(std::int64_t{a} + b); }

Degree sum(const Degree& a, const Degree& b) {
  return {std::max(sum_of(a.numerator, b.denominator), sum_of(b.numerator, a.denominator)),
          sum_of(a.denominator, b.denominator),
          log2_of_sum(a.numerator_bits + b.denominator_bits, b.numerator_bits + a.denominator_bits),
          a.denominator_bits + b.denominator_bits};
}
Degree product(const Degree& a, const Degree& b) {
  return {sum_of(a.numerator, b.numerator), sum_of(a.denominator, b.denominator),
          a.numerator_bits + b.numerator_bits, a.denominator_bits + b.denominator_bits};
}
Degree power_of(const Degree& a, int exponent) {
  const int n = std::abs(exponent);
  const Degree up{at_most_enough(std::int64_t{a.numerator} * n),
                  at_most_enough(std::int64_t{a.denominator} * n), a.numerator_bits * n,
                  a.denominator_bits * n};
  return exponent < 0 ? Degree{up.denominator, up.numerator, up.denominator_bits, up.numerator_bits} : up;
}
Degree quotient(const Degree& a, const Degree& b) { return product(a, power_of(b, -1)); }
/// The sum of so many that have the degree.
Degree times(double count, Degree a) {
  a.numerator_bits += std::log2(count);
  return a;
}
/// Of each of two, over one divisor.
Degree common(const Degree& a, const Degree& b) {
  Degree both = sum(a, b);
  both.numerator_bits =
      std::max(a.numerator_bits + b.denominator_bits, b.numerator_bits + a.denominator_bits);
  return both;
}
Degree common(const std::array<Degree, 3>& three) { return common(common(three[0], three[1]), three[2]); }

Degree degree_of(const DecimalNumber& number) {
  constexpr double kLog10 = 3.322;  // log2 10, rounded up
  const double bits = number.mantissa == 0 ? 0 : std::log2(static_cast<double>(number.mantissa));
  const double power = kLog10 * number.power_of_ten;
  return {0, 0, bits + std::max(power, 0.0), std::max(-power, 0.0)};
}

std::size_t place(Quantity quantity, Quantity first) {
  return static_cast<std::size_t>(static_cast<int>(quantity) - static_cast<int>(first));
}

}  // namespace

DegreeTable::DegreeTable() {
  constexpr Degree kFree{1, 0};
  I_.fill(kFree), w_.fill(kFree), N_.fill(kFree);
  torque_ = product(kRotation, kFree);
  force_ = kFree;
  add_up();
}

DegreeTable::DegreeTable(const Given& given) : DegreeTable() {
  for (const Setting& setting : given.settings) set(setting.quantity, of(setting.value));
}

void DegreeTable::set(Quantity quantity, const Degree& value) {
  using Q = Quantity;
  if (quantity == Q::N) {
    torque_ = value;
    N_.fill(product(value, kRotation));
  } else if (quantity == Q::F) {
    force_ = value;
  } else if (place(quantity, Q::I1) < 3) {
    I_[place(quantity, Q::I1)] = value;
  } else if (place(quantity, Q::w1) < 3) {
    w_[place(quantity, Q::w1)] = value;
  } else {
    N_[place(quantity, Q::N1)] = value;
    torque_ = product(kRotation, common(N_));
  }
  add_up();
}

/// What follows from moments, ω, N and F.
void DegreeTable::add_up() {
  Three L, twice_T;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    L[i] = product(I_[i], w_[i]);
    twice_T[i] = product(L[i], w_[i]);
    dw_[i] = quotient(sum(N_[i], product(product(w_[j], w_[k]), sum(I_[j], I_[k]))), I_[i]);
  }
  energy_ = sum(sum(twice_T[0], twice_T[1]), twice_T[2]);
  energy_.denominator_bits += 1;
  omega_ = product(kRotation, common(w_));
  L_ = product(kRotation, common(L));
  tensor_ = times(3, product(power_of(kRotation, 2), common(I_)));
  // Twice q̇ is q ω, a sum of three; v̇ = F/m; ω̇ or N, and their rates, may be free.
  constexpr Degree kMass{1, 0};
  const Degree turning = times(3, product({1, 0}, common(w_)));
  rates_ = common(common(common(dw_), quotient(force_, kMass)), turning);
  rates_.numerator_bits += 1;
  rates_.denominator_bits += 1;
}

/// (n/d)˙ = (ṅ d − n ḋ)/d², where the rate of every number that n and d are made of is f/g, with one g. The
/// turning of a vector's axes adds ω×(n/d).
Degree DegreeTable::rate_of(const Degree& a) const {
  const int n = a.numerator, d = a.denominator, f = rates_.numerator, g = rates_.denominator;
  const int both = sum_of(n, d);
  const Degree w = common(w_);
  const double terms = std::log2(static_cast<double>(std::max(both, 1))) + rates_.numerator_bits;
  return {std::max(sum_of(both, f - 1), sum_of(both, sum_of(w.numerator, g))),
          at_most_enough(2 * std::int64_t{d} + g + w.denominator),
          a.numerator_bits + a.denominator_bits +
              log2_of_sum(terms + w.denominator_bits, 1 + w.numerator_bits + rates_.denominator_bits),
          2 * a.denominator_bits + rates_.denominator_bits + w.denominator_bits};
}

Degree DegreeTable::of(Quantity quantity) const {
  using Q = Quantity;
  switch (quantity) {
    case Q::T:
      return energy_;
    case Q::I1:
    case Q::I2:
    case Q::I3:
      return I_[place(quantity, Q::I1)];
    case Q::w1:
    case Q::w2:
    case Q::w3:
      return w_[place(quantity, Q::w1)];
    case Q::dw1:
    case Q::dw2:
    case Q::dw3:
      return dw_[place(quantity, Q::dw1)];
    case Q::N1:
    case Q::N2:
    case Q::N3:
      return N_[place(quantity, Q::N1)];
    case Q::omega:
      return omega_;
    case Q::L:
      return L_;
    case Q::N:
      return torque_;
    case Q::p:
      return {2, 0};
    case Q::F:
      return force_;
    case Q::e1:
    case Q::e2:
    case Q::e3:
      return kRotation;
    case Q::ex:
    case Q::ey:
    case Q::ez:
      return {2, 2, 2, 2};  // on the body axes, where coefficients are bounded, these are rows of R(q)
    case Q::m:
    case Q::h:
    case Q::k:
    case Q::v:
    case Q::A:
    case Q::Jxx:
    case Q::Jxy:
    case Q::Jxz:
    case Q::Jyy:
    case Q::Jyz:
    case Q::Jzz:
      return {1, 0};
  }
  return {};
}

Degree DegreeTable::of(const ExpressionNode& node, const Degree& a, const Degree& b) const {
  using O = Operation;
  switch (node.operation) {
    case O::number:
      return degree_of(node.number);
    case O::constant:
      return {1, 0};
    case O::pi:
      return {};
    case O::quantity:
      return of(node.quantity);
    case O::negate:
      return a;
    case O::add:
    case O::subtract:
      return sum(a, b);
    case O::multiply:
      return product(a, b);
    case O::divide:
      return quotient(a, b);
    case O::power:
      return power_of(a, node.integer);
    case O::dot:
      return times(3, product(a, b));
    case O::cross:
      return times(2, product(a, b));
    case O::norm2:
    case O::norm:  // a length is proved by its square
      return times(3, power_of(a, 2));
    case O::inertia:
      return product(a, tensor_);
    case O::apply:
      return product(a, {5, 4, kLog3, 0});
    case O::trace:
      return {5, 4, kLog3, 0};
    case O::comp:
      return product(a, kRotation);
    case O::ddt:
      return rate_of(a);
    case O::star:
      return product(rate_of(product(a, kRotation)), kRotation);
    case O::sqrt:
    case O::sin:
    case O::cos:
    case O::acos:
    case O::exp:
    case O::log:
      return a;
    case O::atan2:
      return sum(a, b);
  }
  return {};
}

Degree DegreeTable::of(const Expression& expression) const {
  std::vector<Degree> degrees;
  degrees.reserve(expression.nodes.size());
  const auto at = [&](int index) { return index < 0 ? Degree() : degrees[static_cast<std::size_t>(index)]; };
  for (const ExpressionNode& node : expression.nodes) degrees.push_back(of(node, at(node.a), at(node.b)));
  return degrees.back();
}

Degree degree_of_difference(const Degree& left, const Degree& right) { return sum(left, right); }

}  // namespace polhode
