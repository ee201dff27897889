// SPDX-License-Identifier: MIT
// Option values from their text. Options are taken from the parser as strings and read here, because numbers
// must be read exactly (decimal or 0x1.8p+1), whatever the locale. `option` names the option in the error.
//
// Errors: malformed or out of range: ExitCode::usage. A number that reads as infinite or NaN:
// ExitCode::invalid.
#pragma once

#include "physics/body/types.h"
#include "render/image/image.h"

#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// One finite number.
double finite_number(std::string_view option, std::string_view text);

/// Finite numbers separated by commas, at least one.
std::vector<double> finite_numbers(std::string_view option, std::string_view text);

/// Exactly three finite numbers separated by commas.
Vec3 finite_vector(std::string_view option, std::string_view text);

/// A decimal whole number within [smallest, largest].
long long whole_number(std::string_view option, std::string_view text, long long smallest, long long largest);

/// WxH, each within [1, largest] px.
Size picture_size(std::string_view option, std::string_view text, int largest);

}  // namespace polhode
