// SPDX-License-Identifier: MIT
// What a formula that cannot be read shows above a claim, though no claim says it.
#pragma once

#include "lessons/claims/relation.h"
#include "render/typeset/math/tree.h"

#include <cstddef>
#include <set>
#include <string>

namespace polhode {

/// Whether it has ≠, ≡, → or another relation of which nothing is proved.
bool says_no_equality(const MathNode& node);
/// Functions and signs that no claim has: sinh, ∫, ⊕.
std::set<std::string> operators_in(const MathNode& node);
/// What it says of its sides, in the order of the enumeration: = and < of "a = b < c".
std::set<Relation> relations_in(const MathNode& node);
/// The numbers that it has as factors, not those of indices and powers: 2 and 3 of 2/3.
std::set<double> factors_in(const MathNode& node);
/// 0 and 1 are not among them, and 0.5 is as good as 1/2.
void add_factor(double number, std::set<double>& factors);
/// How many minus signs it has, those of indices and powers not among them.
std::size_t minuses_in(const MathNode& node);
/// T_{}: an index or a power that nobody sees.
bool has_empty_script(const MathNode& node);

}  // namespace polhode
