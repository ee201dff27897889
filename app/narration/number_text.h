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

}  // namespace polhode
