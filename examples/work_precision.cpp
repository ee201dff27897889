// SPDX-License-Identifier: MIT
// What accuracy costs: three methods follow the same body for 100 periods, with ever shorter steps.
#include <polhode/body.h>
#include <polhode/errors.h>
#include <polhode/method.h>

#include <cstdio>
#include <string>

int main() {
  using namespace polhode;
  const Problem problem{{1, 2, 3}, {.w_B = {0.1, 1.5, 0.2}}, {}};  // kg m², rad/s; no torque
  // It ends as soon as rounding keeps the errors from falling; the seconds are for a slow machine.
  const WorkPrecisionPlan plan{.period_s = characteristic_time(problem).value(),
                               .periods = 100,
                               .methods = {Method::rk4, Method::moser_veselov_10, Method::exact},
                               .cpu_seconds = 20};
  const Result<WorkPrecision> measured = measure_work_precision(problem, plan);
  if (!measured) return std::puts(measured.error().c_str()), 1;

  std::puts("method             step s        us/period  error      drift of T");
  for (const WorkPrecisionRow& row : measured->rows)
    std::printf("%-17s %-13.6g %-10.4g %-10.3g %.3g\n", std::string(name_of(row.method)).c_str(),
                row.step_s.value_or(0), 1e-3 * row.ns_per_period, row.error(), row.drift_T);
  if (const auto best = cheapest_within(measured->rows, 1e-6))
    std::printf("cheapest within 1e-6: %s\n", std::string(name_of(measured->rows[*best].method)).c_str());
}
