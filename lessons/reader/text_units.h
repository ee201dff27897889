// SPDX-License-Identifier: MIT
// Units, signs and words in plain text around a number.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace polhode {

bool starts_with_any(std::string_view text, std::initializer_list<std::string_view> signs);
bool ends_with_any(std::string_view text, std::initializer_list<std::string_view> signs);
/// ASCII.
bool is_digit(char c);
bool is_letter(char c);

/// A blank, also one that no line breaks at, cut off in front or behind.
bool take_blank(std::string_view& text);
bool take_last_blank(std::string_view& text);
/// Without blanks at its ends.
std::string_view without_blanks(std::string_view text);

/// The unit that a text begins with, up to four words of it: "kg m²/s", "radians per second", as scaled_unit
/// reads it; empty if it begins with none.
std::string unit_at_start(std::string_view text);

/// The unit that a text ends with, behind a comma, a stroke, a bracket or "in": of "energy, kJ" and
/// "energy [kJ]" "kJ"; it and its brackets are cut off. Empty if it ends with none.
std::string take_unit_at_end(std::string& text);

/// The unit that a text says numbers are in, and nothing behind it but a verb: "the energy in kJ is". Empty if
/// it says none.
std::string unit_said_before(std::string_view text);

/// A word before or behind a number that would make it another: "minus", "twice", "million". Empty if there is
/// none.
std::string_view factor_before(std::string_view text);
std::string_view factor_behind(std::string_view text);

}  // namespace polhode
