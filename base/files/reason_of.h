// SPDX-License-Identifier: MIT
// What the system says of a call that failed.
#pragma once

#include <string>
#include <system_error>

namespace polhode {

/// The words of an errno, for the end of a message: "No such file or directory".
inline std::string reason_of(int error) { return std::generic_category().message(error); }

}  // namespace polhode
