// SPDX-License-Identifier: MIT
// Numbers from their text and back, the same in every locale.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// A decimal or hexadecimal (0x1.8p+1) floating-point number filling the whole text, correctly rounded;
/// infinities and NaN are read as such. Nothing if the text is not a number or its value is out of the range
/// of double (1e400).
std::optional<double> parse_number(std::string_view text);

/// So many significant digits at most, up to 17, as %g has them.
std::string digits(double value, int most);
/// 17 significant digits: reads back as the same double.
inline std::string digits17(double value) { return digits(value, 17); }

/// The parts of a text between separators; "a,,b" has three, "" has one.
std::vector<std::string_view> split(std::string_view text, char separator);

}  // namespace polhode
