// SPDX-License-Identifier: MIT
// The words of expressions. What else a new quantity needs stands in the README. Internal to lessons/.
#pragma once

#include "lessons/claims/expression.h"

#include <array>
#include <string_view>

namespace polhode {

struct QuantityFacts {
  std::string_view name;
  Quantity quantity;
  ExpressionType type;
  bool has_rate;
  Degree degree;  ///< vectors: of their components in space, with R(q) = homogeneous / |q|²
};

struct FunctionFacts {
  std::string_view name;
  Operation operation;
  int arguments;
};

inline constexpr double kLog3 = 1.585;  ///< log2 3, rounded up

/// The tensor: an argument of apply and trace alone.
inline constexpr std::string_view kTensorName = "J";

inline constexpr std::array<QuantityFacts, 35> kQuantities = [] {
  using S = Quantity;
  constexpr auto scalar = ExpressionType::scalar, vector = ExpressionType::vector;
  return std::array<QuantityFacts, 35>{{
      {"T", S::T, scalar, true, {3, 0, kLog3, 1}},
      {"I1", S::I1, scalar, true, {1, 0}},
      {"I2", S::I2, scalar, true, {1, 0}},
      {"I3", S::I3, scalar, true, {1, 0}},
      {"w1", S::w1, scalar, true, {1, 0}},
      {"w2", S::w2, scalar, true, {1, 0}},
      {"w3", S::w3, scalar, true, {1, 0}},
      {"dw1", S::dw1, scalar, false, {3, 1, kLog3, 0}},
      {"dw2", S::dw2, scalar, false, {3, 1, kLog3, 0}},
      {"dw3", S::dw3, scalar, false, {3, 1, kLog3, 0}},
      {"N1", S::N1, scalar, false, {1, 0}},
      {"N2", S::N2, scalar, false, {1, 0}},
      {"N3", S::N3, scalar, false, {1, 0}},
      {"m", S::m, scalar, true, {1, 0}},
      {"h", S::h, scalar, true, {1, 0}},
      {"k", S::k, scalar, true, {1, 0}},
      {"omega", S::omega, vector, true, {3, 2}},
      {"L", S::L, vector, true, {4, 2}},
      {"N", S::N, vector, false, {3, 2}},
      {"p", S::p, vector, true, {2, 0}},
      {"v", S::v, vector, true, {1, 0}},
      {"F", S::F, vector, false, {1, 0}},
      {"A", S::A, vector, true, {1, 0}},
      {"e1", S::e1, vector, true, {2, 2}},
      {"e2", S::e2, vector, true, {2, 2}},
      {"e3", S::e3, vector, true, {2, 2}},
      // On the body axes, where coefficients are bounded (proof.h), these are rows of R(q).
      {"ex", S::ex, vector, true, {2, 2, 2, 2}},
      {"ey", S::ey, vector, true, {2, 2, 2, 2}},
      {"ez", S::ez, vector, true, {2, 2, 2, 2}},
      {"Jxx", S::Jxx, scalar, true, {1, 0}},
      {"Jxy", S::Jxy, scalar, true, {1, 0}},
      {"Jxz", S::Jxz, scalar, true, {1, 0}},
      {"Jyy", S::Jyy, scalar, true, {1, 0}},
      {"Jyz", S::Jyz, scalar, true, {1, 0}},
      {"Jzz", S::Jzz, scalar, true, {1, 0}},
  }};
}();

/// The ratio π, which only what is evaluated may use.
inline constexpr std::string_view kPiName = "pi";

inline constexpr std::array<FunctionFacts, 15> kFunctions = {{{"dot", Operation::dot, 2},
                                                              {"cross", Operation::cross, 2},
                                                              {"norm2", Operation::norm2, 1},
                                                              {"norm", Operation::norm, 1},
                                                              {"inertia", Operation::inertia, 1},
                                                              {"apply", Operation::apply, 2},
                                                              {"comp", Operation::comp, 2},
                                                              {"trace", Operation::trace, 1},
                                                              {"star", Operation::star, 1},
                                                              {"ddt", Operation::ddt, 1},
                                                              {"sqrt", Operation::sqrt, 1},
                                                              {"sin", Operation::sin, 1},
                                                              {"cos", Operation::cos, 1},
                                                              {"acos", Operation::acos, 1},
                                                              {"atan2", Operation::atan2, 2}}};

const QuantityFacts* find_quantity(std::string_view name);
const FunctionFacts* find_function(std::string_view name);

}  // namespace polhode
