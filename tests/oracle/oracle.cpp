// SPDX-License-Identifier: MIT
#include "tests/oracle/oracle.h"

#include <algorithm>
#include <optional>
#include <string>

namespace polhode::oracle {
namespace {

using GiNaC::ex;
using GiNaC::numeric;
using Vector = Oracle::Vector;

ex dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  Vector c;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    c[i] = a[j] * b[k] - b[j] * a[k];
  }
  return c;
}
Vector sum(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vector scaled(const ex& factor, const Vector& a) { return {factor * a[0], factor * a[1], factor * a[2]}; }
Vector scalar(const ex& value) { return {value, 0, 0}; }

/// Bound of the terms that expand() will write.
std::size_t terms_of(const ex& e) {
  constexpr std::size_t kEnough = 100 * Oracle::kLargest;
  std::size_t terms = 1;
  if (GiNaC::is_a<GiNaC::add>(e)) {
    terms = 0;
    for (const ex& operand : e) terms += terms_of(operand);
  } else if (GiNaC::is_a<GiNaC::mul>(e)) {
    for (const ex& operand : e) terms = std::min(kEnough, terms * terms_of(operand));
  } else if (GiNaC::is_a<GiNaC::power>(e) && e.op(1).info(GiNaC::info_flags::integer)) {
    const std::size_t base = terms_of(e.op(0));
    for (int n = std::abs(GiNaC::ex_to<numeric>(e.op(1)).to_int()); n > 0; --n)
      terms = std::min(kEnough, terms * base);
  }
  return std::min(terms, kEnough);
}

/// A number, or a product of powers of symbols: expand() brings its reciprocal to one form.
bool is_monomial(const ex& e) {
  if (GiNaC::is_a<GiNaC::mul>(e)) return std::all_of(e.begin(), e.end(), is_monomial);
  if (GiNaC::is_a<GiNaC::power>(e)) return is_monomial(e.op(0));
  return GiNaC::is_a<numeric>(e) || GiNaC::is_a<GiNaC::symbol>(e);
}

std::size_t nth(Quantity quantity, Quantity first) {
  return static_cast<std::size_t>(static_cast<int>(quantity) - static_cast<int>(first));
}

ex exact(const DecimalNumber& number) {
  return numeric(std::to_string(number.mantissa).c_str()) * GiNaC::pow(ex(10), number.power_of_ten);
}

}  // namespace

Oracle::Oracle(LawsAssumed assumption, const Given& given)
    : t_("t"), small_("epsilon"), order_(given.small.order) {
  const auto name = [this](const std::string& word) { return free_.emplace_back(word); };
  const auto named = [&](const std::string& word) {
    return Vector{name(word + "1"), name(word + "2"), name(word + "3")};
  };
  I_ = named("I");
  w_ = named("w");
  v_ = named("v");
  dv_ = named("dv");
  ddv_ = named("ddv");
  A_ = named("A");
  dA_ = named("dA");
  ddA_ = named("ddA");
  for (ex& component : J_) component = name("J");
  m_ = name("m");
  h_ = name("h");
  k_ = name("k");
  for (ex& constant : constants_) constant = name("c");
  const ex a = name("a"), b = name("b"), c = name("c"), d = name("d");
  length2_ = a * a + b * b + c * c + d * d;
  space_[0] = scaled(1 / length2_, {a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)});
  space_[1] = scaled(1 / length2_, {2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)});
  space_[2] = scaled(1 / length2_, {2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d});
  for (const Quantity quantity : given.small.quantities) {
    if (quantity == Quantity::h) h_ *= small_;
    if (quantity == Quantity::k) k_ *= small_;
    if (nth(quantity, Quantity::w1) < 3) w_[nth(quantity, Quantity::w1)] *= small_;
  }
  if (given.sets_torque()) N_ = named("N");
  if (given.sets(Quantity::F)) F_ = named("F");
  for (const Setting& setting : given.settings) set(setting);
  dN_ = named("dN");  // as far as nothing else is said of them
  dF_ = named("dF");
  ddw_ = named("ddw");
  switch (assumption) {
    case LawsAssumed::identity:
      dw_ = named("dw");
      if (!given.sets_torque()) N_ = named("N");
      if (!given.sets(Quantity::F)) F_ = named("F");
      for (const Setting& setting : given.settings) set_rates(setting);
      break;
    case LawsAssumed::motion:
      if (given.sets_torque()) {
        for (std::size_t i = 0; i < 3; ++i) dw_[i] = (N_[i] - gyroscopic()[i]) / I_[i];
        for (const Setting& setting : given.settings) set_rates(setting);
        for (std::size_t i = 0; i < 3; ++i) ddw_[i] = (dN_[i] - rate_of_gyroscopic()[i]) / I_[i];
      } else {
        dw_ = named("dw");
        N_ = sum({I_[0] * dw_[0], I_[1] * dw_[1], I_[2] * dw_[2]}, gyroscopic());
        dN_ = sum({I_[0] * ddw_[0], I_[1] * ddw_[1], I_[2] * ddw_[2]}, rate_of_gyroscopic());
      }
      if (given.sets(Quantity::F)) {
        dv_ = scaled(1 / m_, F_);
        for (const Setting& setting : given.settings) set_rates(setting);
        ddv_ = scaled(1 / m_, dF_);
      } else {
        F_ = scaled(m_, dv_);
        dF_ = scaled(m_, ddv_);
      }
      break;
    case LawsAssumed::free:
      for (std::size_t i = 0; i < 3; ++i) dw_[i] = -gyroscopic()[i] / I_[i];
      for (std::size_t i = 0; i < 3; ++i) ddw_[i] = -rate_of_gyroscopic()[i] / I_[i];
      N_ = dN_ = {0, 0, 0};
      F_ = scaled(m_, dv_);
      dF_ = scaled(m_, ddv_);
      break;
  }
}

/// ω×Iω on the principal axes.
Vector Oracle::gyroscopic() const { return cross(w_, {I_[0] * w_[0], I_[1] * w_[1], I_[2] * w_[2]}); }

Vector Oracle::rate_of_gyroscopic() const {
  return sum(cross(dw_, {I_[0] * w_[0], I_[1] * w_[1], I_[2] * w_[2]}),
             cross(w_, {I_[0] * dw_[0], I_[1] * dw_[1], I_[2] * dw_[2]}));
}

/// N and F change as what they are set to.
void Oracle::set_rates(const Setting& setting) {
  using S = Quantity;
  Side side;
  const auto moved = [&] {
    return value(setting.value, static_cast<int>(setting.value.nodes.size()) - 1, true, side);
  };
  if (setting.quantity == S::F) {
    dF_ = rate(moved(), false);
  } else if (setting.quantity == S::N) {  // its components on axes that turn
    const Vector N = moved();
    dN_ = rate({dot(axis(0, true), N), dot(axis(1, true), N), dot(axis(2, true), N)}, false);
  } else if (setting.quantity == S::N1 || setting.quantity == S::N2 || setting.quantity == S::N3) {
    dN_[nth(setting.quantity, S::N1)] = rate(moved(), false)[0];
  }
}

void Oracle::set(const Setting& setting) {
  using S = Quantity;
  const Vector value = side(setting.value).value;
  switch (setting.quantity) {
    case S::I1:
    case S::I2:
    case S::I3:
      I_[nth(setting.quantity, S::I1)] = value[0];
      break;
    case S::w1:
    case S::w2:
    case S::w3:
      w_[nth(setting.quantity, S::w1)] = value[0];
      break;
    case S::N1:
    case S::N2:
    case S::N3:
      N_[nth(setting.quantity, S::N1)] = value[0];
      break;
    case S::N:
      N_ = value;  // the axes of body and space coincide
      break;
    default:
      F_ = value;
      break;
  }
}

/// At t = 0, or near it if it goes on.
Vector Oracle::rate(const Vector& moving, bool goes_on) const {
  Vector rates;
  for (std::size_t i = 0; i < 3; ++i)
    rates[i] = goes_on ? moving[i].diff(t_) : moving[i].diff(t_).subs(t_ == 0);
  return rates;
}

Vector Oracle::axis(std::size_t i, bool moving) const {
  Vector axis{0, 0, 0};
  axis[i] = 1;
  if (!moving) return axis;
  if (!twice_) return sum(axis, scaled(t_, cross(w_, axis)));
  const Vector second = sum(cross(dw_, axis), cross(w_, cross(w_, axis)));
  return sum(axis, sum(scaled(t_, cross(w_, axis)), scaled(t_ * t_ / 2, second)));
}

Vector Oracle::in_space(const Vector& on_body_axes, bool moving) const {
  Vector space{0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) space = sum(space, scaled(on_body_axes[i], axis(i, moving)));
  return space;
}

Vector Oracle::quantity(Quantity q, bool moving) const {
  using S = Quantity;
  const auto at = [&](const Vector& value, const Vector& its_rate, const Vector& its_second = {0, 0, 0}) {
    if (!moving) return value;
    const Vector first = sum(value, scaled(t_, its_rate));
    return twice_ ? sum(first, scaled(t_ * t_ / 2, its_second)) : first;
  };
  const Vector w = at(w_, dw_, ddw_);
  const Vector L{I_[0] * w[0], I_[1] * w[1], I_[2] * w[2]};
  switch (q) {
    case S::T:
      return scalar((I_[0] * w[0] * w[0] + I_[1] * w[1] * w[1] + I_[2] * w[2] * w[2]) / 2);
    case S::I1:
    case S::I2:
    case S::I3:
      return scalar(I_[nth(q, S::I1)]);
    case S::w1:
    case S::w2:
    case S::w3:
      return scalar(w[nth(q, S::w1)]);
    case S::dw1:
    case S::dw2:
    case S::dw3:
      return scalar(at(dw_, ddw_)[nth(q, S::dw1)]);
    case S::N1:
    case S::N2:
    case S::N3:
      return scalar(at(N_, dN_)[nth(q, S::N1)]);
    case S::m:
      return scalar(m_);
    case S::h:
      return scalar(h_);
    case S::k:
      return scalar(k_);
    case S::omega:
      return in_space(w, moving);
    case S::L:
      return in_space(L, moving);
    case S::N:
      return in_space(at(N_, dN_), moving);
    case S::p:
      return scaled(m_, at(v_, dv_, ddv_));
    case S::v:
      return at(v_, dv_, ddv_);
    case S::F:
      return at(F_, dF_);
    case S::A:
      return at(A_, dA_, ddA_);
    case S::e1:
    case S::e2:
    case S::e3:
      return axis(nth(q, S::e1), moving);
    case S::ex:
    case S::ey:
    case S::ez:
      return space_[nth(q, S::ex)];
    default:
      return scalar(J_[nth(q, S::Jxx)]);
  }
}

Vector Oracle::value(const Expression& expression, int index, bool moving, Side& side) const {
  using O = Operation;
  const ExpressionNode& node = expression.nodes[static_cast<std::size_t>(index)];
  const auto a = [&] { return value(expression, node.a, moving, side); };
  const auto b = [&] { return value(expression, node.b, moving, side); };
  const auto divisor = [&](const ex& by) {
    // What is zero once written out is found by the points; what is zero at once cannot be written at all.
    side.divisors.push_back(by.subs(t_ == 0));
    side.defined = side.defined && !side.divisors.back().is_zero();
    return side.defined ? by : ex(1);
  };
  switch (node.operation) {
    case O::number:
      return scalar(exact(node.number));
    case O::quantity:
      if (node.quantity == Quantity::ex || node.quantity == Quantity::ey || node.quantity == Quantity::ez)
        side.divisors.push_back(length2_);
      return quantity(node.quantity, moving);
    case O::negate:
      return scaled(-1, a());
    case O::add:
      return sum(a(), b());
    case O::subtract:
      return sum(a(), scaled(-1, b()));
    case O::multiply: {
      const Vector left = a(), right = b();
      const ExpressionNode& first = expression.nodes[static_cast<std::size_t>(node.a)];
      return first.type == ExpressionType::vector ? scaled(right[0], left) : scaled(left[0], right);
    }
    case O::divide: {
      const Vector dividend = a();
      return scaled(1 / divisor(b()[0]), dividend);
    }
    case O::power: {
      const ex base = a()[0];
      if (node.integer == 0) return scalar(1);
      return scalar(GiNaC::pow(node.integer < 0 ? divisor(base) : base, node.integer));
    }
    case O::dot:
      return scalar(dot(a(), b()));
    case O::cross:
      return cross(a(), b());
    case O::norm2: {
      const Vector v = a();
      return scalar(dot(v, v));
    }
    case O::norm: {
      const Vector v = a();
      return scalar(GiNaC::sqrt(dot(v, v)));
    }
    case O::inertia: {  // Σ I_i e_i (e_i·a)
      const Vector v = a();
      Vector result{0, 0, 0};
      for (std::size_t i = 0; i < 3; ++i)
        result = sum(result, scaled(I_[i] * dot(axis(i, moving), v), axis(i, moving)));
      return result;
    }
    case O::apply: {  // Σ J_ik e_i (e_k·a)
      constexpr std::size_t kPlace[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
      const Vector v = a();
      Vector result{0, 0, 0};
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k)
          result = sum(result, scaled(J_[kPlace[i][k]] * dot(axis(k, moving), v), axis(i, moving)));
      return result;
    }
    case O::comp:
      return scalar(dot(axis(static_cast<std::size_t>(node.integer), moving), a()));
    case O::trace:
      return scalar(J_[0] + J_[3] + J_[5]);
    case O::ddt:
      return rate(value(expression, node.a, true, side), moving);
    case O::star: {  // Σ e_i d(e_i·a)/dt
      const Vector moved = value(expression, node.a, true, side);
      return in_space(
          rate({dot(axis(0, true), moved), dot(axis(1, true), moved), dot(axis(2, true), moved)}, moving),
          moving);
    }
    case O::constant:
      return scalar(constants_[static_cast<std::size_t>(node.integer)]);
    case O::cos:  // of acos
      return value(expression, expression.nodes[static_cast<std::size_t>(node.a)].a, moving, side);
    case O::pi:
    case O::sqrt:
    case O::sin:
    case O::acos:
    case O::atan2:
    case O::exp:
    case O::log:
      break;  // nothing here has any
  }
  return {};
}

Oracle::Side Oracle::side(const Expression& expression) const {
  Side side;
  twice_ = expression.order() > 1;
  side.value = value(expression, static_cast<int>(expression.nodes.size()) - 1, false, side);
  return side;
}

GiNaC::exmap Oracle::random_point() const {
  GiNaC::exmap point;
  for (const GiNaC::symbol& symbol : free_)
    point[symbol] = numeric(std::to_string(1 + (random_() >> 24)).c_str());
  return point;
}

bool Oracle::is_zero(const ex& difference, bool has_divisors) const {
  if (difference.is_zero()) return true;
  if (terms_of(difference) > kLargest) {
    ++by_points_;
    return true;
  }
  return has_divisors ? difference.normal().is_zero() : difference.expand().is_zero();
}

Decision Oracle::compare(const Side& left, const Side& right) const {
  if (!left.defined || !right.defined) return Decision::undefined;
  const Vector difference = sum(left.value, scaled(-1, right.value));
  std::vector<ex> divisors = left.divisors;
  divisors.insert(divisors.end(), right.divisors.begin(), right.divisors.end());
  int defined = 0;
  for (int n = 0; n < kPoints; ++n) {
    const GiNaC::exmap point = random_point();
    const auto is_zero_there = [&](const ex& e) {
      return e.subs(point, GiNaC::subs_options::no_pattern).is_zero();
    };
    if (std::any_of(divisors.begin(), divisors.end(), is_zero_there)) continue;
    ++defined;
    if (!std::all_of(difference.begin(), difference.end(), is_zero_there)) return Decision::different;
  }
  if (defined == 0) return Decision::undefined;
  const bool has_divisors = !std::all_of(divisors.begin(), divisors.end(), is_monomial);
  ++proofs_;
  const bool zero = std::all_of(difference.begin(), difference.end(),
                                [&](const ex& e) { return is_zero(e, has_divisors); });
  return zero ? Decision::same : Decision::different;
}

namespace {

/// The least power of ε in a rational function of it; nothing of 0.
std::optional<int> least_power(const ex& function, const GiNaC::symbol& epsilon) {
  const ex fraction = function.numer_denom();
  const ex above = fraction.op(0).expand(), below = fraction.op(1).expand();
  if (above.is_zero()) return std::nullopt;
  return above.ldegree(epsilon) - below.ldegree(epsilon);
}

}  // namespace

Decision Oracle::compare_to_order(const Equality& equality, bool& are_zero) const {
  const Side left = side(equality.left), right = side(equality.right);
  if (!left.defined || !right.defined) return Decision::undefined;
  std::vector<ex> divisors = left.divisors;
  divisors.insert(divisors.end(), right.divisors.begin(), right.divisors.end());
  are_zero = true;
  int defined = 0;
  for (int n = 0; n < kPoints; ++n) {
    const GiNaC::exmap point = random_point();
    const auto there = [&](const ex& e) { return e.subs(point, GiNaC::subs_options::no_pattern); };
    if (std::any_of(divisors.begin(), divisors.end(),
                    [&](const ex& e) { return !least_power(there(e), small_); }))
      continue;
    ++defined;
    const auto has_terms = [&](const ex& e) {
      const auto power = least_power(e, small_);
      return power && *power <= order_;
    };
    for (std::size_t i = 0; i < 3; ++i) {
      const ex l = there(left.value[i]), r = there(right.value[i]);
      if (has_terms(l - r)) return Decision::different;
      are_zero = are_zero && !has_terms(l) && !has_terms(r);
    }
  }
  return defined == 0 ? Decision::undefined : Decision::same;
}

}  // namespace polhode::oracle
