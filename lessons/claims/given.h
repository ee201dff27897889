// SPDX-License-Identifier: MIT
// What a lesson assumes beyond the kind of a claim: "for a symmetric body", "under its weight".
//
// An assumption sets quantities to expressions, I2 = I1 or N = mgl*cross(ez, e3), so that exact arithmetic
// stays exact: a state in which it holds is any state with those quantities replaced.
#pragma once

#include "lessons/claims/expression.h"
#include "lessons/diagnostics/diagnostic.h"

#include <optional>
#include <string>
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

/// Settings in the order in which they are made: each sees what those before it have set.
struct Given {
  std::vector<std::string> names;  ///< of the assumptions that are put together
  std::vector<Setting> settings;

  bool empty() const { return settings.empty(); }
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

}  // namespace polhode
