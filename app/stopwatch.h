// SPDX-License-Identifier: MIT
// Measured cost of a function.
#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

namespace polhode {

/// Median time of `repeats` calls, ns. The median ignores what other programs take from a few of them.
template <class F>
double median_ns(int repeats, F&& call) {
  std::vector<double> times;
  for (int i = 0; i < repeats; ++i) {
    const auto start = std::chrono::steady_clock::now();
    call();
    times.push_back(
        std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count());
  }
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

}  // namespace polhode
