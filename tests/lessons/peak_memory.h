// SPDX-License-Identifier: MIT
// How much memory something takes at its peak.
#pragma once

#include <functional>

namespace polhode::testing {

/// Growth of the largest resident size while a child process does the work, KiB; −1 if it could not be
/// measured. What `work` returns is used, so that none of it is optimised away.
long peak_kilobytes(const std::function<std::size_t()>& work);

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool kSanitized = true;  ///< its own time and memory would be measured
#else
inline constexpr bool kSanitized = false;
#endif

}  // namespace polhode::testing
