// SPDX-License-Identifier: MIT
// Measured cost of a function.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <vector>

namespace polhode {

/// The middle one; changes the order of its argument.
inline double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

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
  return median(times);
}

/// CPU time that this thread has taken, s: other programs add nothing to it.
inline double cpu_time_s() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// CPU time of one call, ns: median of up to 7 timings, each of as many calls as are needed for the clock;
/// fewer timings, down to one, if they would take longer than `budget_s`.
template <class F>
double median_cpu_ns(double budget_s, F&& call) {
  constexpr double kOneTiming_s = 20e-6, kMostTimings = 7;
  const auto timing_s = [&](int calls) {
    const double start_s = cpu_time_s();
    for (int i = 0; i < calls; ++i) call();
    return (cpu_time_s() - start_s) / calls;
  };
  const double first_s = std::max(timing_s(1), 1e-8);
  if (2 * first_s > budget_s) return 1e9 * first_s;
  const double calls = std::ceil(std::max(1.0, kOneTiming_s / first_s));
  const double timings = std::clamp(budget_s / (calls * first_s), 1.0, kMostTimings);
  std::vector<double> times_s;
  for (int i = 0; i < static_cast<int>(timings); ++i) times_s.push_back(timing_s(static_cast<int>(calls)));
  return 1e9 * median(times_s);
}

}  // namespace polhode
