// SPDX-License-Identifier: MIT
// Commands that are offered to be copied into a shell.
#pragma once

#include <string>
#include <vector>

namespace polhode {

/// As a shell would read it: words with anything but letters, digits and a few signs are in quotes.
std::string shell_line(const std::vector<std::string>& words);

/// Whether a terminal shows every word as it is (base/printable.h). What was made printable is another
/// word: it is not to be offered.
bool shows_as_it_is(const std::vector<std::string>& words);

}  // namespace polhode
