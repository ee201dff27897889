// SPDX-License-Identifier: MIT
// The times of a trace. They are counted, not stored and not accumulated: time(i) depends on i alone.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace polhode {

/// --times, or --from --to with --every or --samples, or --periods --samples, as typed; empty where not
/// given.
struct TypedTimes {
  std::string times, from, to, every, periods, samples;
};

inline constexpr std::int64_t kMaxTraceRows = 100'000'000, kUsualTraceRows = 101;

class TraceTimes {
 public:
  std::int64_t count() const { return count_; }
  /// t of row i, s, 0 ≤ i < count().
  double operator()(std::int64_t i) const;
  /// The largest |t|, s.
  double furthest_s() const;

 private:
  friend TraceTimes trace_times(const TypedTimes& typed, double period_s, double duration_s);
  std::vector<double> listed_;  // --times, in the order asked
  std::int64_t count_ = 0;
  double from_s_ = 0, every_s_ = 0;  // t = from + i·every
  double whole_s_ = 0;               // or, if every is 0, t = from + i·whole/(count − 1)
};

/// @param period_s what --periods counts, s; ≤ 0: there is none
/// @param duration_s what is followed where no times are typed, or --samples N alone: N rows, or
/// kUsualTraceRows, from 0 to there; ≤ 0: they must be typed
/// --from A --to B --every D: A + iD, i = 0…⌊(B − A)/D·(1 + 4ε)⌋, so that an end that decimal rounding misses
/// by a hair is included. --samples N ≥ 2 includes both ends.
/// @throws CommandError usage: none or two of the three ways, or one half given; numbers that make no row, or
/// more than kMaxTraceRows
TraceTimes trace_times(const TypedTimes& typed, double period_s, double duration_s = 0);

}  // namespace polhode
