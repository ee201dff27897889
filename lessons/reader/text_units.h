// SPDX-License-Identifier: MIT
// Units, signs and words in plain text around a number.
#pragma once

#include "lessons/claims/relation.h"

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace polhode {

bool starts_with_any(std::string_view text, std::initializer_list<std::string_view> signs);
bool ends_with_any(std::string_view text, std::initializer_list<std::string_view> signs);

/// A blank, also one that no line breaks at, cut off in front or behind.
bool take_blank(std::string_view& text);
bool take_last_blank(std::string_view& text);
/// Without blanks at its ends.
std::string_view without_blanks(std::string_view text);

/// The unit that a text begins with, up to four words of it: "kg m²/s", "radians per second", as scaled_unit
/// reads it; empty if it begins with none.
std::string unit_at_start(std::string_view text);

/// The same of a text behind a number, with blanks before the unit.
std::string unit_behind(std::string_view text);

/// The unit that all of a text is, likewise; empty if it is more or another.
std::string whole_unit(std::string_view text);

/// The unit that a text ends with, behind a comma, a stroke, a bracket or "in": of "energy, kJ" and
/// "energy [kJ]" "kJ"; it is cut off. Empty if it ends with none.
std::string take_unit_at_end(std::string& text);

/// The unit that a text says a number behind it is in: "the energy in kJ is". Empty if it says none.
std::string unit_said_before(std::string_view text);
/// What a text says that a number behind it is: "the energy" of "In all the energy is". Empty if it does not.
std::string_view name_said_before(std::string_view text);
/// "is", "is more than", between a formula and a number: what they say of both. Nothing of other words.
std::optional<Relation> relation_said(std::string_view words);

/// A word before or behind a number that would make it another: "minus", "twice", "million". Empty if there
/// is none.
std::string_view factor_before(std::string_view text);
std::string_view factor_behind(std::string_view text);

}  // namespace polhode
