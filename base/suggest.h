// SPDX-License-Identifier: MIT
// "Did you mean" as a hint: the known name nearest to one that is not known, or those there are.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// As near_name() has it; nothing if no known name is near.
std::optional<std::string> nearest_name(std::string_view word, const std::vector<std::string>& known);

/// Hint for a word that is not known: `did you mean "omega"?`, or else `one of a, b, c`; empty if nothing is
/// known.
std::string suggestion(std::string_view word, const std::vector<std::string>& known);

}  // namespace polhode
