// SPDX-License-Identifier: MIT
// What letters and words stand for wherever the motion of a body is written about, whether or not a lesson
// says so: a number of joules that is called ω, or "angular momentum", is false on any page.
#pragma once

#include "lessons/claims/expressions/expression_names.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// The dimensions that a quantity of this letter can have: of U'L' that of angular momentum, of U'τ' those of
/// a time and of a torque. Empty: the letter is anybody's.
std::vector<Dimension> dimensions_of_letter(char32_t letter);

/// The same of words that are the name of a quantity, or of a part of one, and what more is said of it: "the
/// angular momentum", "energy of the spin", "component of the torque", not "change of the
/// energy".
std::vector<Dimension> dimensions_of_words(std::string_view words);

/// Whether a name that can have these dimensions is one for a quantity of that; true of any where none is
/// known, on either side.
bool can_have(const std::vector<Dimension>& of_name, const std::optional<Dimension>& dimension);

}  // namespace polhode
