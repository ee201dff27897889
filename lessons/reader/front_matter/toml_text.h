// SPDX-License-Identifier: MIT
// Values as TOML that reads back as the same bits.
#pragma once

#include "physics/body/types.h"

#include <string>
#include <vector>

namespace polhode {

/// The shortest decimal that reads back as the same double, with the dot or exponent of a float.
std::string toml(double value);
std::string toml(const std::vector<double>& values);
std::string toml(const Vec3& v);
/// Between single quotes where that is possible: TeX is most readable there.
std::string toml(const std::string& text);
/// A name, which needs no escapes.
std::string toml(const char* name);
std::string toml_list(const std::vector<std::string>& names);

}  // namespace polhode
