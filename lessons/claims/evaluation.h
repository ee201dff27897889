// SPDX-License-Identifier: MIT
// The value of an expression in one state of a body, over numbers N: residues modulo a prime (FieldElement),
// where equality is proof, or doubles (SizedNumber), where it is measured. One code for both.
//
// Every vector is evaluated by its components in space with their rates (dual numbers), so that d/dt is the
// rate of those components, d*/dt that of the components on the body axes Rᵀv, and the transport theorem is
// tested, not assumed.
#pragma once

#include "lessons/claims/expression.h"
#include "lessons/claims/prime_field.h"
#include "lessons/claims/sized_number.h"
#include "lessons/claims/vocabulary.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <type_traits>
#include <vector>

namespace polhode {

/// A value and its rate of change: x + ẋε with ε² = 0.
template <class N>
struct Dual {
  N value{}, rate{};

  friend Dual operator+(const Dual& a, const Dual& b) { return {a.value + b.value, a.rate + b.rate}; }
  friend Dual operator-(const Dual& a, const Dual& b) { return {a.value - b.value, a.rate - b.rate}; }
  friend Dual operator-(const Dual& a) { return {-a.value, -a.rate}; }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, a.value * b.rate + a.rate * b.value};
  }
};

template <class N>
Dual<N> inverse(const Dual<N>& a) {
  const N reciprocal = inverse(a.value);
  return {reciprocal, -(a.rate * reciprocal * reciprocal)};
}

/// Components; of a scalar the first.
template <class N>
using Triple = std::array<Dual<N>, 3>;

/// All that can vary. R takes body components to space components; columns are the body axes.
template <class N>
struct ClaimState {
  std::array<Triple<N>, 3> R;  ///< R[row][column]
  std::array<N, 3> I;          ///< principal moments
  std::array<N, 6> J;          ///< Jxx Jxy Jxz Jyy Jyz Jzz on the body axes
  Triple<N> w_B, v_S, A_S;     ///< with their rates
  std::array<N, 3> N_B, F_S;
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
template <class N>
struct VectorSizes {
  static void turned(Triple<N>&, const Triple<N>&, const std::array<Triple<N>, 3>&) {}
  static void mapped(Triple<N>&, const Triple<N>&) {}
  static void multiplied(Dual<N>&, const Triple<N>&, const Triple<N>&) {}
};

template <>
struct VectorSizes<SizedNumber> {
  using Vector = Triple<SizedNumber>;

  /// y = R x, or Rᵀx.
  static void turned(Vector& y, const Vector& x, const std::array<Vector, 3>& R) {
    const double turning = std::fmax(std::fmax(rate_size(R[0]), rate_size(R[1])), rate_size(R[2]));
    share(y, size(x), rate_size(x) + turning * size(x));
  }
  /// y is a tensor that is applied to x.
  static void mapped(Vector& y, const Vector& x) {
    const double length = std::hypot(x[0].value.value, x[1].value.value, x[2].value.value);
    const double mapped = std::hypot(y[0].value.value, y[1].value.value, y[2].value.value);
    share(y, length > 0 ? size(x) * mapped / length : size(y), rate_size(y));
  }
  /// Of a product of two vectors, or a component of one.
  static void multiplied(Dual<SizedNumber>& product, const Vector& a, const Vector& b) {
    product.value.size = size(a) * size(b);
    product.rate.size = size(a) * rate_size(b) + rate_size(a) * size(b);
  }

 private:
  static double size(const Vector& x) {
    return std::fmax(std::fmax(x[0].value.size, x[1].value.size), x[2].value.size);
  }
  static double rate_size(const Vector& x) {
    return std::fmax(std::fmax(x[0].rate.size, x[1].rate.size), x[2].rate.size);
  }
  static void share(Vector& x, double size, double rate_size) {
    for (Dual<SizedNumber>& component : x) component.value.size = size, component.rate.size = rate_size;
  }
};

/// sqrt, sin, cos, acos of x, or the angle whose tangent is x/y; with its rate. The size grows with the
/// relative error that the operands may have. Not finite where it is not defined.
inline Dual<SizedNumber> function_of(Operation operation, const Dual<SizedNumber>& x,
                                     const Dual<SizedNumber>& y) {
  const double a = x.value.value, b = y.value.value;
  double value = 0, by_a = 0, by_b = 0;  // and its derivatives
  switch (operation) {
    case Operation::sqrt:
      value = std::sqrt(a), by_a = 0.5 / value;
      break;
    case Operation::sin:
      value = std::sin(a), by_a = std::cos(a);
      break;
    case Operation::cos:
      value = std::cos(a), by_a = -std::sin(a);
      break;
    case Operation::acos:
      value = std::acos(a), by_a = -1 / std::sqrt((1 - a) * (1 + a));
      break;
    default:
      value = std::atan2(a, b), by_a = b / (a * a + b * b), by_b = -a / (a * a + b * b);
      break;
  }
  // Where a derivative is infinite the value is known all the same: sqrt(0), acos(1).
  const auto error = [](double slope, double size) { return size == 0 ? 0.0 : std::abs(slope) * size; };
  const double size = std::abs(value) + error(by_a, x.value.size) + error(by_b, y.value.size);
  return {{value, std::isfinite(size) ? size : std::abs(value) + std::sqrt(x.value.size)},
          {by_a * x.rate.value + by_b * y.rate.value, error(by_a, x.rate.size) + error(by_b, y.rate.size)}};
}

/// Evaluates in one state; the state must live as long.
template <class N>
class Evaluation {
 public:
  explicit Evaluation(const ClaimState<N>& state) : s_(state) {
    const Triple<N> L_B = I_times(s_.w_B);
    for (std::size_t i = 0; i < 3; ++i) N_B_[i] = constant(s_.N_B[i]);
    omega_ = to_space(s_.w_B);
    L_ = to_space(L_B);
    N_ = to_space(N_B_);
    T_ = constant(inverse(N(2))) * dot(s_.w_B, L_B);
  }

  /// False if it is not defined there: something was divided by zero.
  bool operator()(const Expression& expression, Triple<N>& value) {
    values_.resize(expression.nodes.size());
    for (std::size_t i = 0; i < values_.size(); ++i)
      if (!evaluate(expression.nodes, i, values_[i])) return false;
    value = values_.back();
    return true;
  }

  /// Components on the body axes.
  Triple<N> to_body(const Triple<N>& x_S) const {
    Triple<N> x_B;
    for (std::size_t i = 0; i < 3; ++i)
      x_B[i] = s_.R[0][i] * x_S[0] + s_.R[1][i] * x_S[1] + s_.R[2][i] * x_S[2];
    VectorSizes<N>::turned(x_B, x_S, s_.R);
    return x_B;
  }

 private:
  static Dual<N> constant(const N& value) { return {value, N(0)}; }
  static Triple<N> scalar(const Dual<N>& value) { return {value, Dual<N>(), Dual<N>()}; }

  Triple<N> to_space(const Triple<N>& x_B) const {
    Triple<N> x_S;
    for (std::size_t i = 0; i < 3; ++i)
      x_S[i] = s_.R[i][0] * x_B[0] + s_.R[i][1] * x_B[1] + s_.R[i][2] * x_B[2];
    VectorSizes<N>::turned(x_S, x_B, s_.R);
    return x_S;
  }

  static Dual<N> dot(const Triple<N>& a, const Triple<N>& b) {
    Dual<N> product = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    VectorSizes<N>::multiplied(product, a, b);
    return product;
  }
  static Triple<N> cross(const Triple<N>& a, const Triple<N>& b) {
    Triple<N> product{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    for (Dual<N>& component : product) VectorSizes<N>::multiplied(component, a, b);
    return product;
  }

  /// |x|, where N has roots; its rate x·ẋ/|x| is nothing that can be used where x = 0.
  static bool length([[maybe_unused]] const Triple<N>& x, [[maybe_unused]] Triple<N>& value) {
    if constexpr (std::is_same_v<N, SizedNumber>) {
      const Dual<N> square = dot(x, x);
      const double length = std::sqrt(square.value.value);
      value = scalar({{length, std::sqrt(square.value.size)},
                      {square.rate.value / (2 * length), square.rate.size / (2 * length)}});
      return true;
    }
    return false;
  }

  Dual<N> J_at(std::size_t row, std::size_t column) const {
    constexpr std::size_t kPlace[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
    return constant(s_.J[kPlace[row][column]]);
  }
  Triple<N> J_times(const Triple<N>& x_B) const {
    Triple<N> y_B;
    for (std::size_t i = 0; i < 3; ++i)
      y_B[i] = J_at(i, 0) * x_B[0] + J_at(i, 1) * x_B[1] + J_at(i, 2) * x_B[2];
    VectorSizes<N>::mapped(y_B, x_B);
    return y_B;
  }
  Triple<N> I_times(const Triple<N>& x_B) const {
    Triple<N> y_B{constant(s_.I[0]) * x_B[0], constant(s_.I[1]) * x_B[1], constant(s_.I[2]) * x_B[2]};
    VectorSizes<N>::mapped(y_B, x_B);
    return y_B;
  }
  /// tr(R J Rᵀ): of the components in space.
  Dual<N> trace_J() const {
    Dual<N> sum;
    for (const Triple<N>& row : s_.R) sum = sum + dot(row, J_times(row));
    return sum;
  }
  Triple<N> axis(std::size_t i) const { return {s_.R[0][i], s_.R[1][i], s_.R[2][i]}; }

  static Triple<N> rate_of(const Triple<N>& x) {
    return {constant(x[0].rate), constant(x[1].rate), constant(x[2].rate)};
  }

  Triple<N> value_of(Quantity quantity) const {
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
        return scalar(s_.w_B[nth(S::w1)]);
      case S::dw1:
      case S::dw2:
      case S::dw3:
        return scalar(constant(s_.w_B[nth(S::dw1)].rate));
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
        return scaled(constant(s_.m), s_.v_S);
      case S::v:
        return s_.v_S;
      case S::F:
        return {constant(s_.F_S[0]), constant(s_.F_S[1]), constant(s_.F_S[2])};
      case S::A:
        return s_.A_S;
      case S::e1:
      case S::e2:
      case S::e3:
        return axis(nth(S::e1));
      case S::ex:
      case S::ey:
      case S::ez: {
        Triple<N> e_S;
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

  static Triple<N> scaled(const Dual<N>& factor, const Triple<N>& x) {
    return {factor * x[0], factor * x[1], factor * x[2]};
  }

  static Dual<N> number(const DecimalNumber& number) { return constant(decimal<N>(number)); }

  static bool power(const Dual<N>& base, int exponent, Dual<N>& result) {
    if (exponent < 0 && base.value.is_zero()) return false;
    const Dual<N> factor = exponent < 0 ? inverse(base) : base;
    result = constant(N(1));
    for (int n = std::abs(exponent); n > 0; --n) result = result * factor;
    return true;
  }

  /// A function that has values where N has roots and angles.
  static bool function([[maybe_unused]] Operation operation, [[maybe_unused]] const Dual<N>& x,
                       [[maybe_unused]] const Dual<N>& y, [[maybe_unused]] Triple<N>& value) {
    if constexpr (std::is_same_v<N, SizedNumber>) {
      value = scalar(function_of(operation, x, y));
      return std::isfinite(value[0].value.value);
    }
    return false;
  }

  N constant_of(const ExpressionNode& node) const {
    if (s_.constants) return (*s_.constants)[static_cast<std::size_t>(node.integer)];
    if constexpr (std::is_same_v<N, SizedNumber>) return node.number.value;
    return N(0);  // states of exact numbers have their constants
  }

  bool evaluate(const std::vector<ExpressionNode>& nodes, std::size_t index, Triple<N>& value) const {
    using O = Operation;
    const ExpressionNode& node = nodes[index];
    const auto operand = [this](int which) -> const Triple<N>& {
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
        const Dual<N>& divisor = operand(node.b)[0];
        if (divisor.value.is_zero()) return false;
        value = scaled(inverse(divisor), operand(node.a));
        break;
      }
      case O::power:
        value = Triple<N>();
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
          break;
        }
        return function(node.operation, operand(node.a)[0], {}, value);
      case O::acos:
        if constexpr (!std::is_same_v<N, SizedNumber>)
          break;  // of exact numbers only its cosine is asked for
        return function(node.operation, operand(node.a)[0], {}, value);
      case O::sqrt:
      case O::sin:
        return function(node.operation, operand(node.a)[0], {}, value);
      case O::atan2:
        return function(node.operation, operand(node.a)[0], operand(node.b)[0], value);
    }
    return true;
  }

  const ClaimState<N>& s_;
  Triple<N> omega_, L_, N_B_, N_;
  Dual<N> T_;
  std::vector<Triple<N>> values_;
};

}  // namespace polhode
