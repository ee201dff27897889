// SPDX-License-Identifier: MIT
// The value of an expression in one state of a body, over numbers N: residues modulo a prime (FieldElement),
// where equality is proof, or doubles (SizedNumber), where it is measured. One code for both.
//
// Every vector is evaluated by its components in space with their rates (jets), so that d/dt is the rate of
// those components, d*/dt that of the components on the body axes Rᵀv, and the transport theorem is tested,
// not assumed. Rates are carried along as far as the expression's order needs them.
#pragma once

#include "lessons/claims/expressions/expression.h"
#include "lessons/claims/expressions/sized_number.h"
#include "lessons/claims/expressions/vocabulary.h"
#include "lessons/claims/proof/prime_field.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <type_traits>
#include <vector>

namespace polhode {

/// A value and its rates of change, as far as Order: x + ẋt + ẍt²/2. Those beyond are not computed.
template <class N, int Order = kMaxOrder>
struct Jet {
  N value{}, rate{}, second{};

  Jet() = default;
  Jet(N its_value, N its_rate, N its_second = N(0))
      : value(std::move(its_value)), rate(std::move(its_rate)), second(std::move(its_second)) {}
  template <int Other>
  explicit Jet(const Jet<N, Other>& other) : Jet(other.value, other.rate, other.second) {}

  friend Jet operator+(const Jet& a, const Jet& b) {
    Jet sum;
    sum.value = a.value + b.value;
    if constexpr (Order >= 1) sum.rate = a.rate + b.rate;
    if constexpr (Order >= 2) sum.second = a.second + b.second;
    return sum;
  }
  friend Jet operator-(const Jet& a, const Jet& b) {
    Jet difference;
    difference.value = a.value - b.value;
    if constexpr (Order >= 1) difference.rate = a.rate - b.rate;
    if constexpr (Order >= 2) difference.second = a.second - b.second;
    return difference;
  }
  friend Jet operator-(const Jet& a) { return Jet() - a; }
  friend Jet operator*(const Jet& a, const Jet& b) {
    Jet product;
    product.value = a.value * b.value;
    if constexpr (Order >= 1) product.rate = a.value * b.rate + a.rate * b.value;
    if constexpr (Order >= 2) {
      const N both = a.rate * b.rate;
      product.second = a.value * b.second + (both + both) + a.second * b.value;
    }
    return product;
  }
};

/// 1/a: a b = 1 has no rates.
template <class N, int Order>
Jet<N, Order> inverse(const Jet<N, Order>& a) {
  Jet<N, Order> b;
  b.value = inverse(a.value);
  if constexpr (Order >= 1) b.rate = -(a.rate * b.value * b.value);
  if constexpr (Order >= 2) {
    const N both = a.rate * b.rate;
    b.second = -((both + both + a.second * b.value) * b.value);
  }
  return b;
}

/// The components of a vector, each with its rates; a scalar is the first.
template <class N, int Order = kMaxOrder>
using ComponentJets = std::array<Jet<N, Order>, 3>;

/// All that can vary. R takes body components to space components; columns are the body axes.
template <class N>
struct ClaimState {
  std::array<ComponentJets<N>, 3> R;  ///< R[row][column]
  std::array<N, 3> I;                 ///< principal moments
  std::array<N, 6> J;                 ///< Jxx Jxy Jxz Jyy Jyz Jzz on the body axes
  ComponentJets<N> w_B, v_S, A_S;     ///< with their rates
  ComponentJets<N> N_B, F_S;          ///< with their first rates
  N m;
  N h, k;  ///< any numbers
  /// The lesson's constants; nothing: each is what the lesson says.
  std::optional<std::array<N, kMaxConstants>> constants;
};

/// mantissa · 10^power, exactly; of doubles correctly rounded.
template <class N>
N decimal(const DecimalNumber& number) {
  N value(number.mantissa);
  const N ten = number.power_of_ten < 0 ? inverse(N(10)) : N(10);
  for (int n = std::abs(number.power_of_ten); n > 0; --n) value = value * ten;
  return value;
}
template <>
inline SizedNumber decimal<SizedNumber>(const DecimalNumber& number) {
  return number.value;
}

/// The size of a vector's component is that of the whole vector (sized_number.h): turning does not change it.
/// Of other numbers there is nothing to say.
template <class N, int Order>
struct VectorSizes {
  using Vector = ComponentJets<N, Order>;
  static void turned(Vector&, const Vector&, const std::array<Vector, 3>&) {}
  static void mapped(Vector&, const Vector&) {}
  static void multiplied(Jet<N, Order>&, const Vector&, const Vector&) {}
};

template <int Order>
struct VectorSizes<SizedNumber, Order> {
  using Vector = ComponentJets<SizedNumber, Order>;

  /// y = R x, or Rᵀx.
  static void turned(Vector& y, const Vector& x, const std::array<Vector, 3>& R) {
    Sizes turning{1, 0, 0};
    for (const Vector& row : R) {
      turning.rate = std::fmax(turning.rate, sizes(row).rate);
      turning.second = std::fmax(turning.second, sizes(row).second);
    }
    const Sizes shared = product(turning, sizes(x));
    for (Jet<SizedNumber, Order>& component : y) set(component, shared);
  }
  /// y is a tensor that is applied to x.
  static void mapped(Vector& y, const Vector& x) {
    const double length = std::hypot(x[0].value.value, x[1].value.value, x[2].value.value);
    const double mapped = std::hypot(y[0].value.value, y[1].value.value, y[2].value.value);
    Sizes shared = sizes(y);
    if (length > 0) shared.value = sizes(x).value * mapped / length;
    for (Jet<SizedNumber, Order>& component : y) set(component, shared);
  }
  /// Of a product of two vectors, or a component of one.
  static void multiplied(Jet<SizedNumber, Order>& result, const Vector& a, const Vector& b) {
    set(result, product(sizes(a), sizes(b)));
  }

 private:
  struct Sizes {
    double value = 0, rate = 0, second = 0;
  };
  static Sizes sizes(const Vector& x) {
    Sizes largest;
    for (const Jet<SizedNumber, Order>& component : x) {
      largest.value = std::fmax(largest.value, component.value.size);
      largest.rate = std::fmax(largest.rate, component.rate.size);
      largest.second = std::fmax(largest.second, component.second.size);
    }
    return largest;
  }
  static Sizes product(const Sizes& a, const Sizes& b) {
    return {a.value * b.value, a.value * b.rate + a.rate * b.value,
            a.value * b.second + 2 * a.rate * b.rate + a.second * b.value};
  }
  static void set(Jet<SizedNumber, Order>& x, const Sizes& its) {
    x.value.size = its.value, x.rate.size = its.rate, x.second.size = its.second;
  }
};

/// sqrt, sin, cos, acos, exp, log of x, or the angle whose tangent is x/y; with its rates. The size grows
/// with the relative error that the operands may have. Not finite where it is not defined.
template <int Order>
Jet<SizedNumber, Order> function_of(Operation operation, const Jet<SizedNumber, Order>& x,
                                    const Jet<SizedNumber, Order>& y) {
  const double a = x.value.value, b = y.value.value;
  double value = 0, by_a = 0, by_b = 0, by_aa = 0, by_ab = 0, by_bb = 0;  // and its derivatives
  switch (operation) {
    case Operation::sqrt:
      value = std::sqrt(a), by_a = 0.5 / value, by_aa = -0.5 * by_a / a;
      break;
    case Operation::sin:
      value = std::sin(a), by_a = std::cos(a), by_aa = -value;
      break;
    case Operation::cos:
      value = std::cos(a), by_a = -std::sin(a), by_aa = -value;
      break;
    case Operation::acos:
      value = std::acos(a), by_a = -1 / std::sqrt((1 - a) * (1 + a)), by_aa = a * by_a / ((1 - a) * (1 + a));
      break;
    case Operation::exp:
      value = std::exp(a), by_a = value, by_aa = value;
      break;
    case Operation::log:
      value = std::log(a), by_a = 1 / a, by_aa = -by_a * by_a;
      break;
    default: {
      const double square = a * a + b * b;
      value = std::atan2(a, b), by_a = b / square, by_b = -a / square;
      by_aa = 2 * by_a * by_b, by_bb = -by_aa, by_ab = (a * a - b * b) / (square * square);
      break;
    }
  }
  // Where a derivative is infinite the value is known all the same: sqrt(0), acos(1).
  const auto error = [](double slope, double size) { return size == 0 ? 0.0 : std::abs(slope) * size; };
  const double size = std::abs(value) + error(by_a, x.value.size) + error(by_b, y.value.size);
  Jet<SizedNumber, Order> result;
  result.value = {value, std::isfinite(size) ? size : std::abs(value) + std::sqrt(x.value.size)};
  const SizedNumber da = x.rate, db = y.rate;
  if constexpr (Order >= 1)
    result.rate = {by_a * da.value + by_b * db.value, error(by_a, da.size) + error(by_b, db.size)};
  if constexpr (Order >= 2)
    result.second = {by_a * x.second.value + by_b * y.second.value + by_aa * da.value * da.value +
                         2 * by_ab * da.value * db.value + by_bb * db.value * db.value,
                     error(by_a, x.second.size) + error(by_b, y.second.size) +
                         error(by_aa, da.size * da.size) + error(2 * by_ab, da.size * db.size) +
                         error(by_bb, db.size * db.size)};
  return result;
}

/// Evaluates what is of at most this order in one state; the state must live as long.
template <class N, int Order = kMaxOrder>
class Evaluation {
  using Number = Jet<N, Order>;

 public:
  using Vector = ComponentJets<N, Order>;

  explicit Evaluation(const ClaimState<N>& state)
      : s_(state), R_{cut(s_.R[0]), cut(s_.R[1]), cut(s_.R[2])}, w_B_(cut(s_.w_B)), N_B_(cut(s_.N_B)) {
    const Vector L_B = I_times(w_B_);
    omega_ = to_space(w_B_);
    L_ = to_space(L_B);
    N_ = to_space(N_B_);
    T_ = constant(inverse(N(2))) * dot(w_B_, L_B);
  }

  /// False if it is not defined there: something was divided by zero.
  bool operator()(const Expression& expression, Vector& value) {
    values_.resize(expression.nodes.size());
    for (std::size_t i = 0; i < values_.size(); ++i)
      if (!evaluate(expression.nodes, i, values_[i])) return false;
    value = values_.back();
    return true;
  }

  /// Components on the body axes.
  Vector to_body(const Vector& x_S) const {
    Vector x_B;
    for (std::size_t i = 0; i < 3; ++i) x_B[i] = R_[0][i] * x_S[0] + R_[1][i] * x_S[1] + R_[2][i] * x_S[2];
    VectorSizes<N, Order>::turned(x_B, x_S, R_);
    return x_B;
  }

 private:
  static Number constant(const N& value) { return {value, N(0)}; }
  /// Without what is not needed of the state's rates.
  static Vector cut(const ComponentJets<N>& x) { return {Number(x[0]), Number(x[1]), Number(x[2])}; }
  static Vector scalar(const Number& value) { return {value, Number(), Number()}; }

  Vector to_space(const Vector& x_B) const {
    Vector x_S;
    for (std::size_t i = 0; i < 3; ++i) x_S[i] = R_[i][0] * x_B[0] + R_[i][1] * x_B[1] + R_[i][2] * x_B[2];
    VectorSizes<N, Order>::turned(x_S, x_B, R_);
    return x_S;
  }

  static Number dot(const Vector& a, const Vector& b) {
    Number product = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    VectorSizes<N, Order>::multiplied(product, a, b);
    return product;
  }
  static Vector cross(const Vector& a, const Vector& b) {
    Vector product{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    for (Number& component : product) VectorSizes<N, Order>::multiplied(component, a, b);
    return product;
  }

  /// |x|, where N has roots; its rate x·ẋ/|x| is nothing that can be used where x = 0.
  static bool length([[maybe_unused]] const Vector& x, [[maybe_unused]] Vector& value) {
    if constexpr (std::is_same_v<N, SizedNumber>) {
      const Number square = dot(x, x);
      value = scalar(function_of(Operation::sqrt, square, {}));
      value[0].value.size = std::sqrt(square.value.size);
      return true;
    }
    return false;
  }

  Number J_at(std::size_t row, std::size_t column) const {
    constexpr std::size_t kPlace[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
    return constant(s_.J[kPlace[row][column]]);
  }
  Vector J_times(const Vector& x_B) const {
    Vector y_B;
    for (std::size_t i = 0; i < 3; ++i)
      y_B[i] = J_at(i, 0) * x_B[0] + J_at(i, 1) * x_B[1] + J_at(i, 2) * x_B[2];
    VectorSizes<N, Order>::mapped(y_B, x_B);
    return y_B;
  }
  Vector I_times(const Vector& x_B) const {
    Vector y_B{constant(s_.I[0]) * x_B[0], constant(s_.I[1]) * x_B[1], constant(s_.I[2]) * x_B[2]};
    VectorSizes<N, Order>::mapped(y_B, x_B);
    return y_B;
  }
  /// tr(R J Rᵀ): of the components in space.
  Number trace_J() const {
    Number sum;
    for (const Vector& row : R_) sum = sum + dot(row, J_times(row));
    return sum;
  }
  Vector axis(std::size_t i) const { return {R_[0][i], R_[1][i], R_[2][i]}; }

  static Vector rate_of(const Vector& x) {
    return {Number(x[0].rate, x[0].second), Number(x[1].rate, x[1].second), Number(x[2].rate, x[2].second)};
  }

  Vector value_of(Quantity quantity) const {
    using S = Quantity;
    const auto nth = [quantity](S first) {
      return static_cast<std::size_t>(static_cast<int>(quantity) - static_cast<int>(first));
    };
    switch (quantity) {
      case S::T:
        return scalar(T_);
      case S::I1:
      case S::I2:
      case S::I3:
        return scalar(constant(s_.I[nth(S::I1)]));
      case S::w1:
      case S::w2:
      case S::w3:
        return scalar(w_B_[nth(S::w1)]);
      case S::dw1:
      case S::dw2:
      case S::dw3:
        return scalar(rate_of(w_B_)[nth(S::dw1)]);
      case S::N1:
      case S::N2:
      case S::N3:
        return scalar(N_B_[nth(S::N1)]);
      case S::m:
        return scalar(constant(s_.m));
      case S::h:
        return scalar(constant(s_.h));
      case S::k:
        return scalar(constant(s_.k));
      case S::omega:
        return omega_;
      case S::L:
        return L_;
      case S::N:
        return N_;
      case S::p:
        return scaled(constant(s_.m), cut(s_.v_S));
      case S::v:
        return cut(s_.v_S);
      case S::F:
        return cut(s_.F_S);
      case S::A:
        return cut(s_.A_S);
      case S::e1:
      case S::e2:
      case S::e3:
        return axis(nth(S::e1));
      case S::ex:
      case S::ey:
      case S::ez: {
        Vector e_S;
        e_S[nth(S::ex)] = constant(N(1));
        return e_S;
      }
      default:
        return scalar(constant(s_.J[nth(S::Jxx)]));
    }
  }

  static N pi() {
    if constexpr (std::is_same_v<N, SizedNumber>) return std::numbers::pi;
    return N(0);
  }

  static Vector scaled(const Number& factor, const Vector& x) {
    return {factor * x[0], factor * x[1], factor * x[2]};
  }

  static Number number(const DecimalNumber& number) { return constant(decimal<N>(number)); }

  static bool power(const Number& base, int exponent, Number& result) {
    if (exponent < 0 && base.value.is_zero()) return false;
    const Number factor = exponent < 0 ? inverse(base) : base;
    result = constant(N(1));
    for (int n = std::abs(exponent); n > 0; --n) result = result * factor;
    return true;
  }

  /// A function that has values where N has roots and angles.
  static bool function([[maybe_unused]] Operation operation, [[maybe_unused]] const Number& x,
                       [[maybe_unused]] const Number& y, [[maybe_unused]] Vector& value) {
    if constexpr (std::is_same_v<N, SizedNumber>) {
      value = scalar(function_of(operation, x, y));
      return std::isfinite(value[0].value.value);
    }
    return false;
  }

  /// Whether an angle has it, but for rounding; of residues that is not asked.
  static bool is_cosine([[maybe_unused]] const Number& x) {
    constexpr double kRounding = 1e-12;
    if constexpr (std::is_same_v<N, SizedNumber>) return std::abs(x.value.value) <= 1 + kRounding;
    return true;
  }

  N constant_of(const ExpressionNode& node) const {
    if (s_.constants) return (*s_.constants)[static_cast<std::size_t>(node.integer)];
    if constexpr (std::is_same_v<N, SizedNumber>) return node.number.value;
    return N(0);  // states of exact numbers have their constants
  }

  bool evaluate(const std::vector<ExpressionNode>& nodes, std::size_t index, Vector& value) const {
    using O = Operation;
    const ExpressionNode& node = nodes[index];
    const auto operand = [this](int which) -> const Vector& {
      return values_[static_cast<std::size_t>(which)];
    };
    switch (node.operation) {
      case O::number:
        value = scalar(number(node.number));
        break;
      case O::constant:
        value = scalar(constant(constant_of(node)));
        break;
      case O::quantity:
        value = value_of(node.quantity);
        break;
      case O::trace:
        value = scalar(trace_J());
        break;
      case O::negate:
        value = scaled(constant(N(-1)), operand(node.a));
        break;
      case O::add:
      case O::subtract:
        for (std::size_t i = 0; i < 3; ++i)
          value[i] = node.operation == O::add ? operand(node.a)[i] + operand(node.b)[i]
                                              : operand(node.a)[i] - operand(node.b)[i];
        break;
      case O::multiply:  // the builder has put a vector second
        value = scaled(operand(node.a)[0], operand(node.b));
        break;
      case O::divide: {
        const Number& divisor = operand(node.b)[0];
        if (divisor.value.is_zero()) return false;
        value = scaled(inverse(divisor), operand(node.a));
        break;
      }
      case O::power:
        value = Vector();
        return power(operand(node.a)[0], node.integer, value[0]);
      case O::dot:
        value = scalar(dot(operand(node.a), operand(node.b)));
        break;
      case O::cross:
        value = cross(operand(node.a), operand(node.b));
        break;
      case O::norm2:
        value = scalar(dot(operand(node.a), operand(node.a)));
        break;
      case O::norm:
        return length(operand(node.a), value);
      case O::inertia:
        value = to_space(I_times(to_body(operand(node.a))));
        break;
      case O::apply:
        value = to_space(J_times(to_body(operand(node.a))));
        break;
      case O::comp:
        value = scalar(to_body(operand(node.a))[static_cast<std::size_t>(node.integer)]);
        break;
      case O::ddt:
        value = rate_of(operand(node.a));
        break;
      case O::star:
        value = to_space(rate_of(to_body(operand(node.a))));
        break;
      case O::pi:
        if constexpr (!std::is_same_v<N, SizedNumber>) return false;
        value = scalar(constant(pi()));
        break;
      case O::cos:
        // The cosine of an angle is what the angle was taken of: exact, for all numbers.
        if (const ExpressionNode& angle = nodes[static_cast<std::size_t>(node.a)];
            angle.operation == O::acos) {
          value = operand(angle.a);
          return is_cosine(value[0]);
        }
        return function(node.operation, operand(node.a)[0], {}, value);
      case O::acos:
        if constexpr (!std::is_same_v<N, SizedNumber>)
          break;  // of exact numbers only its cosine is asked for
        return function(node.operation, operand(node.a)[0], {}, value);
      case O::sqrt:
      case O::sin:
      case O::exp:
      case O::log:
        return function(node.operation, operand(node.a)[0], {}, value);
      case O::atan2:
        return function(node.operation, operand(node.a)[0], operand(node.b)[0], value);
    }
    return true;
  }

  const ClaimState<N>& s_;
  std::array<Vector, 3> R_;
  Vector w_B_, N_B_, omega_, L_, N_;
  Number T_;
  std::vector<Vector> values_;
};

}  // namespace polhode
