// SPDX-License-Identifier: MIT
// "Did you mean": the known name nearest to one that is not known.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// Insertions, deletions, replacements and swaps of neighbours that turn a into b (optimal string alignment).
/// O(|a||b|) time.
int edit_distance(std::string_view a, std::string_view b);

/// The nearest known name if it is near enough to be meant: upper and lower case aside, at most a third of
/// the longer name's letters differ, at least one is allowed to, and three or more letters that begin a name
/// count as one difference. Names of more than 64 bytes are never near.
std::optional<std::string> nearest_name(std::string_view word, const std::vector<std::string>& known);

/// Hint for a word that is not known: `did you mean "omega"?`, or else `one of a, b, c`; empty if nothing is
/// known.
std::string suggestion(std::string_view word, const std::vector<std::string>& known);

}  // namespace polhode
