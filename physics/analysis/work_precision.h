// SPDX-License-Identifier: MIT
// The trade between speed and accuracy, measured: what each method costs and how wrong it is after some
// periods, over a range of steps or tolerances.
//
// Error: at the end, against the closed form, whose own error is closed_form_error or top_error; where there
// is none against Dormand-Prince 8(5,3) at kReferenceTolerance, whose own is estimated by the next looser
// tolerance. No error is given as less than the reference's own, not even that of the reference method
// itself. Drift: the largest over kDriftSamples times and the end. Cost: CPU time of this thread, from making
// the motion to its state at the end; median of repeats, of long runs a single one.
#pragma once

#include "base/result.h"
#include "physics/body/problem.h"
#include "physics/method_facts.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace polhode {

inline constexpr double kReferenceTolerance = 1e-14;
inline constexpr int kDriftSamples = 512;
/// So many times in (0, end_s), in order, that fall in step neither with a period nor with a fixed step.
std::vector<double> drift_times_s(double end_s);

/// A number is NaN where it could not be computed (an implicit method that found no solution, an overflow) or
/// where there is nothing to be kept (motion_errors.h).
struct WorkPrecisionRow {
  static constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  Method method = Method::exact;
  std::optional<double> step_s = {}, tolerance = {};
  std::int64_t evaluations = 0;  ///< Motion::evaluations_to the end
  double ns_per_period = kNaN;
  double error_omega = kNaN, error_attitude_rad = kNaN;
  double drift_T = kNaN, drift_L = kNaN, drift_L_direction_rad = kNaN;

  double error() const;  ///< the larger of both; NaN if one is
};

struct WorkPrecisionPlan {
  double period_s = 1;          ///< unit of time in which is counted, > 0; characteristic_time, say
  double periods = 100;         ///< > 0
  std::vector<Method> methods;  ///< those that serve the problem; in this order
  double cpu_seconds = 8;       ///< about what the whole measurement may take
  int most_settings = 40;       ///< steps or tolerances of one method
};

struct WorkPrecision {
  std::vector<WorkPrecisionRow> rows;  ///< method by method, long steps and loose tolerances first
  double reference_error = 0;          ///< error of the reference itself: the larger of ω and attitude
  std::vector<Method> out_of_reach;    ///< methods without a row: even long steps are too many for the time
};

/// Steps begin with a tenth of a period, or the whole time if that is shorter, halved until ω takes two of
/// them or more for a turn, and are halved from row to row; tolerances go from 1e-3 to 1e-13 by tens. A
/// method has no more rows when two in succession have brought neither error below 0.7 of its least (rounding
/// has stopped the fall; errors of kNoAnswer do not count), when the next is expected to exceed the method's
/// share of the time that is left, or after most_settings. `progress`, if there is one, is called before each
/// method with its place in the plan. The error: the reference cannot be computed. @throws what `progress`
/// throws
Result<WorkPrecision> measure_work_precision(const Problem& problem, const WorkPrecisionPlan& plan,
                                             const std::function<void(std::size_t)>& progress = {});

/// An error of this much, relative or in rad, is no answer.
inline constexpr double kNoAnswer = 0.1;

/// front[i]: no other row is as fast and as accurate as row i and better in one of the two. A row without an
/// answer is never on it.
std::vector<bool> pareto_front(std::span<const WorkPrecisionRow> rows);

/// The front among the rows of integrators alone: a closed form, where there is one, beats them all.
std::vector<bool> front_step_by_step(std::span<const WorkPrecisionRow> rows);

/// Whether the method is an integrator and no closed form.
bool goes_step_by_step(Method method);

/// Index of the fastest row with both errors ≤ tolerance; nothing if none has.
std::optional<std::size_t> cheapest_within(std::span<const WorkPrecisionRow> rows, double tolerance);

}  // namespace polhode
