// SPDX-License-Identifier: MIT
// Why an answer is wrong, in a word that stays the same from one version of the program to the next: logs and
// reports keep it, and over a class it is counted.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace polhode {

/// Of what is wrong without a reason that was found.
inline constexpr std::string_view kOtherReason = "other";

/// Whether a text can be such a word: 1 to 24 letters, digits and hyphens of ASCII.
bool is_reason_tag(std::string_view text);

/// Whether there is such a reason, of a question with so many choices: "choice-D" is one of four.
bool is_known_reason(std::string_view tag, std::size_t choices);

/// What is said of those who had this reason: "the sign of a term is wrong"; of "choice-B" "B was chosen".
/// A word that is not known says itself.
std::string words_of_reason(std::string_view tag);

}  // namespace polhode
