// SPDX-License-Identifier: MIT
// Expressions of claims as formulas, for whoever shows what was proved.
#pragma once

#include "lessons/claims/claim.h"
#include "lessons/claims/expressions/vocabulary.h"

#include <string>
#include <vector>

namespace polhode {

/// "\vec L", "I_1", "\hat e_x".
std::string tex_of(Quantity quantity);

/// "\vec\omega\cdot\mathbf I\cdot\vec\omega" of dot(omega, inertia(omega)): TeX that stands in a line of
/// text. Read as a printed equation (lessons/notation/tex_equation.h) it is the same function of the state,
/// but for the components of J, which no page prints. Words of the lesson's `vocabulary` are printed as it
/// says, or by their names. Linear.
std::string tex_of(const Expression& expression, const Vocabulary* vocabulary = nullptr);

/// "2T = …"; with its conclusion, if it has one, "A \Rightarrow B", or of a non-sequitur "A \not\Rightarrow
/// B".
std::string tex_of(const ClaimLine& line, ClaimKind kind, const Vocabulary* vocabulary = nullptr);

/// "I_2 = I_1".
std::string tex_of(const Setting& setting, const Vocabulary* vocabulary = nullptr);
/// "I_3 > I_1".
std::string tex_of(const Bound& bound, const Vocabulary* vocabulary = nullptr);

/// What is set and which is the greater, each as it is printed.
std::vector<std::string> printed_conditions(const Given& given);
/// "\omega_1" of each quantity that is small.
std::vector<std::string> printed_small(const Given& given);

}  // namespace polhode
