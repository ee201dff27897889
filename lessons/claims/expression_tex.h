// SPDX-License-Identifier: MIT
// Expressions of claims as formulas, for whoever shows what was proved.
#pragma once

#include "lessons/claims/claim.h"

#include <string>

namespace polhode {

/// "\vec\omega\cdot\mathbf I\cdot\vec\omega" of dot(omega, inertia(omega)): TeX that stands in a line of
/// text. Read as a printed equation (lessons/reader/tex_equation.h) it is the same function of the state, but
/// for the components of J, which no page prints. Linear.
std::string tex_of(const Expression& expression);

/// "2T = …"; of a non-sequitur with its conclusion, "A \not\Rightarrow B".
std::string tex_of(const ClaimLine& line);

}  // namespace polhode
