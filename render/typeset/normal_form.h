// SPDX-License-Identifier: MIT
// One spelling of what Unicode spells in several ways: é, and e with an accent behind it.
#pragma once

#include <string>
#include <string_view>

namespace polhode {

/// The text in Unicode's normal form D: what is put together is taken apart, and marks of one letter stand in
/// the order of their classes. What is no UTF-8 becomes U+FFFD.
std::string decomposed(std::string_view utf8);

}  // namespace polhode
