// SPDX-License-Identifier: MIT
// What a lesson assumes where it says so: the table [assume], and the names that claims and questions give.
#pragma once

#include "lessons/claims/expressions/dimension.h"
#include "lessons/claims/expressions/vocabulary.h"
#include "lessons/claims/given.h"
#include "lessons/reader/front_matter/keys.h"
#include "lessons/reader/front_matter/toml_tree.h"
#include "lessons/reader/markdown/inline_text.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace polhode {

/// By their names.
using Assumptions = std::map<std::string, Given>;

/// Assumptions of a lesson, settings of one, and assumptions that a claim puts together.
inline constexpr std::size_t kMaxAssumptions = 32, kMaxSettings = 8, kMaxGiven = 4;

/// [assume] NAME = "I2 = I1" or "I3 > I1", or a list of such; or { small = ["w1", "w3"], order = 1 }. Reports
/// what cannot be set (why_not_set), be compared (why_not_bound) or be small, units that disagree, and what
/// no body can be. `dimensions` are those of constants, by their numbers.
Assumptions read_assumptions(const TomlEntry& entry, const Vocabulary& vocabulary,
                             const std::map<int, Dimension>& dimensions, TextReader& texts);

/// Those of these names put together. Nothing, and reports, if one is unknown or named twice, if two set the
/// same, or if no body can be as all of them say.
std::optional<Given> given_by(const std::vector<PlacedText>& names, const Assumptions& assumptions,
                              Report& report);

}  // namespace polhode
