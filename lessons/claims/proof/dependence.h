// SPDX-License-Identifier: MIT
// What an equality depends on. A search for counterexamples varies these quantities alone, and a
// counterexample names no others. Internal to lessons/claims/.
#pragma once

#include "lessons/claims/proof/proof.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace polhode {

/// What the sides of an equality depend on, of what is free to choose.
struct Dependence {
  bool I = false, J = false, w = false, dw = false, ddw = false, N = false, dN = false, v = false, dv = false,
       ddv = false, A = false, dA = false, ddA = false, F = false, dF = false, m = false, h = false,
       k = false, q = false;
  bool no_torque = false;               ///< on there being none
  std::vector<int> constants;           ///< of the lesson, by their numbers
  std::vector<std::string> names = {};  ///< of all of these

  void operator|=(const Dependence& other) {
    for (bool Dependence::*part : kParts) this->*part = this->*part || other.*part;
    for (const int constant : other.constants)
      if (std::find(constants.begin(), constants.end(), constant) == constants.end())
        constants.push_back(constant);
    if (names.empty()) names = other.names;
  }
  static const std::array<bool Dependence::*, 19> kParts;
};
/// Under these laws, and of what is given; there too what it is set to.
Dependence dependence_of(const Equality& equality, LawsAssumed laws, const Given& given);

}  // namespace polhode
