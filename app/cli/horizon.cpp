// SPDX-License-Identifier: MIT
#include "app/cli/horizon.h"

#include "base/numbers.h"
#include "physics/analysis/conditioning.h"

#include <fmt/format.h>

#include <cmath>

namespace polhode {

namespace {

std::string number_or_null(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? digits17(*value) : "null";
}

}  // namespace

Horizon horizon_of(const Problem& problem) {
  if (!problem.torque.empty()) return {};
  const auto found = conditioning(problem.I, problem.start.w_B);
  if (!found) return {};
  return {found->phase_per_period, found->horizon_periods(1e-3), found->horizon_periods(1e-1)};
}

std::string sentence(const Horizon& horizon) {
  if (!horizon.periods_1e_3 || !horizon.periods_1e_1) return "";
  return fmt::format(
      "prediction horizon: rounding of the inputs alone moves the phase by 1e-3 rad after {:.2g} periods, by "
      "1e-1 rad after {:.2g}",
      *horizon.periods_1e_3, *horizon.periods_1e_1);
}

std::string json_members(const Horizon& horizon) {
  return fmt::format("\"condition\":{},\"horizon_periods\":{{\"1e-3\":{},\"1e-1\":{}}}",
                     number_or_null(horizon.condition), number_or_null(horizon.periods_1e_3),
                     number_or_null(horizon.periods_1e_1));
}

}  // namespace polhode
