// SPDX-License-Identifier: MIT
// A motion from a method of fixed step. Internal to physics/; the methods are in explicit_runge_kutta.h,
// lie_poisson_splitting.h, implicit_midpoint.h and moser_veselov.h.
//
// The grid is t = k h from the start, k of either sign; a time between grid points is one shorter step from
// the grid point towards the start. Time is never accumulated, and at(t) depends on problem, step and t alone
// (checkpoints.h). Everything is computed in the units of scaled_problem.h. The quaternion is carried as the
// method gives it and normalised only in the answer.
#pragma once

#include "physics/effort.h"
#include "physics/integrators/checkpoints.h"
#include "physics/integrators/scaled_problem.h"
#include "physics/integrators/step_arithmetic.h"
#include "physics/integrators/subnormal.h"
#include "physics/motion.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>

namespace polhode {

/// Times further than this many steps from the start are not computed: at most about 20 seconds of one core.
inline constexpr std::int64_t kMaxSteps = 100'000'000;

/// What every stepper carries from step to step; `v` is ω_B or L_B, as the stepper likes. A step it cannot
/// make leaves NaN, or q = 0 where 1/|q|² underflows, and both stay.
struct StepState {
  Triple v;
  Quadruple q;
  std::int64_t evaluations = 0;
};

/// A Stepper has
///   State: StepState, or derived from it with what the method remembers of the steps before; it must be able
///          to go on without, after State{}, and a step to a time between grid points does;
///   Plan, and plan(h): all that can be computed once for a step h of either sign;
///   start(state): State at a body's state;   w_B(State): ω_B back;
///   advance(State&, const Plan&, n): n steps, the same to the bit as n times one step.
template <class Stepper>
class FixedStepMotion final : public Motion {
 public:
  /// @throws std::domain_error if state or torque is not finite, or the step is not finite and > 0.
  FixedStepMotion(std::string_view name, const Problem& problem, double step_s, const Effort& effort = {})
      : FixedStepMotion(name, checked(problem), scaled(checked(problem)), step_s, effort) {}

  RigidBodyState at(double t_s) const override { return t_s == 0 ? start_ : answer(reached(t_s)); }

  void at(std::span<const double> t_s, std::span<RigidBodyState> states) const override {
    GridPoint last;
    for (std::size_t i = 0; i < t_s.size(); ++i)
      states[i] = t_s[i] == 0 ? start_ : answer(reached(t_s[i], last));
  }

  double max_time_s() const override { return static_cast<double>(kMaxSteps) * step_s_; }

  std::int64_t evaluations_to(double t_s) const override {
    const auto y = reached(t_s);
    return y ? y->evaluations : 0;
  }

  std::string_view method() const override { return name_; }

 private:
  using State = typename Stepper::State;
  using Plan = typename Stepper::Plan;

  // Grid points on one side of the start.
  struct Path {
    Path(const RigidBodyState& start, const FixedStepMotion& motion, double h_s)
        : plan(motion.plan(h_s)),
          grid(
              motion.stepper_.start(start),
              [this, &motion](State& y, std::int64_t n) { motion.advance(y, plan, n); }, is_alive) {}

    Plan plan;
    Checkpoints<State> grid;
  };

  struct GridPoint {
    bool is_known = false;
    bool backwards = false;
    std::int64_t k = 0;
    State y{};
  };

  FixedStepMotion(std::string_view name, const Problem& problem, const ScaledProblem& in_units, double step_s,
                  const Effort& effort)
      : name_(name),
        start_(problem.start),
        step_s_(checked_step(step_s)),
        ew_(in_units.ew),
        effort_(effort),
        stepper_(in_units.problem),
        forward_(in_units.problem.start, *this, step_s),
        backward_(in_units.problem.start, *this, -step_s) {}

  static double checked_step(double step_s) {
    if (!std::isfinite(step_s) || step_s <= 0) throw std::domain_error("the step must be finite and > 0");
    return step_s;
  }

  static bool is_alive(const State& y) { return is_finite(y.v) && is_finite(y.q) && dot(y.q, y.q) > 0; }

  Plan plan(double h_s) const { return stepper_.plan(std::scalbn(h_s, ew_)); }

  void advance(State& y, const Plan& plan, std::int64_t n) const {
    const std::int64_t before = y.evaluations;
    stepper_.advance(y, plan, n);
    if (!effort_) return;
    const bool is_dear = any_subnormal(y.v.x, y.v.y, y.v.z, y.q.s, y.q.x, y.q.y, y.q.z);
    spend(effort_, (y.evaluations - before) * (is_dear ? kSubnormalFactor : 1));
  }

  std::optional<State> reached(double t_s) const {
    GridPoint none;
    return reached(t_s, none);
  }

  std::optional<State> reached(double t_s, GridPoint& last) const {
    const double duration = std::abs(t_s);
    if (!(duration / step_s_ <= static_cast<double>(kMaxSteps))) return std::nullopt;
    const double rest = std::fmod(duration, step_s_);  // exact
    go_to(std::llround((duration - rest) / step_s_), t_s < 0, last);
    if (!last.is_known) return std::nullopt;
    return rest == 0 ? last.y : shorter_step(last.y, t_s < 0 ? -rest : rest);
  }

  // From the last grid point where that is nearer than a checkpoint can be expected to be.
  void go_to(std::int64_t k, bool backwards, GridPoint& last) const {
    constexpr std::int64_t kNear = 8;
    const Path& path = backwards ? backward_ : forward_;
    if (last.is_known && last.backwards == backwards && k >= last.k && k - last.k <= kNear) {
      advance(last.y, path.plan, k - last.k);
      last.is_known = is_alive(last.y);
    } else if (const auto y = path.grid.after(k)) {
      last.y = *y;
      last.is_known = true;
    } else {
      last.is_known = false;
    }
    last.backwards = backwards;
    last.k = k;
  }

  std::optional<State> shorter_step(const State& from, double h_s) const {
    State y{};
    static_cast<StepState&>(y) = from;  // what else it remembers is of the grid
    advance(y, plan(h_s), 1);
    return is_alive(y) ? std::optional(y) : std::nullopt;
  }

  RigidBodyState answer(const std::optional<State>& y) const {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    RigidBodyState unknown{Quat(kNaN, kNaN, kNaN, kNaN), Vec3::Constant(kNaN)};
    if (!y) return unknown;
    const Vec3 w_B = stepper_.w_B(*y).unaryExpr([this](double x) { return std::scalbn(x, ew_); });
    const Quat q_SB = quat(y->q).normalized();
    return w_B.allFinite() && q_SB.coeffs().allFinite() ? RigidBodyState{q_SB, w_B} : unknown;
  }

  std::string_view name_;
  RigidBodyState start_;
  double step_s_;
  int ew_;
  Effort effort_;
  Stepper stepper_;
  Path forward_, backward_;
};

}  // namespace polhode
