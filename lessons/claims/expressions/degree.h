// SPDX-License-Identifier: MIT
// Bounds of the degrees and coefficients of what expressions stand for, so that agreement at random points is
// proof (proof.h). One set of rules: for expressions as they are read, and once more where quantities are
// given, for these then stand for what they are set to. Internal to lessons/claims/.
#pragma once

#include "lessons/claims/given.h"

#include <array>

namespace polhode {

/// Bounds grow no further than this; nothing of such a degree is proved.
inline constexpr int kMostProvableDegree = 1 << 28;

class DegreeTable {
 public:
  /// Nothing is given.
  DegreeTable();
  explicit DegreeTable(const Given& given);

  /// Of a node whose operands have these degrees; of leaves these mean nothing.
  Degree of(const ExpressionNode& node, const Degree& a, const Degree& b) const;
  /// Of the whole.
  Degree of(const Expression& expression) const;

 private:
  void set(Quantity quantity, const Degree& value);
  void add_up();
  Degree of(Quantity quantity) const;
  Degree rate_of(const Degree& a) const;

  using Three = std::array<Degree, 3>;
  Three I_, w_, dw_, N_;   ///< components on the body axes
  Degree torque_, force_;  ///< vectors in space
  Degree energy_, omega_, L_, tensor_;
  Degree rates_;  ///< of all that moves, over one divisor
};

/// Of left − right, of one fraction, whose numerator is what can be 0.
Degree degree_of_difference(const Degree& left, const Degree& right);

}  // namespace polhode
