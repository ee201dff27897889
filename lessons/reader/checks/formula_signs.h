// SPDX-License-Identifier: MIT
// What a formula that cannot be read shows above a claim, though no claim says it.
#pragma once

#include "lessons/claims/relation.h"
#include "render/typeset/math/tree.h"

#include <set>
#include <string>

namespace polhode {

/// Whether it has ≠, ≡, → or another relation of which nothing is proved.
bool says_no_equality(const MathNode& node);
/// Functions and signs that no claim has: sinh, ∫, ⊕.
std::set<std::string> operators_in(const MathNode& node);
/// What it says of its sides, in the order of the enumeration: = and < of "a = b < c".
std::set<Relation> relations_in(const MathNode& node);

}  // namespace polhode
