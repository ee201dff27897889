// SPDX-License-Identifier: MIT
// The numbers of a motion at one time, as `polhode trace` gives them.
#pragma once

#include "physics/body/problem.h"
#include "physics/motion.h"

#include <array>
#include <string>
#include <string_view>

namespace polhode {

/// t in s; ω in rad/s, body axes; attitude body to space, scalar first; T in J; |L| and L in kg m²/s, space
/// axes.
inline constexpr std::array<std::string_view, 13> kTraceColumns = {"t",  "w1", "w2", "w3", "qw", "qx", "qy",
                                                                   "qz", "T",  "L",  "Lx", "Ly", "Lz"};
using TraceRow = std::array<double, kTraceColumns.size()>;

TraceRow trace_row(const Problem& problem, const Motion& motion, double t_s);

/// Whether the motion has overflowed: what it cannot compute is NaN from ω on.
bool overflowed(const TraceRow& row);

/// Lines of a CSV file, with their line ends; 17 significant digits.
std::string trace_csv_header();
std::string csv_line(const TraceRow& row);

}  // namespace polhode
