// SPDX-License-Identifier: MIT
// The words of expressions. What else a new quantity needs stands in lessons/claims/README.md. Internal to
// lessons/.
#pragma once

#include "lessons/claims/expressions/expression.h"

#include <array>
#include <optional>
#include <string_view>

namespace polhode {

/// Powers of kg, m and s; angles have none.
using Dimension = std::array<double, 3>;
inline constexpr Dimension kNumber{0, 0, 0}, kTime{0, 0, 1}, kRate{0, 0, -1}, kInertia{1, 2, 0},
    kEnergy{1, 2, -2};

struct QuantityFacts {
  std::string_view name;
  Quantity quantity;
  ExpressionType type;
  int order;                           ///< as of ExpressionNode
  std::optional<Dimension> dimension;  ///< nothing: it may be anything
  std::string_view arrow_letter{};     ///< TeX of what is printed with an arrow: "\\omega"; empty: nothing is
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
  constexpr Dimension kSpin{0, 0, -1};
  return std::array<QuantityFacts, 35>{{
      {"T", S::T, scalar, 0, kEnergy},
      {"I1", S::I1, scalar, 0, kInertia},
      {"I2", S::I2, scalar, 0, kInertia},
      {"I3", S::I3, scalar, 0, kInertia},
      {"w1", S::w1, scalar, 0, kSpin},
      {"w2", S::w2, scalar, 0, kSpin},
      {"w3", S::w3, scalar, 0, kSpin},
      {"dw1", S::dw1, scalar, 1, Dimension{0, 0, -2}},
      {"dw2", S::dw2, scalar, 1, Dimension{0, 0, -2}},
      {"dw3", S::dw3, scalar, 1, Dimension{0, 0, -2}},
      {"N1", S::N1, scalar, 1, kEnergy},
      {"N2", S::N2, scalar, 1, kEnergy},
      {"N3", S::N3, scalar, 1, kEnergy},
      {"m", S::m, scalar, 0, Dimension{1, 0, 0}},
      {"h", S::h, scalar, 0, {}},
      {"k", S::k, scalar, 0, {}},
      {"omega", S::omega, vector, 0, kSpin, "\\omega"},
      {"L", S::L, vector, 0, Dimension{1, 2, -1}, "L"},
      {"N", S::N, vector, 1, kEnergy, "N"},
      {"p", S::p, vector, 0, Dimension{1, 1, -1}, "p"},
      {"v", S::v, vector, 0, Dimension{0, 1, -1}, "v"},
      {"F", S::F, vector, 1, Dimension{1, 1, -2}, "F"},
      {"A", S::A, vector, 0, {}, "A"},
      {"e1", S::e1, vector, 0, kNumber},
      {"e2", S::e2, vector, 0, kNumber},
      {"e3", S::e3, vector, 0, kNumber},
      {"ex", S::ex, vector, 0, kNumber},
      {"ey", S::ey, vector, 0, kNumber},
      {"ez", S::ez, vector, 0, kNumber},
      {"Jxx", S::Jxx, scalar, 0, kInertia},
      {"Jxy", S::Jxy, scalar, 0, kInertia},
      {"Jxz", S::Jxz, scalar, 0, kInertia},
      {"Jyy", S::Jyy, scalar, 0, kInertia},
      {"Jyz", S::Jyz, scalar, 0, kInertia},
      {"Jzz", S::Jzz, scalar, 0, kInertia},
  }};
}();

/// The ratio π, which only what is evaluated may use.
inline constexpr std::string_view kPiName = "pi";

inline constexpr std::array<FunctionFacts, 17> kFunctions = {{{"dot", Operation::dot, 2},
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
                                                              {"atan2", Operation::atan2, 2},
                                                              {"exp", Operation::exp, 1},
                                                              {"log", Operation::log, 1}}};

/// The row of a quantity.
const QuantityFacts& facts_of(Quantity quantity);
const QuantityFacts* find_quantity(std::string_view name);
const FunctionFacts* find_function(std::string_view name);

}  // namespace polhode
