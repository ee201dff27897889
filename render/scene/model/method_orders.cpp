// SPDX-License-Identifier: MIT
#include "render/scene/model/method_orders.h"

#include <cmath>

namespace polhode {

namespace {

constexpr double kLargestError = 10;  // beyond, a method has not followed the motion at all

using Points = std::vector<std::pair<double, double>>;

Points points_of(Method method, const std::vector<MethodTable>& tables, bool by_evaluations) {
  Points points;
  for (const MethodTable& table : tables)
    for (const MethodRow& row : table.rows)
      if (row.method == method && row.error.omega <= kLargestError)
        points.emplace_back(std::abs(table.t_s) * (by_evaluations ? row.evaluations_per_s : 1 / table.step_s),
                            row.error.omega);
  return points;
}

/// Where the error is small, and far above rounding, which grows with the number of steps.
std::optional<double> measured_order(const Points& points) {
  constexpr double kSmall = 0.05, kAboveRounding = 3e-12;
  std::optional<double> order;
  for (std::size_t i = 1; i < points.size(); ++i)
    if (points[i - 1].second < kSmall && points[i].second > kAboveRounding)
      order = std::log2(points[i - 1].second / points[i].second);
  return order;
}

}  // namespace

std::vector<MethodOrder> method_orders(const std::vector<MethodTable>& tables, bool by_evaluations) {
  std::vector<MethodOrder> all;
  if (tables.empty()) return all;
  for (const MethodRow& row : tables.front().rows) {
    if (facts_of(row.method).control != StepControl::fixed) continue;
    Points points = points_of(row.method, tables, by_evaluations);
    const std::optional<double> order = measured_order(points);
    if (!points.empty()) all.push_back({row.method, std::move(points), order});
  }
  return all;
}

}  // namespace polhode
