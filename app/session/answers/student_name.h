// SPDX-License-Identifier: MIT
// Names that students type: which can be taken, and which are one.
#pragma once

#include <string>
#include <string_view>

namespace polhode {

inline constexpr int kMaxStudentCharacters = 100;

/// Without blanks of any kind around it.
std::string trimmed_name(std::string_view name);

/// What is wrong with a name, in one sentence; empty: nothing. It is one line of at most
/// kMaxStudentCharacters, without characters that control a screen or cannot be seen: two names that look
/// the same are to be the same.
std::string fault_of_name(std::string_view name);

/// The same of names that look the same: however accents and blanks are spelled, and with letters of other
/// scripts for Latin ones, А for A, I for l. Small and capital letters differ.
std::string comparable_name(std::string_view name);

/// A blank of any kind, or a character that cannot be seen.
bool is_unseen(char32_t character);

}  // namespace polhode
