// SPDX-License-Identifier: MIT
// "Did you mean": the known name closest to one that is not known, and what to say of it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// Insertions, deletions, replacements and swaps of neighbours that turn a into b (optimal string alignment).
/// O(|a||b|) time.
int edit_distance(std::string_view a, std::string_view b);

/// The closest known name if it is close enough to be meant, empty otherwise. Upper and lower case aside, at
/// most a third of the longer name's letters differ, at least one is allowed to but never all of the name's;
/// three or more letters that begin a name count as one difference. Of names equally close, one whose first
/// letter is the word's, then the first. Names of more than 64 bytes are never close.
std::string closest_name(std::string_view word, const std::vector<std::string_view>& known);

/// As a hint: `did you mean "omega"?`, or else `one of a, b, c`; empty if nothing is known.
std::string suggestion(std::string_view word, const std::vector<std::string>& known);

/// As the end of a sentence: `; did you mean "omega"?`, or nothing if no known name is close.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& known);

}  // namespace polhode
