// SPDX-License-Identifier: MIT
// Units as they are printed, numbers that are typed with one, and names. Internal to lessons/notation/.
#pragma once

#include "lessons/notation/tex_items.h"
#include "lessons/notation/tex_sides.h"

#include <optional>
#include <span>
#include <string>

namespace polhode {

/// The unit that words and upright letters make, "kg m^2/s"; empty if they make none.
std::string unit_of(std::span<const TexItem> items);

/// "5\,\text{kJ}", "-0.3", "2.5\cdot10^{3}", "90^\circ"; nothing of what is no number, or has more beside it.
std::optional<TypedNumber> typed_number(std::span<const TexItem> items);

/// The number as an expression of SI, with its unit.
std::string in_si(const TypedNumber& number);

/// See tex_sides.h.
char32_t letter_of_name(std::span<const TexItem> items);

/// T, I, ω and L: whatever index one has, it is read as what every body has that turns.
bool is_letter_of_rotation(char32_t letter);

}  // namespace polhode
