// SPDX-License-Identifier: MIT
// A state in which something fails, and what its sides come to there, in words. Internal to lessons/.
#pragma once

#include "lessons/claims/proof/dependence.h"
#include "lessons/claims/proof/expansion.h"

#include <string>
#include <string_view>

namespace polhode {

class Ratio;

/// Of at most six digits; "−" is its minus.
std::string number_text(double value);

/// As the TeX of a counterexample has the name of a constant, whatever a lesson prints: "\text{mgl}".
std::string name_in_tex(std::string_view name);

/// The quantities of a state: as plain text, and with TeX between dollars.
struct StateText {
  std::string plain, tex;

  void add(const std::string& name, const std::string& tex_name, const std::string& value) {
    if (!plain.empty()) plain += ", ", tex += ", ";
    plain += name + " = " + value;
    tex += '$' + tex_name + " = " + numbers_as_tex(value) + '$';
  }
};

/// Of what something depends on; what is small has an ε, "ω = (ε, 1, 2ε)".
StateText text_of(const StateNumbers<SizedNumber>& numbers, const ClaimState<SizedNumber>& state,
                  const Dependence& depends, const SmallQuantities& small);

/// A side's value.
std::string value_text(const ComponentJets<SizedNumber, 0>& value, ExpressionType type);

/// A side's terms up to ε^last: "2 − 0.5ε".
std::string text_of(const Expansion<Ratio>& side, ExpressionType type, int last);

}  // namespace polhode
