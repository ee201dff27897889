// SPDX-License-Identifier: MIT
// The numbers of a motion at one time, as `polhode trace` gives them.
#pragma once

#include "base/result.h"
#include "physics/body/problem.h"

#include <string>
#include <string_view>
#include <vector>

namespace polhode {

struct TraceColumn {
  std::string_view name;
  double (*value)(const Problem& problem, double t_s, const RigidBodyState& state);
};
using TraceColumns = std::vector<TraceColumn>;
using TraceRow = std::vector<double>;

/// t in s; w1 w2 w3, ω in rad/s, body axes; qw qx qy qz, attitude body to space; T in J; L = |L| and Lx Ly Lz
/// in kg m²/s, space axes: those are given where nobody chooses. Besides them theta_deg phi_deg psi_deg,
/// Euler's angles z-x-z in degrees, φ and ψ from −180 to 180; e3x e3y e3z, axis 3 in space; V, potential
/// energy under gravity, J, zero at the height of the pivot; E = T + V.
TraceColumns usual_trace_columns();
/// Of names between commas. The error names the unknown one, and those that are known.
Result<TraceColumns> trace_columns_named(std::string_view names);

TraceRow trace_row(const TraceColumns& columns, const Problem& problem, double t_s,
                   const RigidBodyState& state);

/// Lines of a CSV file, with their line ends; 17 significant digits.
std::string trace_csv_header(const TraceColumns& columns);
std::string csv_line(const TraceRow& row);

}  // namespace polhode
