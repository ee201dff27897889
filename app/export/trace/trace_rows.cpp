// SPDX-License-Identifier: MIT
#include "app/export/trace/trace_rows.h"

#include "base/angles.h"
#include "base/numbers.h"
#include "base/spelling.h"
#include "physics/body/euler.h"
#include "physics/body/euler_angles.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace polhode {

namespace {

using State = RigidBodyState;

constexpr std::size_t kUsualColumns = 13;

double T_of(const Problem& problem, const State& state) { return kinetic_energy(problem.I, state.w_B); }

constexpr std::array kColumns = std::to_array<TraceColumn>({
    {"t", [](const Problem&, double t_s, const State&) { return t_s; }},
    {"w1", [](const Problem&, double, const State& s) { return s.w_B[0]; }},
    {"w2", [](const Problem&, double, const State& s) { return s.w_B[1]; }},
    {"w3", [](const Problem&, double, const State& s) { return s.w_B[2]; }},
    {"qw", [](const Problem&, double, const State& s) { return s.q_SB.w(); }},
    {"qx", [](const Problem&, double, const State& s) { return s.q_SB.x(); }},
    {"qy", [](const Problem&, double, const State& s) { return s.q_SB.y(); }},
    {"qz", [](const Problem&, double, const State& s) { return s.q_SB.z(); }},
    {"T", [](const Problem& p, double, const State& s) { return T_of(p, s); }},
    {"L",
     [](const Problem& p, double, const State& s) { return angular_momentum_B(p.I, s.w_B).stableNorm(); }},
    {"Lx", [](const Problem& p, double, const State& s) { return angular_momentum_S(p.I, s)[0]; }},
    {"Ly", [](const Problem& p, double, const State& s) { return angular_momentum_S(p.I, s)[1]; }},
    {"Lz", [](const Problem& p, double, const State& s) { return angular_momentum_S(p.I, s)[2]; }},
    {"theta_deg", [](const Problem&, double,
                     const State& s) { return euler_angles_of(s.q_SB).theta_rad * kDegreesPerRadian; }},
    {"phi_deg", [](const Problem&, double,
                   const State& s) { return euler_angles_of(s.q_SB).phi_rad * kDegreesPerRadian; }},
    {"psi_deg", [](const Problem&, double,
                   const State& s) { return euler_angles_of(s.q_SB).psi_rad * kDegreesPerRadian; }},
    {"e3x", [](const Problem&, double, const State& s) { return (s.q_SB * Vec3::UnitZ()).x(); }},
    {"e3y", [](const Problem&, double, const State& s) { return (s.q_SB * Vec3::UnitZ()).y(); }},
    {"e3z", [](const Problem&, double, const State& s) { return (s.q_SB * Vec3::UnitZ()).z(); }},
    {"V", [](const Problem& p, double, const State& s) { return potential_energy(p.torque, s); }},
    {"E",
     [](const Problem& p, double, const State& s) { return T_of(p, s) + potential_energy(p.torque, s); }},
});

}  // namespace

TraceColumns usual_trace_columns() { return {kColumns.begin(), kColumns.begin() + kUsualColumns}; }

Result<TraceColumns> trace_columns_named(std::string_view names) {
  TraceColumns columns;
  for (const std::string_view name : split(names, ',')) {
    const auto column =
        std::find_if(kColumns.begin(), kColumns.end(), [&](const TraceColumn& c) { return c.name == name; });
    if (column == kColumns.end()) {
      std::vector<std::string> known;
      for (const TraceColumn& c : kColumns) known.emplace_back(c.name);
      return failure(fmt::format("no column \"{}\"{} (there are {})", name.substr(0, 40),
                                 did_you_mean(name, known), fmt::join(known, ", ")));
    }
    columns.push_back(*column);
  }
  return columns;
}

TraceRow trace_row(const TraceColumns& columns, const Problem& problem, double t_s,
                   const RigidBodyState& state) {
  TraceRow row;
  row.reserve(columns.size());
  for (const TraceColumn& column : columns) row.push_back(column.value(problem, t_s, state));
  return row;
}

std::string trace_csv_header(const TraceColumns& columns) {
  std::vector<std::string_view> names;
  for (const TraceColumn& column : columns) names.push_back(column.name);
  return fmt::format("{}\n", fmt::join(names, ","));
}

std::string csv_line(const TraceRow& row) { return fmt::format("{:.17g}\n", fmt::join(row, ",")); }

}  // namespace polhode
