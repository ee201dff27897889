// SPDX-License-Identifier: MIT
// Numbers from their text and back, the same in every locale. Doubles are read and written nowhere else but
// by fmt.
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

/// As few digits as read back as the same double: "0.1", "1e+300".
std::string shortest(double value);
/// So many decimals: "0.50"; of 1e300 all 301 digits before them.
std::string fixed(double value, int decimals);
/// One digit before the point and so many behind it: "2.50e-07".
std::string scientific(double value, int decimals);

/// The parts of a text between separators; "a,,b" has three, "" has one.
std::vector<std::string_view> split(std::string_view text, char separator);

}  // namespace polhode
