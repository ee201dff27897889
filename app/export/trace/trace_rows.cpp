// SPDX-License-Identifier: MIT
#include "app/export/trace/trace_rows.h"

#include "physics/body/euler.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace polhode {

TraceRow trace_row(const Problem& problem, const Motion& motion, double t_s) {
  const RigidBodyState state = motion.at(t_s);
  const Vec3& w = state.w_B;
  const Quat& q = state.q_SB;
  const Vec3 L_B = angular_momentum_B(problem.I, w);
  const Vec3 L_S = angular_momentum_S(problem.I, state);
  return {
      t_s,    w[0],   w[1],  w[2], q.w(), q.x(), q.y(), q.z(), kinetic_energy(problem.I, w), L_B.stableNorm(),
      L_S[0], L_S[1], L_S[2]};
}

bool overflowed(const TraceRow& row) {
  return !std::all_of(&row[1], &row[8], [](double x) { return std::isfinite(x); });
}

std::string trace_csv_header() { return fmt::format("{}\n", fmt::join(kTraceColumns, ",")); }

std::string csv_line(const TraceRow& row) { return fmt::format("{:.17g}\n", fmt::join(row, ",")); }

}  // namespace polhode
