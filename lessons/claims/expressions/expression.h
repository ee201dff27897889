// SPDX-License-Identifier: MIT
// Expressions of claims and answers: read once, evaluated over whatever numbers there are (evaluation.h).
//
// What is read is meant: types are checked, derivatives go as far as rates are known, and the degree is
// bounded, so that agreement at random points is proof (proof.h).
#pragma once

#include "lessons/diagnostics/report.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

inline constexpr std::size_t kMaxExpressionBytes = 4096;
/// Brackets of an expression nest at most so deep.
inline constexpr int kMaxExpressionNesting = 64;
/// Exponents are whole numbers, at most so large either way.
inline constexpr int kMaxExponent = 16;
/// Bound of the degree of numerator and denominator in all that can vary; see Degree.
inline constexpr int kMaxDegree = 4096;
/// Parts of an expression, once the lesson's own words are written out.
inline constexpr std::size_t kMaxExpressionNodes = 4096;
/// Derivatives are at most second ones: of ω̇, N and F first ones.
inline constexpr int kMaxOrder = 2;
/// Digits of a number, without leading zeros; and the largest power of ten it may carry.
inline constexpr int kMaxDigits = 15, kMaxPowerOfTen = 18;

enum class ExpressionType { scalar, vector, zero };  ///< zero: the literal 0, which fits both
/// "a scalar", "a vector", "0".
std::string_view name_of(ExpressionType type);
/// Whether the two can be equal, or be added.
bool fit(ExpressionType a, ExpressionType b);

/// Scalars, w_i, dw_i, N_i on the body axes; vectors; and the components of J. A is any vector, J any inertia
/// tensor that is fixed in the body; h and k are any two numbers that do not change; ex, ey, ez are the axes
/// of space, e1, e2, e3 those of the body. T = ½ω·I·ω, L = I·ω and p = m v are what these definitions say;
/// the others vary freely, or as a law has it.
// clang-format off
enum class Quantity {
  T, I1, I2, I3, w1, w2, w3, dw1, dw2, dw3, N1, N2, N3, m, h, k,
  omega, L, N, p, v, F, A, e1, e2, e3, ex, ey, ez,
  Jxx, Jxy, Jxz, Jyy, Jyz, Jzz
};

enum class Operation {
  number, constant, pi, quantity, negate, add, subtract, multiply, divide, power,
  dot, cross, norm2, norm, inertia, apply, comp, trace, star, ddt,
  sqrt, sin, cos, acos, atan2, exp, log
};
// clang-format on

/// mantissa · 10^power: what was written, exactly.
struct DecimalNumber {
  std::int64_t mantissa = 0;
  int power_of_ten = 0;
  double value = 0;
};

/// Bounds of numerator and denominator in moments, components and quaternion, once everything is written out;
/// not the least ones. Their degrees, and how large their coefficients can be: log2 of the sum of their
/// absolute values, with the axes of body and space the same.
struct Degree {
  int numerator = 0, denominator = 0;
  double numerator_bits = 0, denominator_bits = 0;
};

/// Operands stand before what they are operands of.
struct ExpressionNode {
  Operation operation = Operation::number;
  int a = -1, b = -1;  ///< indices of the operands; a vector comes second in a product
  Quantity quantity = Quantity::T;
  DecimalNumber number;  ///< of a constant what the lesson says that it is
  int integer = 0;       ///< exponent of power, index (0 to 2) of comp, number of a constant
  ExpressionType type = ExpressionType::scalar;
  int order = 0;  ///< of the highest derivative in it; ω̇, and N and F, which make rates, are of order 1
  Degree degree;
  std::uint32_t begin = 0, end = 0;  ///< bytes of the text that it stands for
};

struct Expression {
  std::string text;
  std::vector<ExpressionNode> nodes;  ///< at least one; the last is the whole
  /// Names of the lesson's constants, by their numbers; null if the lesson has none.
  std::shared_ptr<const std::vector<std::string>> constants{};

  ExpressionType type() const { return nodes.back().type; }
  bool uses(Operation operation) const;
  bool uses(Quantity quantity) const;
  int order() const { return nodes.back().order; }
};

class Vocabulary;

/// Reads a text that stands on one line, its first byte at `start`, in the words of the language and those of
/// `vocabulary` (vocabulary.h; null: none), which are written out. One error with its column: characters and
/// names that are not known, brackets, missing operands, arguments, sums and products of what does not fit
/// together, derivatives of what has no known rate, too large exponents and degrees. Linear in the text and
/// what its words stand for.
std::optional<Expression> read_expression(std::string_view text, SourcePlace start, Report& report,
                                          const Vocabulary* vocabulary = nullptr);

/// The literal 0.
Expression zero_expression();

/// left = right.
struct Equality {
  Expression left, right;

  bool is_vector() const {
    return left.type() == ExpressionType::vector || right.type() == ExpressionType::vector;
  }
};

/// Exact arithmetic has no roots, angles or π. What is to be proved is free of them, but for lengths as
/// norm(a) = norm(b): these are not negative, so they are equal where their squares are.
/// Of angles there is one thing that is exact: the cosine of acos(a) is a.
/// @return whether both sides are free of lengths inside, and both are one, or neither is; and no sqrt, sin,
/// atan2 or pi is there, and no cos and acos but in cos(acos(a)).
bool is_provable(const Equality& equality);
/// Whether a single expression has none of these, and no lengths: an answer, or what an assumption sets.
bool is_rational(const Expression& expression);
/// Whether an equality is not provable for other reasons than its lengths; and what to say of it.
bool has_angles(const Equality& equality);
inline constexpr std::string_view kNoAngles =
    "exact arithmetic has no roots and no angles, but the cosine of an angle acos(a)";
/// Lengths that are whole sides replaced by their squares.
Equality with_lengths_squared(Equality equality);

/// Names an expression can use, for "did you mean".
const std::vector<std::string>& expression_symbols();
std::vector<std::string> expression_functions();

}  // namespace polhode
