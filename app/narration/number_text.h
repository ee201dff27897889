// SPDX-License-Identifier: MIT
// Computed numbers as they are printed and spoken.
#pragma once

#include "base/words/language.h"

#include <string>

namespace polhode {

/// As TeX: so many significant digits (0: three), or all before the point up to 99,999: "2.47", "0.0123",
/// "22500"; others with a power of ten.
std::string number_tex(double value, int digits = 0);
/// The same in words: "minus 1.23 times 10 to the power 5".
std::string number_words(double value, int digits = 0, Language language = Language::en);
/// In words with at most so many significant digits, without zeros behind them: "minus 0.5",
/// "8.01 times 10 to the power 37". What is not finite is "not defined".
std::string short_number_words(double value, int digits, Language language);
/// "radians per second"; a unit that has no words as it is written.
std::string unit_in_words(const std::string& unit, Language language);
/// A number that is in words already, with its unit: "0.5 seconds", "1 second"; without one the number alone.
std::string with_unit(const std::string& number, const std::string& unit, Language language);

}  // namespace polhode
