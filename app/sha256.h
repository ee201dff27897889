// SPDX-License-Identifier: MIT
// SHA-256 of a text, for manifests.
#pragma once

#include <string>
#include <string_view>

namespace polhode {

/// 64 lower-case hexadecimal digits (FIPS 180-4), as sha256sum prints them.
std::string sha256_hex(std::string_view text);

}  // namespace polhode
