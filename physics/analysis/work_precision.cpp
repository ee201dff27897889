// SPDX-License-Identifier: MIT
#include "physics/analysis/work_precision.h"

#include "base/numbers.h"
#include "base/stopwatch.h"
#include "physics/analysis/characteristic_time.h"
#include "physics/analysis/conditioning.h"
#include "physics/analysis/motion_errors.h"
#include "physics/method.h"

#include <algorithm>
#include <cmath>

namespace polhode {

namespace {

constexpr double kLoosestTolerance = 1e-3, kTightestTolerance = 1e-13;
constexpr double kFirstStepsPerPeriod = 10;
constexpr double kFewestStepsPerTurn = 2;
// A method is tried if its longest steps are no more than these, for each second there is and at least.
constexpr double kFirstStepsPerSecond = 4e5, kFirstStepsAtLeast = 1e5;
constexpr double kTimingSeconds = 0.03;  // of one row

struct Reference {
  RigidBodyState end;
  StateError own;  // estimated
};

/// So many steps fit into the time there is, and at least.
std::int64_t most_steps(const WorkPrecisionPlan& plan) {
  return static_cast<std::int64_t>(std::max(kFirstStepsAtLeast, kFirstStepsPerSecond * plan.cpu_seconds));
}

Reference reference_of(const Problem& problem, double end_s, std::int64_t most) {
  if (problem.torque.empty()) {
    const double own = closed_form_error(problem.I, problem.start.w_B, end_s);
    return {make_motion(problem, {Method::exact})->at(end_s), {own, own}};
  }
  if (closed_form(problem) == Method::lagrange_top) {
    const double own = top_error(problem, end_s);
    return {make_motion(problem, {Method::lagrange_top})->at(end_s), {own, own}};
  }
  const auto end_with = [&](double tolerance) {
    return make_motion(problem, {Method::dormand_prince_8, {}, tolerance, most})->at(end_s);
  };
  const RigidBodyState end = end_with(kReferenceTolerance);
  if (!is_finite(end)) return {end, {}};
  return {end, error_of(end_with(10 * kReferenceTolerance), end)};
}

/// One that is itself no answer tells nothing of others.
Result<Reference> checked_reference(const Problem& problem, double end_s, std::int64_t most) {
  const bool has_end = std::isfinite(end_s);
  Reference reference = has_end ? reference_of(problem, end_s, most) : Reference{};
  const bool is_answer = reference.own.omega < kNoAnswer && reference.own.attitude_rad < kNoAnswer;
  if (!has_end || !is_finite(reference.end) || !is_answer)
    return failure("the motion cannot be computed to its end at " + digits(end_s, 6) +
                   " s: torque or time is too large; take fewer periods, or allow more seconds");
  return reference;
}

/// Settings of one method, from the fastest to the most accurate.
class Settings {
 public:
  Settings(Method method, double first_step_s, std::int64_t most_steps)
      : method_(method), first_step_s_(first_step_s), most_steps_(most_steps) {}

  /// Nothing past the last.
  std::optional<MethodChoice> operator[](int i) const {
    switch (facts_of(method_).control) {
      case StepControl::none:
        return i == 0 ? std::optional(MethodChoice{method_}) : std::nullopt;
      case StepControl::fixed:
        return MethodChoice{method_, std::ldexp(first_step_s_, -i)};
      case StepControl::adaptive:
        break;
    }
    const double tolerance = kLoosestTolerance / std::pow(10.0, i);
    if (tolerance < 0.5 * kTightestTolerance) return std::nullopt;
    return MethodChoice{method_, {}, tolerance, most_steps_};
  }

  /// What one setting costs in terms of the one before.
  double growth() const {
    const MethodFacts& facts = facts_of(method_);
    return facts.control == StepControl::fixed ? 2 : std::pow(10.0, 1.0 / std::max(facts.order, 1));
  }

 private:
  Method method_;
  double first_step_s_;
  std::int64_t most_steps_;  ///< of adaptive methods
};

/// Sees when rounding has put an end to the fall of the errors.
class Fall {
 public:
  void add(const WorkPrecisionRow& row) {
    const bool omega_fell = lower(omega_, row.error_omega);
    const bool attitude_fell = lower(attitude_, row.error_attitude_rad);
    const bool resolved = std::max(omega_, attitude_) < kNoAnswer;  // before that errors have no order
    without_ = omega_fell || attitude_fell || !resolved ? 0 : without_ + 1;
  }
  bool has_ended() const { return without_ >= 2; }

 private:
  static bool lower(double& best, double error) {
    const bool fell = error < 0.7 * best;
    if (error < best) best = error;
    return fell;
  }
  double omega_ = std::numeric_limits<double>::infinity();
  double attitude_ = std::numeric_limits<double>::infinity();
  int without_ = 0;
};

class Measurement {
 public:
  Measurement(const Problem& problem, const WorkPrecisionPlan& plan, Reference reference)
      : problem_(problem),
        plan_(plan),
        end_s_(plan.period_s * plan.periods),
        times_s_(drift_times_s(end_s_)),
        reference_(std::move(reference)) {}

  double reference_error() const { return std::max(reference_.own.omega, reference_.own.attitude_rad); }

  std::vector<WorkPrecisionRow> rows_of(Method method, double cpu_seconds) const {
    if (is_too_far(method)) return {};
    const Settings settings(method, first_step_s(), most_steps(plan_));
    const double start_s = cpu_time_s();
    std::vector<WorkPrecisionRow> rows;
    Fall fall;
    double expected_s = 0;
    for (int i = 0; i < plan_.most_settings && !fall.has_ended(); ++i) {
      const std::optional<MethodChoice> choice = settings[i];
      const bool no_time = i > 0 && cpu_time_s() - start_s + expected_s > cpu_seconds;
      if (!choice || no_time) break;
      const double row_start_s = cpu_time_s();
      rows.push_back(row_of(*choice));
      fall.add(rows.back());
      expected_s = settings.growth() * (cpu_time_s() - row_start_s);
    }
    return rows;
  }

 private:
  double first_step_s() const {
    const double turn_s = turn_time(problem_.start.w_B).value();
    double step_s = std::min(plan_.period_s / kFirstStepsPerPeriod, end_s_);
    while (step_s > turn_s / kFewestStepsPerTurn) step_s /= 2;
    return step_s;
  }

  bool is_too_far(Method method) const {
    const StepControl control = facts_of(method).control;
    if (control == StepControl::none) return false;
    const double dearer = control == StepControl::adaptive ? 5 : 1;  // several stages, several steps a turn
    return dearer * end_s_ / first_step_s() > static_cast<double>(most_steps(plan_));
  }

  WorkPrecisionRow row_of(const MethodChoice& choice) const {
    WorkPrecisionRow row{choice.method, choice.step_s, choice.tolerance};
    const double start_s = cpu_time_s();
    const auto motion = make_motion(problem_, choice);
    const RigidBodyState end = motion->at(end_s_);
    const double first_s = cpu_time_s() - start_s;

    std::vector<RigidBodyState> states(times_s_.size(), end);
    motion->at(times_s_, states);  // the way is known by now
    states.push_back(end);
    row.evaluations = motion->evaluations_to(end_s_);

    const StateError error = error_of(end, reference_.end);
    row.error_omega = not_below(reference_.own.omega, error.omega);
    row.error_attitude_rad = not_below(reference_.own.attitude_rad, error.attitude_rad);
    const InvariantDrift drift = drift_along(problem_, states);
    row.drift_T = drift.T;
    row.drift_L = drift.L;
    row.drift_L_direction_rad = drift.L_direction_rad;
    const bool is_long = 2 * first_s > kTimingSeconds;
    row.ns_per_period = (is_long ? 1e9 * first_s : repeated_cpu_ns(choice)) / plan_.periods;
    return row;
  }

  static double not_below(double floor, double error) { return error < floor ? floor : error; }

  double repeated_cpu_ns(const MethodChoice& choice) const {
    volatile double sink = 0;  // keeps the call from being optimised away
    return median_cpu_ns(kTimingSeconds,
                         [&] { sink = sink + make_motion(problem_, choice)->at(end_s_).w_B.x(); });
  }

  const Problem& problem_;
  const WorkPrecisionPlan& plan_;
  double end_s_;
  std::vector<double> times_s_;
  Reference reference_;
};

bool beats(const WorkPrecisionRow& a, const WorkPrecisionRow& b) {
  const bool as_good = a.ns_per_period <= b.ns_per_period && a.error() <= b.error();
  return as_good && (a.ns_per_period < b.ns_per_period || a.error() < b.error());
}

template <class IsAsked>
std::vector<bool> front_among(std::span<const WorkPrecisionRow> rows, IsAsked is_asked) {
  const auto is_beaten = [&](const WorkPrecisionRow& row) {
    return std::any_of(rows.begin(), rows.end(),
                       [&](const WorkPrecisionRow& other) { return is_asked(other) && beats(other, row); });
  };
  std::vector<bool> front;
  for (const WorkPrecisionRow& row : rows)
    front.push_back(is_asked(row) && row.error() < kNoAnswer && !is_beaten(row));
  return front;
}

}  // namespace

std::vector<double> drift_times_s(double end_s) {
  constexpr double kGolden = 0.6180339887498949;  // fractional parts of its multiples are spread evenly
  std::vector<double> times;
  for (int i = 1; i <= kDriftSamples; ++i) times.push_back(end_s * (i * kGolden - std::floor(i * kGolden)));
  std::sort(times.begin(), times.end());
  return times;
}

double WorkPrecisionRow::error() const {
  return std::isnan(error_omega) ? kNaN : error_attitude_rad < error_omega ? error_omega : error_attitude_rad;
}

Result<WorkPrecision> measure_work_precision(const Problem& problem, const WorkPrecisionPlan& plan,
                                             const std::function<void(std::size_t)>& progress) {
  const double start_s = cpu_time_s();
  Result<Reference> reference = checked_reference(problem, plan.period_s * plan.periods, most_steps(plan));
  if (!reference) return failure(reference.error());
  const Measurement measurement(problem, plan, std::move(reference).value());
  WorkPrecision found;
  found.reference_error = measurement.reference_error();
  for (std::size_t i = 0; i < plan.methods.size(); ++i) {
    if (progress) progress(i);
    const double left_s = std::max(0.0, plan.cpu_seconds - (cpu_time_s() - start_s));
    const auto rows = measurement.rows_of(plan.methods[i], left_s / double(plan.methods.size() - i));
    if (rows.empty()) found.out_of_reach.push_back(plan.methods[i]);
    found.rows.insert(found.rows.end(), rows.begin(), rows.end());
  }
  return found;
}

std::vector<bool> pareto_front(std::span<const WorkPrecisionRow> rows) {
  return front_among(rows, [](const WorkPrecisionRow&) { return true; });
}

std::vector<bool> front_step_by_step(std::span<const WorkPrecisionRow> rows) {
  return front_among(rows, [](const WorkPrecisionRow& row) { return goes_step_by_step(row.method); });
}

bool goes_step_by_step(Method method) { return facts_of(method).control != StepControl::none; }

std::optional<std::size_t> cheapest_within(std::span<const WorkPrecisionRow> rows, double tolerance) {
  std::optional<std::size_t> cheapest;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i].error() <= tolerance && (!cheapest || rows[i].ns_per_period < rows[*cheapest].ns_per_period))
      cheapest = i;
  return cheapest;
}

}  // namespace polhode
