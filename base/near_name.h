// SPDX-License-Identifier: MIT
// "Did you mean": the known name nearest to one that is not known.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// Insertions, deletions, replacements and swaps of neighbours that turn a into b (optimal string alignment).
/// O(|a||b|) time.
int edit_distance(std::string_view a, std::string_view b);

/// The nearest known name if it is near enough to be meant, empty otherwise. Upper and lower case aside, at
/// most a third of the longer name's letters differ, at least one is allowed to but never all of the name's;
/// three or more letters that begin a name count as one difference. Of names equally near, one whose first
/// letter is the word's, then the first. Names of more than 64 bytes are never near.
std::string near_name(std::string_view word, const std::vector<std::string_view>& known);

}  // namespace polhode
