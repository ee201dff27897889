// SPDX-License-Identifier: MIT
// Whether a lesson's symbols are printed, said and coloured as what they are, and as nothing else.
#pragma once

#include "lessons/reader/front_matter/front_matter.h"

#include <string_view>
#include <vector>

namespace polhode {

/// A symbol that means something is one that means nothing else: neither a quantity, nor a number or product
/// of them, nor an index, nor the d and t of d/dt, nor another symbol. A constant has no letter of what
/// changes with the motion. What `say` names, and a letter alone, have the dimension of the symbol.
/// `entries` are those of [constants], [define] and [symbols], read already.
void check_meanings(const std::vector<const TomlEntry*>& entries, FrontMatter& front, TextReader& texts);

/// Whether learners type a component so, and a lesson would hide it: "L1", "v_x"; not w1, which is that.
bool is_component_name(std::string_view name);

}  // namespace polhode
