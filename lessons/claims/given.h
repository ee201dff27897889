// SPDX-License-Identifier: MIT
// What a lesson assumes beyond the kind of a claim: "for a symmetric body", "under its weight".
//
// An assumption sets quantities to expressions, I2 = I1 or N = mgl*cross(ez, e3), so that exact arithmetic
// stays exact: a state in which it holds is any state with those quantities replaced. It may also say which
// of two numbers is the greater, I3 > I1, which leaves all that can be equal as it is; and that quantities
// are small, so that what is claimed has to hold to some order in them and no further.
#pragma once

#include "lessons/claims/expressions/expression.h"
#include "lessons/claims/relation.h"
#include "lessons/diagnostics/diagnostic.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// quantity = value, one of I1 I2 I3 w1 w2 w3 N1 N2 N3 N F.
struct Setting {
  Quantity quantity = Quantity::I1;
  Expression value;
  std::string text;  ///< as it is written
  std::string tex;   ///< as it is printed
  SourcePlace place;
};

/// left < right, or >, <=, >=: of numbers, without rates and roots, where all is set that is set.
struct Bound {
  Equality sides;
  Relation relation = Relation::less;
  std::string text;  ///< as it is written
  std::string tex;   ///< as it is printed
  SourcePlace place;
};

/// What is small, each as ε times something that is not. Their own rates are what the laws of motion say:
/// nothing is assumed of them, and rates that no law says are not small.
struct SmallQuantities {
  std::vector<Quantity> quantities;  ///< none: nothing is small
  int order = 0;                     ///< sides agree through ε^order

  bool empty() const { return quantities.empty(); }
  bool has(Quantity quantity) const;  ///< components of N, where N is
  bool has_torque() const;
  std::vector<std::string_view> names() const;  ///< "w1", as they are written
};
inline constexpr int kMaxSmallOrder = 4;
/// "first" to "fourth".
std::string_view name_of_order(int order);
/// What can be small: w1 w2 w3, N, N1 N2 N3, h k.
bool can_be_small(Quantity quantity);

/// Settings in the order in which they are made: each sees what those before it have set.
struct Given {
  std::vector<std::string> names;  ///< of the assumptions that are put together
  std::vector<Setting> settings;
  std::vector<Bound> bounds = {};
  SmallQuantities small = {};

  bool empty() const { return settings.empty() && bounds.empty() && small.empty(); }
  bool sets(Quantity quantity) const;
  /// N or components of it: then there is a torque.
  bool sets_torque() const;
  /// ω at an instant, of which rates say nothing.
  bool sets_spin() const;
};

/// Bounds of a value's degree, numerator and denominator, so that proofs stay proofs (proof.h).
inline constexpr int kMaxSettingDegree = 64;

/// What is wrong with a setting among those before it; nothing if it can be made. Moments are set to numbers,
/// constants and other moments; nothing is set to rates, nor to what it sets itself, nor twice (N and its
/// components are the same).
struct SettingFault {
  std::string message, hint;
};
std::optional<SettingFault> why_not_set(const Setting& setting, const std::vector<Setting>& before);
/// What is wrong with an inequality; nothing if it can be assumed.
std::optional<SettingFault> why_not_bound(const Bound& bound);
/// What is small cannot be set as well, and together they are one order.
std::optional<SettingFault> why_not_together(const Given& given);

}  // namespace polhode
